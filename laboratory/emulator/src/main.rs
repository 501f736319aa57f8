//! Runs a board's program in an emulator. Its log appears on the terminal, its display in a file.
//!
//! ```sh
//! cargo emulate oled --png oled.png
//! ```
#![allow(missing_docs, reason = "a program")]

mod progress;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use emulator::board::lcd::{self, Run};
use emulator::board::{feather, microbit, oled, pico, ssd1306, tilt};
use emulator::qemu::Qemu;
use emulator::{Firmware, Result, film, footprint, photograph};
use image::{Rgb, RgbImage};

use progress::Progress;

/// Runs a board's program in an emulator.
#[derive(Debug, Parser)]
struct Arguments {
    board: Board,
    /// Steps of the simulation.
    #[arg(long, default_value_t = 120)]
    steps: u32,
    /// PNG file for the display, replaced after every picture.
    #[arg(long)]
    png: Option<PathBuf>,
    /// GIF file for an animation of the last ten seconds (pico) or of the whole gesture (tilt).
    #[arg(long)]
    gif: Option<PathBuf>,
    /// Model the flash cache: a miss costs cycles (pico, tilt).
    #[arg(long)]
    cached: bool,
    /// An instruction takes 2 to the power of this many nanoseconds.
    #[arg(long, default_value_t = 0)]
    shift: u32,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Board {
    /// STM32F405, a table over the serial port, in QEMU
    Feather,
    /// BBC micro:bit, 5 × 5 LEDs, in QEMU
    Microbit,
    /// LM3S6965 evaluation board, OLED of 128 × 64 pixels, in QEMU
    Oled,
    /// Raspberry Pi Pico, LCD of 240 × 240 pixels, in rp2040js
    Pico,
    /// Raspberry Pi Pico, OLED of 128 × 64 pixels on I2C, in rp2040js
    Ssd1306,
    /// Waveshare RP2040-LCD-1.28, round LCD and an accelerometer that measures a gesture, in rp2040js
    Tilt,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("emulate: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<()> {
    let program = build(match arguments.board {
        Board::Feather => &feather::FIRMWARE,
        Board::Microbit => &microbit::FIRMWARE,
        Board::Oled => &oled::FIRMWARE,
        Board::Pico => &pico::FIRMWARE,
        Board::Ssd1306 => &ssd1306::FIRMWARE,
        Board::Tilt => &tilt::FIRMWARE,
    })?;
    let [flash, ram] = footprint::of(&program)?;
    println!("{flash} bytes of flash, {ram} bytes of RAM and the stack");
    match arguments.board {
        Board::Feather => feather::run(&program, |line| println!("{line}")),
        Board::Microbit => run_microbit(&program, arguments),
        Board::Oled => run_oled(&program, arguments),
        Board::Pico => run_pico(&program, arguments),
        Board::Ssd1306 => run_ssd1306(&program, arguments),
        Board::Tilt => run_tilt(&program, arguments),
    }
}

/// Builds a program for its only target.
fn build(firmware: &Firmware<'_>) -> Result<PathBuf> {
    let progress = Progress::lines(&format!("building {}", firmware.package));
    let programs = firmware.build_aloud(|line| progress.line(line))?;
    programs.into_values().next().ok_or_else(|| "no program".into())
}

fn run_microbit(program: &Path, arguments: &Arguments) -> Result<()> {
    let mut board = microbit::start(program)?;
    let progress = Progress::steps(arguments.steps);
    loop {
        let step = board.picture()?;
        progress.step(step);
        let levels = microbit::levels(&mut board)?;
        if let Some(path) = &arguments.png {
            save(&microbit::photograph(&levels), path)?;
        }
        if step >= arguments.steps {
            drop(progress);
            board.log()?.iter().for_each(|line| println!("{line}"));
            return end(&mut board);
        }
    }
}

/// Prints the stack usage and fails if the emulator found errors.
fn end(board: &mut Qemu) -> Result<()> {
    let [used, size] = board.stack()?;
    println!("{used} of {size} bytes of stack were used");
    let errors = board.errors()?;
    if errors.is_empty() { Ok(()) } else { Err(errors.into()) }
}

fn run_oled(program: &Path, arguments: &Arguments) -> Result<()> {
    let mut board = Qemu::start(oled::MACHINE, None, program, arguments.shift)?;
    let mut logged = 0;
    let progress = Progress::steps(arguments.steps);
    loop {
        let step = board.picture()?;
        progress.step(step);
        let log = board.log()?;
        log[logged..].iter().for_each(|line| progress.print(line));
        logged = log.len();
        let last = step >= arguments.steps;
        if let Some(path) = &arguments.png {
            let greys = oled::greys(&mut board)?;
            let picture = RgbImage::from_fn(greys.width(), greys.height(), |x, y| {
                let grey = u16::from(greys.get_pixel(x, y)[0]) * 17;
                // OLEDs of this kind are slightly yellow
                Rgb([255, 240, 190].map(|part| (grey * part / 255) as u8))
            });
            save(&photograph::photograph(&picture, 5, 1), path)?;
        }
        if last {
            drop(progress);
            return end(&mut board);
        }
    }
}

fn run_pico(program: &Path, arguments: &Arguments) -> Result<()> {
    // browsers don't play sixty pictures a second
    const STRIDE: usize = 3;
    const SECONDS: u32 = 10;
    let steps = arguments.steps as usize;
    let first = steps.saturating_sub((SECONDS * ::pico::show::RATE) as usize);
    let shots = if arguments.gif.is_some() { (first..=steps).step_by(STRIDE).skip(1).collect() } else { Vec::new() };
    let plan = pico::Plan { until: Some(arguments.steps), shots, presses: Vec::new(), cached: arguments.cached };
    let progress = Progress::steps(arguments.steps);
    let run = pico::run(program, &plan, |step| progress.step(step))?;
    drop(progress);
    end_lcd(&run)?;
    if let (Some(path), Some(last)) = (&arguments.png, run.shots.last()) {
        save(&photograph::photograph(&lcd::picture(last), 2, 0), path)?;
    }
    if let Some(path) = &arguments.gif {
        let pictures: Vec<_> = shown(&run, &plan.shots).map(|(step, shot)| (step, lcd::picture(shot))).collect();
        film::save(&pictures, STRIDE as u32, ::pico::show::RATE, path)?;
    }
    Ok(())
}

/// The shots of these pictures (counted from one), each with the step that it shows.
fn shown<'a>(run: &'a Run, pictures: &'a [usize]) -> impl Iterator<Item = (u32, &'a Vec<u16>)> {
    pictures.iter().filter_map(|picture| run.steps.get(picture - 1)).copied().zip(&run.shots)
}

/// Prints the log and the stack usage, and fails if the run has errors.
fn end_lcd(run: &Run) -> Result<()> {
    run.log.iter().for_each(|line| println!("{line}"));
    let [used, size] = run.stack;
    println!("{used} of {size} bytes of stack were used");
    if run.errors.is_empty() { Ok(()) } else { Err(run.errors.join("\n").into()) }
}

fn run_tilt(program: &Path, arguments: &Arguments) -> Result<()> {
    /// One picture in three is filmed: about fifteen a second.
    const STRIDE: usize = 3;
    /// Steps for which the film's last picture stays.
    const REST: u32 = ::tilt::show::RATE;
    /// A gap of at least this many steps between two pictures means that the kerchief rested.
    const GAP: u32 = 6;
    // more pictures than a run can have
    const MOST: usize = 10_000;
    let filmed = arguments.gif.is_some();
    let shots: Vec<_> = if filmed { (1..MOST).step_by(STRIDE).collect() } else { Vec::new() };
    let until = (!filmed).then_some(arguments.steps);
    let plan = tilt::Plan { until, shots: Some(shots), cached: arguments.cached, ..tilt::Plan::default() };
    let progress = Progress::steps(arguments.steps);
    let run = tilt::run(program, &plan, |step| progress.step(step))?;
    drop(progress);
    end_lcd(&run)?;
    if let (Some(path), Some(last)) = (&arguments.png, run.shots.last()) {
        save(&photograph::photograph(&tilt::picture(last), 2, 0), path)?;
    }
    if let Some(path) = &arguments.gif {
        // the film starts when the rest on the table ends: earlier pictures show the kerchief settling
        let starts = run.steps.windows(2).filter(|steps| steps[1] >= steps[0] + GAP).map(|steps| steps[1]);
        let start = starts.min().unwrap_or(0);
        let pictures = shown(&run, plan.shots.as_deref().unwrap_or_default()).filter(|(step, _)| *step >= start);
        let pictures: Vec<_> = pictures.map(|(step, shot)| (step, tilt::picture(shot))).collect();
        film::save(&pictures, REST, ::tilt::show::RATE, path)?;
    }
    Ok(())
}

fn run_ssd1306(program: &Path, arguments: &Arguments) -> Result<()> {
    let progress = Progress::steps(arguments.steps);
    let run = ssd1306::run(program, arguments.steps, |step| progress.step(step))?;
    drop(progress);
    println!("{:.0} ms for {} pictures", run.milliseconds, arguments.steps);
    if !run.errors.is_empty() {
        return Err(run.errors.join("\n").into());
    }
    if let Some(path) = &arguments.png {
        save(&photograph::photograph(&run.picture(), 5, 1), path)?;
    }
    Ok(())
}

/// Replaces the file in one operation, so that a viewer never reads half a picture.
fn save(picture: &RgbImage, path: &Path) -> Result<()> {
    let new = path.with_extension("new.png");
    picture.save(&new)?;
    Ok(std::fs::rename(new, path)?)
}
