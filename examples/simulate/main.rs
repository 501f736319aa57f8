//! Runs a scene of cloth on the host: `cargo run --release --example simulate -- --help`.

mod animation;
mod args;
mod meshes;
mod pictures;
mod report;
mod spool;
#[cfg(feature = "window")]
mod window;

use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use instances::simulation;
use kerchief::host::{BUILT_IN, Still};

use args::Args;
use console::staging::{self, Complete, Staged};
use console::{Failure, printable, progress};
use meshes::Meshes;
use pictures::Album;
use report::Watch;

fn main() -> ExitCode {
    console::exit(console::read().map_err(Failure::Refused).and_then(|args: Args| run(&args)))
}

fn run(args: &Args) -> Result<(), Failure> {
    let (_, mut scene) = console::load(&args.scene, BUILT_IN)?;
    args.override_scene(&mut scene);
    if args.window {
        #[cfg(feature = "window")]
        return Ok(window::run(&scene, args.scalar)?);
        #[cfg(not(feature = "window"))]
        return Err("--window: built without the cargo feature `window`; add --features window".to_string().into());
    }
    let mut simulation =
        simulation(&scene, args.scalar).map_err(|error| format!("{}: {error}", args.scene.display()))?;
    staging::prepare(&args.out)?;
    let draws = args.animation() || args.png;
    let mut album = draws.then(|| Album::new(&scene, &args.out, args.animation(), args.png)).transpose()?;
    // Created before anything is computed: it fails if a directory has this name.
    let mut report_file = Staged::create(&args.out, "report.json")?;
    let mut positions = args.csv.then(|| Positions::create(&args.out)).transpose()?;
    let mut meshes = args.obj.then(|| Meshes::new(&scene, &args.out));
    let mut record = |frame, still: Still| {
        if let Some(meshes) = &mut meshes {
            meshes.record(frame, &still)?;
        }
        if let Some(positions) = &mut positions {
            positions.record(frame, &still, scene.sheet.columns)?;
        }
        if let Some(album) = &mut album {
            album.add(frame, &still)?;
        }
        Ok::<_, String>(())
    };

    let mut watch = Watch::start(&*simulation, args.intersections);
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

    let mut files = match album {
        Some(album) => album.develop(&progress("pictures", 0))?,
        None => Vec::new(),
    };
    files.extend(meshes.into_iter().flat_map(Meshes::complete));
    if let Some(positions) = positions {
        files.push(positions.complete()?);
    }
    let json = serde_json::to_string_pretty(&report).map_err(|error| error.to_string())?;
    let written = writeln!(report_file, "{json}");
    report_file.named(written)?;
    files.push(report_file.complete()?);
    staging::finish(files)?;
    let out = args.out.display().to_string();
    let _ = writeln!(io::stdout(), "{report}\nwritten to        {}", printable(&out));
    report.explosion().map_or(Ok(()), |explosion| Err(Failure::Exploded(explosion)))
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

    fn complete(mut self) -> Result<Complete, String> {
        let written = self.0.flush();
        self.0.get_ref().named(written)?;
        self.0.into_inner().map_err(|error| error.to_string())?.complete()
    }
}
