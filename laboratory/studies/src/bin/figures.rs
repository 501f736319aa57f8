//! Draws two pictures on the questions of the thesis, `shear.png` and `super-elasticity.png`. They are written into `out`, or into `docs` to renew those of the README.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use console::studio::Studio;
use image::RgbImage;
use kerchief::host::{Counted, Description, Everything, SolverKind, Still, built_in};
use laboratory::strip::strip;

/// The side of a picture, pixels.
const SIDE: u32 = 480;

/// A frame in which both sheets lie on the ball.
const ON_THE_BALL: u32 = 24;

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
    std::fs::create_dir_all(out).map_err(|error| format!("{}: {error}", out.display()))?;
    for (name, picture) in [("shear.png", shear()?), ("super-elasticity.png", super_elasticity()?)] {
        let path = out.join(name);
        picture.save(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        console::say(&format!("{}", path.display()));
    }
    Ok(())
}

/// A sheet on a ball, without and with shear links.
fn shear() -> Result<RgbImage, String> {
    let without = Description { frames: ON_THE_BALL, ..scene("no-shear")? };
    let with = Description { shear: scene("gravity")?.shear, ..without.clone() };
    let panels = [moved(&without)?, moved(&with)?].map(|motion| motion.end);
    figure(&with, &panels, ["without shear links", "with shear links"].map(String::from))
}

/// A sheet in wind by the thesis' method, and by the line solver with no more operations. Each is shown in the frame with its largest strain.
fn super_elasticity() -> Result<RgbImage, String> {
    let wind = scene("wind")?;
    let by = |kind, substeps, sweeps| {
        let mut scene = wind.clone();
        (scene.solver.kind, scene.solver.substeps, scene.solver.iterations) = (kind, substeps, sweeps);
        moved(&scene)
    };
    let [thesis, lines] = [by(SolverKind::Verlet, 1, 15)?, by(SolverKind::Lines, 4, 1)?];
    if lines.operations > thesis.operations {
        return Err(format!(
            "the line solver takes {} operations, the thesis' method {}",
            lines.operations, thesis.operations
        ));
    }
    let words = [("position Verlet, 15 sweeps", &thesis), ("line solver, 4 substeps", &lines)]
        .map(|(name, motion)| format!("{name}: {:.1} %", 100.0 * motion.strain));
    figure(&wind, &[thesis.strained, lines.strained], words)
}

fn scene(name: &str) -> Result<Description, String> {
    let scene = built_in(name).ok_or_else(|| format!("no scene {name:?}"))?;
    Description::parse(scene.text).map_err(|error| error.to_string())
}

/// Results of a run.
struct Motion {
    /// The frame with the largest strain of a stretch link, and this strain.
    strained: Still,
    strain: f64,
    /// The last frame.
    end: Still,
    operations: u64,
}

/// Runs a scene of 32 × 32 particles.
fn moved(scene: &Description) -> Result<Motion, String> {
    let mut simulation = scene.simulation_on::<Everything, Counted, 32, 32>().map_err(|error| error.to_string())?;
    let bar = console::progress("frames", scene.frames.into());
    let (mut strained, mut strain) = (simulation.still(), 0.0);
    Counted::reset();
    for _ in 0..scene.frames {
        simulation.frame();
        let largest = simulation.strains().stretch.map_or(0.0, |strain| strain.largest);
        if largest > strain {
            (strained, strain) = (simulation.still(), largest);
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(Motion { strained, strain, end: simulation.still(), operations: Counted::operations().total() })
}

/// Two pictures by the same camera, side by side, each with a caption.
fn figure(scene: &Description, panels: &[Still; 2], words: [String; 2]) -> Result<RgbImage, String> {
    let studio = Studio::new(scene, panels.iter(), SIDE)?;
    let panels: Vec<_> = panels.iter().zip(words).map(|(still, words)| (studio.picture(still), words)).collect();
    Ok(strip(&panels))
}
