//! Draws the thesis' two questions: `shear.png` and `super-elasticity.png`, into `out` or, to renew those of the README, into `docs`.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use console::studio::Studio;
use image::RgbImage;
use indicatif::ProgressBar;
use instances::simulation;
use kerchief::host::{Description, ScalarKind, SolverKind, Still, built_in};
use laboratory::strip::strip;

/// The side of a picture, pixels.
const SIDE: u32 = 480;

/// Draws what shear links do, and why cloth stretches like rubber.
#[derive(Debug, Parser)]
struct Arguments {
    /// Where the pictures go; `docs` renews those of the README.
    #[arg(long, default_value = "out")]
    out: PathBuf,
}

fn main() -> ExitCode {
    console::exit(console::read().and_then(|arguments: Arguments| run(&arguments)))
}

fn run(Arguments { out }: &Arguments) -> Result<(), String> {
    let without = scene("no-shear")?;
    let with = Description { shear: scene("gravity")?.shear, ..without.clone() };
    let wind = scene("wind")?;
    let mut thesis = wind.clone();
    (thesis.solver.kind, thesis.solver.substeps, thesis.solver.iterations) = (SolverKind::Verlet, 1, 15);
    let mut lines = wind.clone();
    (lines.solver.kind, lines.solver.substeps, lines.solver.iterations) = (SolverKind::Lines, 8, 1);

    std::fs::create_dir_all(out).map_err(|error| format!("{}: {error}", out.display()))?;
    let frames = [&without, &with, &thesis, &lines].map(|scene| u64::from(scene.frames)).iter().sum();
    let bar = console::progress("frames", frames);
    let panels = [moved(&without, &bar)?, moved(&with, &bar)?];
    let words = ["without shear links", "with shear links"].map(String::from);
    let shear = figure(&with, &panels, words)?;
    let panels = [moved(&thesis, &bar)?, moved(&lines, &bar)?];
    let words = [("position Verlet, 15 sweeps", &panels[0]), ("line solver, 8 substeps", &panels[1])]
        .map(|(name, (_, strain))| format!("{name}: {:.1} %", 100.0 * strain));
    let elasticity = figure(&wind, &panels, words)?;
    bar.finish_and_clear();
    for (name, picture) in [("shear.png", shear), ("super-elasticity.png", elasticity)] {
        let path = out.join(name);
        picture.save(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        console::say(&format!("{}", path.display()));
    }
    Ok(())
}

fn scene(name: &str) -> Result<Description, String> {
    let scene = built_in(name).ok_or_else(|| format!("no scene {name:?}"))?;
    Description::parse(scene.text).map_err(|error| error.to_string())
}

/// The last moment of a scene, and the largest strain of a stretch link at the end of any frame.
fn moved(scene: &Description, bar: &ProgressBar) -> Result<(Still, f64), String> {
    let mut simulation = simulation(scene, ScalarKind::F32).map_err(|error| error.to_string())?;
    let mut largest: f64 = 0.0;
    for _ in 0..scene.frames {
        simulation.frame();
        largest = simulation.strains().stretch.map_or(largest, |strain| largest.max(strain.largest));
        bar.inc(1);
    }
    Ok((simulation.still(), largest))
}

/// Two pictures by the same camera, side by side, each with a line of words.
fn figure(scene: &Description, panels: &[(Still, f64); 2], words: [String; 2]) -> Result<RgbImage, String> {
    let studio = Studio::new(scene, panels.iter().map(|(still, _)| still), SIDE)?;
    let panels: Vec<_> = panels.iter().zip(words).map(|((still, _), words)| (studio.picture(still), words)).collect();
    Ok(strip(&panels))
}
