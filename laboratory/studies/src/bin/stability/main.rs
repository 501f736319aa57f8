//! Stability limits of the solvers: `cargo study stability --help`.

mod experiment;
mod heat;
mod map;
mod verdict;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, value_parser};
use kerchief::host::{ScalarKind, SolverKind};

use console::{progress, scalar_kind, solver_kind, staging};
use laboratory::page::{Page, write_csv};
use laboratory::prepare_workers;
use map::{MAPS, Map, Setting};

/// Maps of strain and energy over what makes solvers fail, for every solver and number type.
#[derive(Debug, Parser)]
#[command(name = "stability", version)]
struct Args {
    /// Solvers
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_parser = solver_kind(), default_values = SolverKind::ALL.map(SolverKind::name))]
    solvers: Vec<SolverKind>,
    /// Number types
    #[arg(long, value_name = "TYPE,…", value_delimiter = ',', value_parser = scalar_kind(), default_values = ScalarKind::ALL.map(ScalarKind::name))]
    scalars: Vec<ScalarKind>,
    /// Values along each axis of a map
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 10, value_parser = value_parser!(u32).range(2..=99))]
    points: u32,
    /// Frames of a run of one substep each; of a run whose frames have several, a quarter
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 240, value_parser = value_parser!(u32).range(1..=100_000))]
    frames: u32,
    /// The most particles a side
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 128, value_parser = value_parser!(u32).range(8..=128))]
    most: u32,
    /// Where the page, its maps and tables go
    #[arg(long, value_name = "DIR", default_value = "out/stability")]
    out: PathBuf,
}

fn main() -> ExitCode {
    console::exit(console::read().and_then(|args: Args| run(&args)))
}

fn run(args: &Args) -> Result<(), String> {
    staging::prepare(&args.out)?;
    prepare_workers()?;
    let setting = Setting {
        solvers: &args.solvers,
        scalars: &args.scalars,
        points: args.points,
        frames: args.frames,
        most: args.most,
    };
    let bar = progress("runs", MAPS.iter().map(|map| map.runs(&setting)).sum());
    let maps: Vec<Map> = MAPS.iter().map(|plan| plan.explore(&setting, &bar)).collect::<Result<_, _>>()?;
    bar.finish_and_clear();
    let mut page = Page::default();
    page.paragraph("# Stability");
    page.paragraph(&experiment::words(args.frames));
    verdict::report(&maps, &mut page);
    for map in &maps {
        map.report(&mut page, &args.out)?;
    }
    let rows: Vec<_> = maps.iter().flat_map(Map::rows).collect();
    write_csv(&args.out, "stability.csv", &rows)?;
    page.write(&args.out, "stability.md")?;
    console::say(&format!("written to {}", args.out.display()));
    Ok(())
}
