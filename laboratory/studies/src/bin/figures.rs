//! Draws the thesis' two questions for the README: `cargo run --release --example figures` writes `docs/shear.png` and
//! `docs/super-elasticity.png`.

use std::error::Error;

use image::RgbImage;
use instances::simulation;
use kerchief::host::{Description, ScalarKind, SolverKind, Still, built_in};

use console::studio::Studio;
use laboratory::strip::strip;

/// The side of a picture, pixels.
const SIDE: u32 = 480;

fn main() -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all("docs")?;

    let without = scene("no-shear")?;
    let with = Description { shear: scene("gravity")?.shear, ..without.clone() };
    let panels = [run(&without)?, run(&with)?];
    let words = ["without shear links", "with shear links"].map(String::from);
    figure(&with, &panels, words)?.save("docs/shear.png")?;

    let wind = scene("wind")?;
    let mut thesis = wind.clone();
    (thesis.solver.kind, thesis.solver.substeps, thesis.solver.iterations) = (SolverKind::Verlet, 1, 15);
    let mut lines = wind.clone();
    (lines.solver.kind, lines.solver.substeps, lines.solver.iterations) = (SolverKind::Lines, 8, 1);
    let panels = [run(&thesis)?, run(&lines)?];
    let words = [("position Verlet, 15 sweeps", &panels[0]), ("line solver, 8 substeps", &panels[1])]
        .map(|(name, (_, strain))| format!("{name}: {:.1} %", 100.0 * strain));
    figure(&wind, &panels, words)?.save("docs/super-elasticity.png")?;
    Ok(())
}

fn scene(name: &str) -> Result<Description, Box<dyn Error>> {
    let scene = built_in(name).ok_or("no such scene")?;
    Ok(Description::parse(scene.text)?)
}

/// The last moment of a scene, and the largest strain of a stretch link at the end of any frame.
fn run(scene: &Description) -> Result<(Still, f64), Box<dyn Error>> {
    let mut simulation = simulation(&scene, ScalarKind::F32)?;
    let mut largest: f64 = 0.0;
    for _ in 0..scene.frames {
        simulation.frame();
        largest = simulation.strains().stretch.map_or(largest, |strain| largest.max(strain.largest));
    }
    Ok((simulation.still(), largest))
}

/// Two pictures by the same camera, side by side, each with a line of words.
fn figure(scene: &Description, panels: &[(Still, f64); 2], words: [String; 2]) -> Result<RgbImage, String> {
    let studio = Studio::new(scene, panels.iter().map(|(still, _)| still), SIDE)?;
    let panels: Vec<_> = panels.iter().zip(words).map(|((still, _), words)| (studio.picture(still), words)).collect();
    Ok(strip(&panels))
}
