//! Effects of grid and material on the result: `cargo study discretisation --help`.

mod awning;
mod grids;
mod parameters;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, value_parser};
use kerchief::host::MOST;

use awning::Awning;
use console::{progress, staging};
use grids::Grids;
use laboratory::page::Page;
use laboratory::prepare_workers;
use parameters::Parameters;

/// The same physical sheet on finer and finer grids, and with one property changed at a time.
#[derive(Debug, Parser)]
#[command(name = "discretisation", version)]
struct Args {
    /// Particles a side
    #[arg(long, value_name = "N,…", value_delimiter = ',', value_parser = side, default_values_t = [8, 12, 16, 24, 32, 48, 64])]
    sides: Vec<usize>,
    /// Particles a side of the sheet whose properties change
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = side, default_value_t = 24)]
    side: usize,
    /// How long the sheet has to come to rest, s
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = console::positive, default_value_t = 3.0)]
    seconds: f64,
    /// Solver steps per frame of 1/50 s
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 8, value_parser = value_parser!(u32).range(1..=i64::from(MOST / 4)))]
    substeps: u32,
    /// Where the page, its plots, pictures and tables go
    #[arg(long, value_name = "DIR", default_value = "out/discretisation")]
    out: PathBuf,
}

fn side(text: &str) -> Result<usize, String> {
    let sides: Vec<_> = kerchief::host::SHAPES.iter().filter(|(columns, rows)| columns == rows && *rows > 4).collect();
    let side = text.parse().ok().filter(|side| sides.iter().any(|(columns, _)| columns == side));
    side.ok_or_else(|| {
        format!("one of {}", sides.iter().map(|(side, _)| side.to_string()).collect::<Vec<_>>().join(", "))
    })
}

fn main() -> ExitCode {
    console::exit(console::read().and_then(|args: Args| run(&args)))
}

fn run(args: &Args) -> Result<(), String> {
    let mut sides = args.sides.clone();
    sides.sort_unstable();
    sides.dedup();
    if sides.len() < 2 {
        return Err("--sides: at least two grids are compared".to_string());
    }
    staging::prepare(&args.out)?;
    prepare_workers()?;
    let awning = Awning { substeps: args.substeps, seconds: args.seconds, ..Awning::default() };
    let bar = progress("sheets", 0);
    let mut page = Page::default();
    page.paragraph("# Grid and material");
    page.paragraph(&awning.words());
    Grids::of(awning, &sides, &bar)?.report(&mut page, &args.out)?;
    Parameters::of(awning, args.side, &bar)?.report(&mut page, &args.out)?;
    bar.finish_and_clear();
    page.write(&args.out, "discretisation.md")?;
    console::say(&format!("written to {}", args.out.display()));
    Ok(())
}
