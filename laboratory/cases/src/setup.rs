//! The description of a scene of the digests, in plain SI numbers. A scene is data; all scenes share the code that plays them.
#![allow(missing_docs, reason = "names that say it, with their units where they have one")]

/// Particles a side.
pub const SIDE: usize = 10;

/// A sheet of [`SIDE`] × [`SIDE`] particles, and everything that acts on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    pub name: &'static str,
    /// Width and height, m.
    pub size: [f64; 2],
    /// Whether the sheet starts upright rather than flat.
    pub upright: bool,
    /// Where particle (0, 0) starts, m.
    pub origin: [f64; 3],
    pub mass: Mass,
    /// The factor by which border particles are heavier.
    pub hem: Option<f64>,
    /// Particles pinned at their initial positions, `[column, row]`.
    pub pins: &'static [[usize; 2]],
    /// Displacement of the first pin in a frame, cells.
    pub hand: Option<[f64; 3]>,
    pub stretch: Spring,
    pub shear: Option<Spring>,
    pub bend: Option<Spring>,
    /// The largest strain of links.
    pub limit: Option<f64>,
    /// The slack of tethers to the pins.
    pub tether: Option<f64>,
    /// m/s²
    pub gravity: [f64; 3],
    pub drag: Option<Drag>,
    pub wind: Option<Wind>,
    pub ball: Option<Ball>,
    pub rod: Option<Rod>,
    pub ground: Option<Ground>,
    /// Length of a frame, s.
    pub frame: f64,
}

/// The mass of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mass {
    /// kg
    PerParticle(f64),
    /// kg/m²
    PerArea(f64),
}

/// Stiffness (N/m) and damping (N·s/m) of a family of links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    pub stiffness: f64,
    pub damping: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drag {
    /// γ, 1/s
    Rate(f64),
    /// The fraction of its displacement that a sheet loses in a frame, whatever the frame's length.
    Verlet(f64),
}

/// Velocity of the air, m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wind {
    Facet([f64; 3]),
    /// Air of 1.2 kg/m³ against plates with a drag coefficient of 1.2.
    Aerodynamic([f64; 3]),
    /// The same against the cells as panels.
    Panel([f64; 3]),
}

/// Centre (m), radius (m) and velocity (m/s) of a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub centre: [f64; 3],
    pub radius: f64,
    pub velocity: [f64; 3],
    pub surface: Surface,
}

/// Ends of the axis and radius of a capsule, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod {
    pub ends: [[f64; 3]; 2],
    pub radius: f64,
    pub surface: Surface,
}

/// A point (m) and the normal of a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    pub point: [f64; 3],
    pub normal: [f64; 3],
    pub surface: Surface,
}

/// Margin (m) and Coulomb's coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    pub margin: f64,
    pub friction: f64,
}
