//! Runs a scene of cloth on the host: `cargo run --release --example simulate -- --help`.

mod animation;
mod args;
mod pictures;
mod report;
mod staging;
#[path = "../studio/mod.rs"]
mod studio;
#[cfg(feature = "window")]
mod window;

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use std::{fs, io};

use indicatif::{ProgressBar, ProgressStyle};
use kerchief::host::{BUILT_IN, Description, Still, built_in};

use args::Args;
use pictures::Album;
use report::Watch;
use staging::Staged;

fn main() -> ExitCode {
    match Args::read().and_then(|args| run(&args)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            // Nobody left to tell is no reason to panic.
            let _ = writeln!(io::stderr(), "error: {line}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &Args) -> Result<(), String> {
    let mut scene = load(&args.scene)?;
    args.override_scene(&mut scene);
    if args.window {
        #[cfg(feature = "window")]
        return window::run(scene, args.scalar);
        #[cfg(not(feature = "window"))]
        return Err("--window: built without the cargo feature `window`; add --features window".to_string());
    }
    let mut simulation = scene.simulation(args.scalar).map_err(|error| format!("{}: {error}", args.scene))?;
    staging::prepare(&args.out)?;
    let mut album = (args.animation() || args.png).then(|| Album::new(&scene));
    let mut positions = args.csv.then(|| Positions::create(&args.out)).transpose()?;
    let mut record = |frame, still: Still| {
        if let Some(positions) = &mut positions {
            positions.record(frame, &still, scene.sheet.columns)?;
        }
        if let Some(album) = &mut album {
            album.add(frame, still);
        }
        Ok::<_, String>(())
    };

    let mut watch = Watch::start(&*simulation);
    record(0, simulation.still())?;
    let bar = progress("frames", u64::from(scene.frames));
    for frame in 1..=scene.frames {
        let start = Instant::now();
        simulation.frame();
        watch.frame(&*simulation, start.elapsed());
        if frame % args.every == 0 || frame == scene.frames {
            record(frame, simulation.still())?;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let report = watch.report(&*simulation, &scene, args.scalar);

    if let Some(album) = album {
        if args.animation() {
            let bar = progress("pictures", 0);
            album.write_animation(&args.out, &bar)?;
            bar.finish_and_clear();
        }
        if args.png {
            let bar = progress("pictures", 0);
            album.write_pictures(&args.out, &bar)?;
            bar.finish_and_clear();
        }
    }
    if let Some(positions) = positions {
        positions.finish()?;
    }
    let mut file = Staged::create(&args.out, "report.json")?;
    let json = serde_json::to_string_pretty(&report).map_err(|error| error.to_string())?;
    let written = writeln!(file, "{json}");
    file.named(written)?;
    file.finish()?;
    let _ = writeln!(io::stdout(), "{report}\nwritten to        {}", args.out.display());
    Ok(())
}

/// The scene of that name, or in that file.
fn load(scene: &str) -> Result<Description, String> {
    let text = match built_in(scene) {
        Some(scene) => scene.text.to_string(),
        None => fs::read_to_string(scene).map_err(|error| {
            if error.kind() == io::ErrorKind::NotFound && !scene.contains(['.', '/', '\\']) {
                let names: Vec<_> = BUILT_IN.iter().map(|scene| scene.name).collect();
                format!("no scene or file {scene:?}; built-in scenes: {}", names.join(", "))
            } else {
                format!("{scene}: {error}")
            }
        })?,
    };
    let mut description = Description::parse(&text).map_err(|error| format!("{scene}: {error}"))?;
    if description.name.is_empty() {
        description.name = Path::new(scene).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    }
    Ok(description)
}

/// A bar on stderr; none where that is no terminal.
fn progress(what: &'static str, length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:>8} {wide_bar} {pos}/{len} {eta}").expect("a template");
    ProgressBar::new(length).with_style(style).with_message(what)
}

/// `positions.csv`.
struct Positions(csv::Writer<Staged>);

impl Positions {
    fn create(directory: &Path) -> Result<Self, String> {
        let mut table = Self(csv::Writer::from_writer(Staged::create(directory, "positions.csv")?));
        table.write(("frame", "column", "row", "x", "y", "z"))?;
        Ok(table)
    }

    fn record(&mut self, frame: u32, still: &Still, columns: usize) -> Result<(), String> {
        let mut particles = still.positions.iter().enumerate();
        particles.try_for_each(|(index, [x, y, z])| self.write((frame, index % columns, index / columns, x, y, z)))
    }

    fn write(&mut self, row: impl serde::Serialize) -> Result<(), String> {
        let result = self.0.serialize(row);
        self.0.get_ref().named(result)
    }

    fn finish(self) -> Result<(), String> {
        self.0.into_inner().map_err(|error| error.to_string())?.finish()
    }
}
