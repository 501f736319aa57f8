//! From a parsed file to a description: defaults, exclusive keys, and checks that involve two keys.

use std::format;
use std::vec::Vec;

use super::choice::SolverKind;
use super::description::{
    Capsule, Description, Drag, Picture, Plane, SelfContact, Sheet, Solver, Sphere, Spring, Surface, Wind, WindModel,
};
use super::error::SceneError;
use super::file::{self, File, Pins, Table};
use super::quantity::{Count, NonNegative, Number, Positive};
use super::shape::SHAPES;
use crate::rest::Stillness;
use crate::solver::Lines;

/// Default number of frames.
const FRAMES: u32 = 100;
/// Default duration of a frame, s.
const STEP: f64 = 1.0 / 60.0;
/// Default number of solver steps per frame.
const SUBSTEPS: u32 = 8;
/// Default azimuth and elevation of pictures, degrees.
const DIRECTION: (f64, f64) = (30.0, 20.0);
/// Default number of bands of a pattern.
const BANDS: u32 = 15;
/// Default colours of a sheet: linen and madder.
const COLOURS: [[u8; 3]; 2] = [[0xf3, 0xea, 0xdc], [0xb8, 0x2e, 0x34]];
/// Density of air at 20 °C and 1013 hPa, kg/m³ (ISO 2533).
const AIR_DENSITY: f64 = 1.2;
/// Normal-force coefficient of a flat plate across the flow (Hoerner, Fluid-Dynamic Drag, 1965, ch. 3: 1.1 to 1.2 for a square).
const PLATE_DRAG: f64 = 1.2;

impl File {
    pub(super) fn resolve(self) -> Result<Description, SceneError> {
        let (Table(environment), Table(solver)) = (self.environment, self.solver);
        let step = solver.step.map_or(STEP, Positive::get);
        Ok(Description {
            sheet: sheet(&self.cloth.0)?,
            stretch: spring("stretch", self.stretch.as_ref())?,
            shear: spring("shear", self.shear.as_ref())?,
            bend: spring("bend", self.bend.as_ref())?,
            tether_slack: self.tether.map(|tether| or_zero(tether.0.slack)),
            gravity: environment.gravity.0,
            drag: drag(&environment, step)?,
            wind: environment.wind.as_ref().map(wind).transpose()?,
            spheres: self.sphere.iter().map(sphere).collect(),
            planes: self.plane.iter().enumerate().map(plane).collect::<Result<_, _>>()?,
            capsules: self.capsule.iter().enumerate().map(capsule).collect::<Result<_, _>>()?,
            solver: Solver {
                kind: solver.kind.map_or(SolverKind::Lines, |kind| kind.0),
                step,
                substeps: solver.substeps.map_or(SUBSTEPS, Count::get),
                iterations: solver.iterations.map_or(1, Count::get),
                sweeps: solver.sweeps.map(Count::get),
                tolerance: solver.tolerance.map_or(Lines::new().tolerance, Positive::get),
                strain_limit: solver.strain_limit.map(Positive::get),
            },
            self_contact: self.self_contact.map(|Table(own)| SelfContact {
                thickness: own.thickness.map(Positive::get),
                friction: or_zero(own.friction),
            }),
            rest: self.rest.as_ref().map(rest),
            frames: self.run.0.frames.map_or(FRAMES, Count::get),
            picture: picture(&self.picture.0)?,
            name: self.name,
        })
    }
}

fn or_zero(value: Option<NonNegative>) -> f64 {
    value.map_or(0.0, NonNegative::get)
}

/// The value of one of two keys that exclude each other, as `(key, value)`.
fn one_of<T>(
    table: &str,
    first: (&'static str, Option<T>),
    second: (&'static str, Option<T>),
) -> Result<Option<(&'static str, T)>, SceneError> {
    match (first, second) {
        ((a, Some(_)), (b, Some(_))) => {
            Err(SceneError::new(format!("{table}.{b}"), format!("give {a} or {b}, not both")))
        }
        ((key, Some(value)), _) | (_, (key, Some(value))) => Ok(Some((key, value))),
        _ => Ok(None),
    }
}

fn sheet(cloth: &file::Cloth) -> Result<Sheet, SceneError> {
    let (columns, rows) = (cloth.columns.get() as usize, cloth.rows.get() as usize);
    if !SHAPES.contains(&(columns, rows)) {
        let known = SHAPES.iter().map(|(c, r)| format!("{c}x{r}")).collect::<Vec<_>>().join(", ");
        let key = if SHAPES.iter().any(|&(c, _)| c == columns) { "cloth.rows" } else { "cloth.columns" };
        return Err(SceneError::new(key, format!("no grid of {columns}x{rows} (columns x rows), only {known}")));
    }
    let width = match cloth.width {
        Some(width) if columns > 1 && width.get() > 0.0 => width.get(),
        Some(width) if columns > 1 => {
            return Err(SceneError::new("cloth.width", format!("must be above zero, is {}", width.get())));
        }
        None if columns > 1 => return Err(SceneError::new("cloth.width", "missing")),
        _ => 0.0,
    };
    let height = cloth.height.get();
    let (mass_key, mass) = mass(cloth, columns, rows, width * height)?;
    let sheet = Sheet {
        columns,
        rows,
        width,
        height,
        pose: cloth.pose.0,
        origin: cloth.origin.0,
        mass,
        mass_key,
        hem: cloth.hem.map(Positive::get),
        pins: pins(&cloth.pins, columns, rows)?,
    };
    for (column, row) in [(0, 0), (0, 1), (1, 1)].into_iter().filter(|(column, _)| *column < columns) {
        let mass = sheet.mass_at(column, row);
        if !(mass.is_finite() && mass > 0.0) {
            let key = format!("cloth.{mass_key}");
            return Err(SceneError::new(key, format!("gives a particle the mass {mass} kg")));
        }
    }
    Ok(sheet)
}

/// The mass of a particle with inverse mass 1, and the key it comes from.
fn mass(cloth: &file::Cloth, columns: usize, rows: usize, area: f64) -> Result<(&'static str, f64), SceneError> {
    match one_of("cloth", ("mass", cloth.mass), ("density", cloth.density))? {
        None => Err(SceneError::new("cloth.mass", "missing; give mass (kg per particle) or density (kg/m²)")),
        Some(("density", _)) if columns == 1 => {
            Err(SceneError::new("cloth.density", "a chain of one column has no area; give mass"))
        }
        Some((key @ "density", density)) => Ok((key, density.get() * area / ((columns - 1) * (rows - 1)) as f64)),
        Some((key, mass)) => Ok((key, mass.get())),
    }
}

fn pins(pins: &Pins, columns: usize, rows: usize) -> Result<Vec<[usize; 2]>, SceneError> {
    let (right, bottom) = (columns - 1, rows - 1);
    let mut nodes = match pins {
        Pins::Top => (0..columns).map(|column| [column, 0]).collect(),
        Pins::Left => (0..rows).map(|row| [0, row]).collect(),
        Pins::Corners => Vec::from([[0, 0], [right, 0], [0, bottom], [right, bottom]]),
        Pins::TopCorners => Vec::from([[0, 0], [right, 0]]),
        Pins::Nodes(nodes) => {
            let node = |(index, node): (usize, &Vec<i64>)| {
                let key = format!("cloth.pins[{index}]");
                let &[column, row] = node.as_slice() else {
                    return Err(SceneError::new(key, format!("must be [column, row], is {node:?}")));
                };
                let inside = |index: i64, count: usize| usize::try_from(index).ok().filter(|index| *index < count);
                inside(column, columns).zip(inside(row, rows)).map(|(column, row)| [column, row]).ok_or_else(|| {
                    SceneError::new(key, format!("[{column}, {row}] is outside the grid of {columns}x{rows}"))
                })
            };
            nodes.iter().enumerate().map(node).collect::<Result<Vec<_>, _>>()?
        }
    };
    nodes.sort_unstable_by_key(|&[column, row]| (row, column));
    nodes.dedup();
    Ok(nodes)
}

fn spring(table: &str, links: Option<&Table<file::Links>>) -> Result<Option<Spring>, SceneError> {
    let Some(Table(links)) = links else { return Ok(None) };
    let stiffness = links.stiffness.map(NonNegative::get);
    let from_compliance = links.compliance.map(|compliance| 1.0 / compliance.get());
    let given = one_of(table, ("stiffness", stiffness), ("compliance", from_compliance))?;
    let Some((key, stiffness)) = given else {
        let reason = "missing; give stiffness (N/m) or compliance (m/N)";
        return Err(SceneError::new(format!("{table}.stiffness"), reason));
    };
    if !stiffness.is_finite() {
        return Err(SceneError::new(format!("{table}.{key}"), "too small: the stiffness is not finite"));
    }
    let damping = or_zero(links.damping);
    Ok((stiffness > 0.0 || damping > 0.0).then_some(Spring { stiffness, key, damping }))
}

/// γ in 1/s. A step of position Verlet multiplies its displacement by `1 - D`, which equals `exp(-γ step)`.
fn drag(environment: &file::Environment, step: f64) -> Result<Option<Drag>, SceneError> {
    let drag = environment.drag.map(NonNegative::get);
    let verlet = environment.verlet_damping.map(|damping| -(-damping.get()).ln_1p() / step);
    match one_of("environment", ("drag", drag), ("verlet_damping", verlet))? {
        Some((key, rate)) if !rate.is_finite() => {
            Err(SceneError::new(format!("environment.{key}"), "the damping rate in this step is not finite"))
        }
        given => Ok(given.map(|(key, rate)| Drag { rate, key }).filter(|drag| drag.rate > 0.0)),
    }
}

fn wind(Table(wind): &Table<file::Wind>) -> Result<Wind, SceneError> {
    let density = wind.density.map_or(AIR_DENSITY, Positive::get);
    let drag_coefficient = wind.drag_coefficient.map_or(PLATE_DRAG, NonNegative::get);
    let model = match wind.model.0 {
        file::WindModel::Aerodynamic => WindModel::Aerodynamic { density, drag_coefficient },
        file::WindModel::Panel => WindModel::Panel { density, drag_coefficient },
        file::WindModel::Facet => {
            let surplus = [("density", wind.density.is_some()), ("drag_coefficient", wind.drag_coefficient.is_some())];
            if let Some((key, _)) = surplus.iter().find(|(_, given)| *given) {
                return Err(SceneError::new(
                    format!("environment.wind.{key}"),
                    "only with model = \"aerodynamic\" or \"panel\"",
                ));
            }
            WindModel::Facet
        }
    };
    Ok(Wind { velocity: wind.velocity.0, model })
}

fn surface(margin: Option<NonNegative>, friction: Option<NonNegative>) -> Surface {
    Surface { margin: or_zero(margin), friction: or_zero(friction) }
}

fn sphere(Table(sphere): &Table<file::Sphere>) -> Sphere {
    Sphere {
        centre: sphere.centre.0,
        radius: sphere.radius.get(),
        velocity: sphere.velocity.0,
        surface: surface(sphere.margin, sphere.friction),
    }
}

fn plane((index, Table(plane)): (usize, &Table<file::Plane>)) -> Result<Plane, SceneError> {
    let normal = plane.normal.0;
    // Divided by its largest component first: the squares of huge or tiny components leave the range of f64.
    let largest = normal.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if largest == 0.0 {
        return Err(SceneError::new(format!("plane[{index}].normal"), "must not be the zero vector"));
    }
    let scaled = normal.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    Ok(Plane {
        point: plane.point.0,
        normal: scaled.map(|x| x / length),
        surface: surface(plane.margin, plane.friction),
    })
}

fn capsule((index, Table(capsule)): (usize, &Table<file::Capsule>)) -> Result<Capsule, SceneError> {
    if capsule.a.0 == capsule.b.0 {
        return Err(SceneError::new(format!("capsule[{index}].b"), "must differ from a; a ball is a sphere"));
    }
    Ok(Capsule {
        a: capsule.a.0,
        b: capsule.b.0,
        radius: capsule.radius.get(),
        surface: surface(capsule.margin, capsule.friction),
    })
}

fn rest(Table(rest): &Table<file::Rest>) -> Stillness {
    let Stillness { speed, acceleration, time } = Stillness::DEFAULT;
    Stillness {
        speed: rest.speed.map_or(speed, Positive::get),
        acceleration: rest.acceleration.map_or(acceleration, Positive::get),
        time: rest.time.map_or(time, Positive::get),
    }
}

fn picture(picture: &file::Picture) -> Result<Picture, SceneError> {
    let frame = match (picture.low, picture.high) {
        (Some(low), Some(high)) => {
            if (0..3).any(|axis| low.0[axis] > high.0[axis]) {
                return Err(SceneError::new("picture.high", "must not be below low"));
            }
            if low.0 == high.0 {
                return Err(SceneError::new("picture.high", "must differ from low"));
            }
            Some([low.0, high.0])
        }
        (None, None) => None,
        (Some(_), None) => return Err(SceneError::new("picture.high", "missing; low is given")),
        (None, Some(_)) => return Err(SceneError::new("picture.low", "missing; high is given")),
    };
    let elevation = picture.elevation.map_or(DIRECTION.1, Number::get);
    if elevation.abs() > 90.0 {
        return Err(SceneError::new("picture.elevation", format!("must be from -90 to 90, is {elevation}")));
    }
    let colours = match picture.colours.as_deref() {
        None => COLOURS,
        Some([first, second]) => [first.0, second.0],
        Some(other) => {
            return Err(SceneError::new("picture.colours", format!("must be two colours, are {}", other.len())));
        }
    };
    Ok(Picture {
        azimuth: picture.azimuth.map_or(DIRECTION.0, Number::get) % 360.0,
        elevation,
        frame,
        pattern: picture.pattern.0,
        bands: picture.bands.map_or(BANDS, Count::get),
        colours,
    })
}
