//! The cost of accuracy on a board: `cargo study board_precision --help`.

mod board;
mod report;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Parser;
use kerchief::host::ScalarKind;
use rayon::prelude::*;

use board::{BOARDS, Point, errors};
use console::{progress, say, staging};
use laboratory::page::{Page, write_csv};
use laboratory::prepare_workers;

/// Counts, on emulated boards, the instructions of a sheet solved in many ways, and puts the errors against them.
#[derive(Debug, Parser)]
#[command(name = "board_precision", version)]
struct Args {
    /// Where the page, its plots and the table of all points go
    #[arg(long, value_name = "DIR", default_value = "out/board_precision")]
    out: PathBuf,
    /// Where reference solutions are kept
    #[arg(long, value_name = "DIR", default_value = "out/references")]
    cache: PathBuf,
}

/// The number types of the firmware.
const NUMBERS: [ScalarKind; 3] = [ScalarKind::F32, ScalarKind::Q24, ScalarKind::Q13];

fn main() -> ExitCode {
    console::exit(console::read().and_then(|args: Args| run(&args)))
}

fn run(args: &Args) -> Result<(), String> {
    board::tools()?;
    staging::prepare(&args.out)?;
    prepare_workers()?;
    let bar = progress("runs", (NUMBERS.len() * BOARDS.len()) as u64);
    let mut runs = Vec::new();
    for number in NUMBERS {
        let programs = Arc::new(board::programs(number)?);
        runs.extend(BOARDS.map(|board| (board, Arc::clone(&programs))));
    }
    let costs = runs.into_par_iter().map(|(board, programs)| {
        let costs = board.costs(&programs);
        bar.inc(1);
        costs
    });
    let costs = costs.collect::<Result<Vec<_>, _>>()?.concat();
    let points = errors(&costs, &args.cache)?;
    bar.finish_and_clear();
    let mut page = Page::default();
    report::report(&points, &mut page, &args.out)?;
    page.write(&args.out, "board_precision.md")?;
    let rows: Vec<_> = points.iter().map(Point::row).collect();
    write_csv(&args.out, "board_precision.csv", &rows)?;
    say(&format!("written to {}", args.out.display()));
    Ok(())
}
