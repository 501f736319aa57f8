//! The cost of accuracy: `cargo study work_precision --help`.

mod callgrind;
mod cost;
mod lean;
mod study;
mod verdict;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, ValueEnum, value_parser};
use kerchief::host::{MOST, ScalarKind, SolverKind};

use console::{positive, progress, say, scalar_kind, solver_kind, staging};
use laboratory::configuration::Choice;
use laboratory::page::{self, Page};
use laboratory::prepare_workers;
use laboratory::scenes::{GOALS, STRAIN_ONLY, named};
use study::{Study, Subject};
use verdict::Wishes;

/// Runs scenes in many ways and puts their error and strain against what they cost.
#[derive(Debug, Parser)]
#[command(name = "work_precision", version)]
struct Args {
    /// Scene files or named scenes; without any, the scenes of the solver's goals
    scenes: Vec<String>,
    /// Solvers to compare
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_parser = solver_kind(), default_values = SolverKind::ALL.map(SolverKind::name))]
    solvers: Vec<SolverKind>,
    /// Number types to compare
    #[arg(long, value_name = "TYPE,…", value_delimiter = ',', value_parser = scalar_kind(), default_values = ScalarKind::ALL.map(ScalarKind::name))]
    scalars: Vec<ScalarKind>,
    /// Solver steps per frame
    #[arg(long, value_name = "N,…", value_delimiter = ',', value_parser = value_parser!(u32).range(1..=i64::from(MOST)),
        default_values_t = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256])]
    substeps: Vec<u32>,
    /// Sweeps per substep, of every solver that has them; without, what is usual for each
    #[arg(long, value_name = "N,…", value_delimiter = ',', value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    sweeps: Vec<u32>,
    /// Strains of a row for which the line solver sweeps again
    #[arg(long = "tolerance", value_name = "X,…", value_delimiter = ',', default_values_t = [0.1, 0.02, 0.005, 0.001], value_parser = positive)]
    tolerances: Vec<f64>,
    /// The most substeps × sweeps in a frame, a sweep of lines counting as 2 and a Newton step as 64; what has more is left out. Without, 256 in runs of 20 frames and
    /// accordingly fewer in longer ones
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(1..=i64::from(MOST)))]
    work: Option<u32>,
    /// How long the motion is looked at, s; without, as long as the scene runs but no longer than 2 s where position errors are measured
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = positive)]
    seconds: Option<f64>,
    /// How far the reference may be from its limit, sheet sizes
    #[arg(long, value_name = "X", default_value_t = 2e-6, value_parser = positive)]
    reference_error: f64,
    /// Measure strain alone, without a reference
    #[arg(long)]
    strain_only: bool,
    /// Position errors (sheet sizes) for which the cheapest configuration is named
    #[arg(long = "error", value_name = "X,…", value_delimiter = ',', default_values_t = [1e-2, 1e-3, 1e-4], value_parser = positive)]
    errors: Vec<f64>,
    /// Strains for which the cheapest configuration is named
    #[arg(long = "strain", value_name = "X,…", value_delimiter = ',', default_values_t = [1e-1, 1e-2, 1e-3], value_parser = positive)]
    strains: Vec<f64>,
    /// Costs per particle and frame for which the best configuration is named
    #[arg(long = "budget", value_name = "N,…", value_delimiter = ',', value_parser = positive)]
    budgets: Vec<f64>,
    /// What cost is: counted instructions need valgrind
    #[arg(long, value_enum)]
    cost: Option<Cost>,
    /// Where the page, its plots and the table of all points go
    #[arg(long, value_name = "DIR", default_value = "out/work_precision")]
    out: PathBuf,
    /// Where reference solutions are kept
    #[arg(long, value_name = "DIR", default_value = "out/references")]
    cache: PathBuf,
}

/// Introduction of the page.
const WORDS: &str = "*Error* is the RMS distance of all particles from a converged solution at the ends of all frames, over the sheet's size. *Strain* is the \
    largest strain of any stretch link at the end of any frame. *Operations* (additions, products, quotients, roots, comparisons of numbers) are counted in \
    `f32`, in frames a quarter, a half and three quarters into the run. *Instructions* are those of x86-64. Callgrind counts them in the second frame, at two numbers of \
    substeps for each solver, number type and number of sweeps. At other numbers of substeps they are estimated from the operations.";

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Cost {
    Instructions,
    Operations,
}

fn main() -> ExitCode {
    console::exit(callgrind::answer().unwrap_or_else(|| console::read().and_then(|args: Args| run(&args))))
}

fn run(args: &Args) -> Result<(), String> {
    let subjects = args.subjects()?;
    let callgrind = match args.cost {
        Some(Cost::Operations) => false,
        Some(Cost::Instructions) if !callgrind::is_there() => {
            return Err("--cost instructions: valgrind is not there (Debian's package `valgrind`)".to_string());
        }
        Some(Cost::Instructions) => true,
        None => callgrind::is_there(),
    };
    for subject in &subjects {
        subject.check(&args.choice(subject.frames), callgrind)?;
    }
    staging::prepare(&args.out)?;
    prepare_workers()?;
    if !callgrind && args.cost.is_none() {
        say("valgrind is not there: cost is operations, not instructions");
    }
    let bar = progress("runs", 0);
    let mut studies = Vec::new();
    for subject in &subjects {
        studies.push(subject.study(&args.choice(subject.frames), callgrind, &args.cache, &bar)?);
    }
    bar.finish_and_clear();
    args.write(&studies)?;
    for study in &studies {
        say(&study.advice(&args.wishes()));
    }
    say(&format!("written to {}", args.out.display()));
    Ok(())
}

impl Args {
    fn subjects(&self) -> Result<Vec<Subject>, String> {
        let named = named();
        let all = || GOALS.iter().map(|scene| scene.name.to_string()).collect();
        let scenes = if self.scenes.is_empty() { all() } else { self.scenes.clone() };
        let subject = |name: &String| {
            let (text, scene) = console::load(name, &named)?;
            let strain_only = self.strain_only || STRAIN_ONLY.contains(&scene.name.as_str());
            let seconds = self.seconds.unwrap_or(if strain_only { f64::INFINITY } else { 2.0 });
            let most = (seconds / scene.solver.step).round().max(1.0);
            let frames = if self.seconds.is_some() { most as u32 } else { scene.frames.min(most as u32) };
            Ok(Subject { text, scene, frames, tolerance: (!strain_only).then_some(self.reference_error) })
        };
        scenes.iter().map(subject).collect()
    }

    fn choice(&self, frames: u32) -> Choice {
        Choice {
            solvers: self.solvers.clone(),
            scalars: self.scalars.clone(),
            substeps: self.substeps.clone(),
            sweeps: self.sweeps.clone(),
            tolerances: self.tolerances.clone(),
            work: self.work.unwrap_or((20 * 256 / frames).clamp(16, 256)),
        }
    }

    fn wishes(&self) -> Wishes {
        Wishes { errors: self.errors.clone(), strains: self.strains.clone(), budgets: self.budgets.clone() }
    }

    fn write(&self, studies: &[Study]) -> Result<(), String> {
        let mut page = Page::default();
        page.paragraph("# Error against cost");
        page.paragraph(WORDS);
        for study in studies {
            study.report(&self.wishes(), &mut page, &self.out)?;
        }
        page.write(&self.out, "work_precision.md")?;
        let rows: Vec<_> = studies.iter().flat_map(Study::rows).collect();
        page::write_csv(&self.out, "work_precision.csv", &rows)
    }
}
