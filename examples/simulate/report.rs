//! The report of a run: `report.json`, and the same figures as text.

use std::fmt;
use std::time::Duration;

use console::printable;
use kerchief::host::{Description, Explosion, ScalarKind, Simulation, SolverKind, Strain, Strains};
use serde::Serialize;

/// A number for each link family; none for a family that the scene does not have. In JSON, `null` marks a number that is infinite or undefined.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct Families {
    stretch: Option<f64>,
    shear: Option<f64>,
    bend: Option<f64>,
}

impl Families {
    fn of(strains: &Strains, value: impl Fn(Strain) -> f64) -> Self {
        let [stretch, shear, bend] = [strains.stretch, strains.shear, strains.bend].map(|strain| strain.map(&value));
        Self { stretch, shear, bend }
    }

    /// Takes the larger of both for each family.
    fn raise(&mut self, other: &Self) {
        // An undefined number stays undefined: comparisons with it are false.
        let larger_of = |a: f64, b: f64| if a >= b || a.is_nan() { a } else { b };
        let larger = |a: Option<f64>, b: Option<f64>| a.map_or(b, |a| b.map(|b| larger_of(a, b)));
        self.stretch = larger(self.stretch, other.stretch);
        self.shear = larger(self.shear, other.shear);
        self.bend = larger(self.bend, other.bend);
    }
}

impl fmt::Display for Families {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |name, value: Option<f64>| value.map(|value| format!("{name} {:.3} %", 100.0 * value));
        let families = [percent("stretch", self.stretch), percent("shear", self.shear), percent("bend", self.bend)];
        let families: Vec<_> = families.into_iter().flatten().collect();
        f.write_str(&if families.is_empty() { "no links".to_string() } else { families.join(", ") })
    }
}

/// The result of a run. Strains are the largest found at frame ends; times are those of the solver alone.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    scene: String,
    scalar: &'static str,
    solver: &'static str,
    columns: usize,
    rows: usize,
    frames: u32,
    frames_at_rest: u32,
    substeps: u32,
    iterations: u32,
    /// The line solver's sweeps, if the scene gives them: then `iterations` has no effect.
    #[serde(skip_serializing_if = "Option::is_none")]
    sweeps: Option<u32>,
    seconds: f64,
    steps_per_second: f64,
    particle_steps_per_second: f64,
    /// The largest number of pairs of particles in contact at once, for a sheet with self-contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    self_contacts: Option<u32>,
    /// Pairs of an edge and a triangle that pass through each other: the sum over all frames, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    self_intersections: Option<u64>,
    max_strain_motion: Families,
    max_strain_end: Families,
    rms_strain_end: f64,
    /// J; not finite where the number type rounds the divisor 1/κ of a spring to zero, so that the spring is rigid.
    energy_start: f64,
    energy_end: f64,
    digest: u32,
    finite: bool,
    #[serde(skip)]
    exploded: Option<(u32, Explosion)>,
}

/// Watches a run for its report.
#[derive(Debug)]
pub(crate) struct Watch {
    in_motion: Families,
    /// Frames that were not computed.
    at_rest: u32,
    /// Whether the last frame ended at rest.
    rests: bool,
    self_contacts: Option<u32>,
    self_intersections: Option<u64>,
    energy_start: f64,
    solving: Duration,
    frames: u32,
    /// The first frame in which the sheet exploded, and how. It counts as exploded even if it recovers.
    exploded: Option<(u32, Explosion)>,
}

impl Watch {
    /// Begins before the first frame.
    pub(crate) fn start(simulation: &dyn Simulation, intersections: bool) -> Self {
        let mut watch = Self {
            in_motion: Families::default(),
            at_rest: 0,
            rests: false,
            self_contacts: None,
            self_intersections: intersections.then_some(0),
            energy_start: simulation.energy(),
            solving: Duration::ZERO,
            frames: 0,
            exploded: None,
        };
        watch.look(simulation);
        watch
    }

    /// Records a frame and its computing time.
    pub(crate) fn frame(&mut self, simulation: &dyn Simulation, took: Duration) {
        self.solving += took;
        let rests = simulation.is_at_rest();
        self.at_rest += u32::from(rests && self.rests);
        self.rests = rests;
        self.frames += 1;
        self.self_contacts = self.self_contacts.max(simulation.self_contacts());
        self.exploded = self.exploded.or_else(|| simulation.explosion().map(|explosion| (self.frames, explosion)));
        self.look(simulation);
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        self.in_motion.raise(&Families::of(&simulation.strains(), |strain| strain.largest));
        if let Some(sum) = &mut self.self_intersections {
            *sum += u64::from(simulation.intersections());
        }
    }

    /// The report after the last frame.
    pub(crate) fn report(self, simulation: &dyn Simulation, scene: &Description, scalar: ScalarKind) -> Report {
        let seconds = self.solving.as_secs_f64();
        let strains = simulation.strains();
        let steps_per_second = f64::from(scene.frames) * f64::from(scene.solver.substeps) / seconds;
        let particles = scene.sheet.columns * scene.sheet.rows;
        Report {
            scene: scene.name.clone(),
            scalar: scalar.name(),
            solver: scene.solver.kind.name(),
            columns: scene.sheet.columns,
            rows: scene.sheet.rows,
            frames: scene.frames,
            frames_at_rest: self.at_rest,
            substeps: scene.solver.substeps,
            iterations: scene.solver.iterations,
            sweeps: scene.solver.sweeps.filter(|_| scene.solver.kind == SolverKind::Lines),
            seconds,
            steps_per_second,
            particle_steps_per_second: steps_per_second * particles as f64,
            self_contacts: self.self_contacts,
            self_intersections: self.self_intersections,
            max_strain_motion: self.in_motion,
            max_strain_end: Families::of(&strains, |strain| strain.largest),
            rms_strain_end: strains.all.rms,
            energy_start: self.energy_start,
            energy_end: simulation.energy(),
            digest: simulation.digest(),
            finite: self.exploded.is_none(),
            exploded: self.exploded,
        }
    }
}

impl Report {
    /// A message with the frame and the kind of the explosion, and a link to help.
    pub(crate) fn explosion(&self) -> Option<String> {
        self.exploded.map(|(frame, limit)| format!("exploded in frame {frame}: {limit}; see docs/guide/symptoms.md"))
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scene, scalar, solver, columns, rows, frames, substeps, iterations, .. } = self;
        writeln!(f, "scene             {}: {columns} x {rows} particles, {frames} frames", printable(scene))?;
        let relaxation = self.sweeps.map_or(format!("{iterations} iterations"), |sweeps| format!("{sweeps} sweeps"));
        writeln!(f, "solver            {solver} in {scalar}, {substeps} substeps, {relaxation}")?;
        if self.frames_at_rest > 0 {
            writeln!(f, "at rest           {} frames", self.frames_at_rest)?;
        }
        writeln!(f, "time              {:.3} s, {:.0} steps/s", self.seconds, self.steps_per_second)?;
        writeln!(f, "                  {:.3e} particle steps/s", self.particle_steps_per_second)?;
        if let Some(contacts) = self.self_contacts {
            writeln!(f, "meets itself in   {contacts} places at most")?;
        }
        if let Some(sum) = self.self_intersections {
            writeln!(f, "passes through    {sum} times, all frames together")?;
        }
        writeln!(f, "strain in motion  {}", self.max_strain_motion)?;
        writeln!(f, "strain at the end {}", self.max_strain_end)?;
        writeln!(f, "                  {:.3} % RMS of all links", 100.0 * self.rms_strain_end)?;
        writeln!(f, "energy            {:.6} J at the start, {:.6} J at the end", self.energy_start, self.energy_end)?;
        writeln!(f, "digest            {} ({:#010x})", self.digest, self.digest)?;
        write!(f, "finite            {}", if self.finite { "yes" } else { "no" })
    }
}
