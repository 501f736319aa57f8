//! Orders, energies and round-off of all solvers: `cargo study convergence --help`.

mod energy;
mod floors;
mod orders;
mod usual;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, value_parser};
use instances::simulation;
use kerchief::host::{Description, MOST, ScalarKind};

use console::{progress, staging};
use energy::{Energies, undamped};
use floors::Floors;
use laboratory::configuration::Configuration;
use laboratory::page::{Page, write_csv};
use laboratory::prepare_workers;
use laboratory::scenes::{ORDERS, named};
use orders::Orders;
use usual::usual;

/// Shows how fast every solver converges, what it does to energy, and what every number type loses to rounding.
#[derive(Debug, Parser)]
#[command(name = "convergence", version)]
struct Args {
    /// Scene files or named scenes for orders and round-off: soft ones, or else only few solvers show anything
    #[arg(default_values = ORDERS.iter().map(|scene| scene.name))]
    scenes: Vec<String>,
    /// Frames looked at; without, as many as the scene has
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    frames: Option<u32>,
    /// Solver steps per frame
    #[arg(long, value_name = "N,…", value_delimiter = ',', value_parser = value_parser!(u32).range(1..=i64::from(MOST)),
        default_values_t = [4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048])]
    substeps: Vec<u32>,
    /// The scene whose energy is watched, without its drag and wind
    #[arg(long, value_name = "SCENE", default_value = "two-corners-16")]
    energy_scene: String,
    /// How long its energy is watched, s
    #[arg(long, value_name = "S", allow_negative_numbers = true, default_value_t = 4.0, value_parser = console::positive)]
    seconds: f64,
    /// Solver steps per frame while it is; leapfrog takes sixteen times as many, because it is stable for small steps only
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 8, value_parser = value_parser!(u32).range(1..=i64::from(MOST / 16)))]
    energy_substeps: u32,
    /// Where the page, its plots and tables go
    #[arg(long, value_name = "DIR", default_value = "out/convergence")]
    out: PathBuf,
    /// Where reference solutions are kept
    #[arg(long, value_name = "DIR", default_value = "out/references")]
    cache: PathBuf,
}

fn main() -> ExitCode {
    console::exit(console::read().and_then(|args: Args| run(&args)))
}

fn run(args: &Args) -> Result<(), String> {
    let named = named();
    let load = |name: &String| console::load(name, &named);
    let scenes: Vec<(String, Description)> = args.scenes.iter().map(load).collect::<Result<_, _>>()?;
    let (_, swinging) = load(&args.energy_scene)?;
    let swinging = undamped(&swinging)?;
    for (_, scene) in &scenes {
        let fewest = args.substeps.iter().min();
        for (scalar, &substeps) in
            ScalarKind::ALL.into_iter().flat_map(|scalar| args.substeps.iter().map(move |n| (scalar, n)))
        {
            // A number type may refuse shorter steps: only its fewest substeps have to be accepted.
            if scalar != ScalarKind::F64 && Some(&substeps) != fewest {
                continue;
            }
            let fits = |of: Configuration| simulation(&of.of(scene), scalar).map(drop);
            usual(scalar, substeps).try_for_each(fits).map_err(|error| format!("{}: {error}", scene.name))?;
        }
    }
    staging::prepare(&args.out)?;
    prepare_workers()?;
    let mut substeps = args.substeps.clone();
    substeps.sort_unstable();
    substeps.dedup();

    let bar = progress("runs", 0);
    let mut page = Page::default();
    page.paragraph("# Convergence");
    let mut found = Vec::new();
    for (text, scene) in &scenes {
        let frames = args.frames.unwrap_or(scene.frames);
        let orders = Orders::of(text, scene, frames, &substeps, &args.cache, &bar)?;
        orders.report(&mut page, &args.out)?;
        Floors::of(scene, &orders, &bar)?.report(&mut page, &args.out)?;
        found.push(orders);
    }
    let rows: Vec<_> = found.iter().flat_map(Orders::rows).collect();
    write_csv(&args.out, "orders.csv", &rows)?;
    let frames = (args.seconds / swinging.solver.step).round().max(1.0) as u32;
    Energies::of(&swinging, frames, args.energy_substeps, &bar)?.report(&mut page, &args.out)?;
    bar.finish_and_clear();
    page.write(&args.out, "convergence.md")?;
    console::say(&format!("written to {}", args.out.display()));
    Ok(())
}
