//! Runs a board's program in an emulator: what it says appears here, its display in a file.
//!
//! ```sh
//! cargo emulate oled --png oled.png
//! ```
#![allow(missing_docs, reason = "a program")]

mod progress;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use emulator::board::{feather, microbit, oled, pico, ssd1306};
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
    /// Where the display is drawn, anew after every picture.
    #[arg(long)]
    png: Option<PathBuf>,
    /// Where an animation of the last ten seconds is written (pico).
    #[arg(long)]
    gif: Option<PathBuf>,
    /// What is read from the flash comes through a model of its cache (pico).
    #[arg(long)]
    cached: bool,
    /// The time of an instruction is 2 to the power of this, in nanoseconds.
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
    })?;
    let [flash, ram] = footprint::of(&program)?;
    println!("{flash} bytes of flash, {ram} bytes of RAM and the stack");
    match arguments.board {
        Board::Feather => feather::run(&program, |line| println!("{line}")),
        Board::Microbit => run_microbit(&program, arguments),
        Board::Oled => run_oled(&program, arguments),
        Board::Pico => run_pico(&program, arguments),
        Board::Ssd1306 => run_ssd1306(&program, arguments),
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

/// Says how much stack was used, and what was wrong.
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
                // an OLED of this kind is a little yellow
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
    // browsers don't show sixty pictures a second
    const STRIDE: usize = 3;
    const SECONDS: u32 = 10;
    let steps = arguments.steps as usize;
    let first = steps.saturating_sub((SECONDS * ::pico::show::RATE) as usize);
    let shots = if arguments.gif.is_some() { (first..=steps).step_by(STRIDE).skip(1).collect() } else { Vec::new() };
    let plan = pico::Plan { until: Some(arguments.steps), shots, presses: Vec::new(), cached: arguments.cached };
    let progress = Progress::steps(arguments.steps);
    let run = pico::run(program, &plan, |step| progress.step(step))?;
    drop(progress);
    run.log.iter().for_each(|line| println!("{line}"));
    let [used, size] = run.stack;
    println!("{used} of {size} bytes of stack were used");
    if !run.errors.is_empty() {
        return Err(run.errors.join("\n").into());
    }
    if let (Some(path), Some(last)) = (&arguments.png, run.shots.last()) {
        save(&photograph::photograph(&pico::picture(last), 2, 0), path)?;
    }
    if let Some(path) = &arguments.gif {
        film::save(&run.shots, STRIDE as u32, ::pico::show::RATE, path)?;
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

/// Replaces the file at once, so that who looks at it sees a whole picture.
fn save(picture: &RgbImage, path: &Path) -> Result<()> {
    let new = path.with_extension("new.png");
    picture.save(&new)?;
    Ok(std::fs::rename(new, path)?)
}
