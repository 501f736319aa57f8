//! What a digest's scene consists of: plain SI numbers, so that a case is data and all cases share the code that plays them.

/// Particles a side.
pub(crate) const SIDE: usize = 10;

/// A sheet of [`SIDE`] × [`SIDE`] particles and what acts on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setup {
    pub(crate) name: &'static str,
    /// Width and height, m.
    pub(crate) size: [f64; 2],
    /// Whether the sheet starts upright rather than flat.
    pub(crate) upright: bool,
    /// Where particle (0, 0) starts, m.
    pub(crate) origin: [f64; 3],
    pub(crate) mass: Mass,
    /// The factor by which border particles are heavier.
    pub(crate) hem: Option<f64>,
    /// Particles held where they start, `[column, row]`.
    pub(crate) pins: &'static [[usize; 2]],
    /// The first of the pins travels this far in a frame, cells.
    pub(crate) hand: Option<[f64; 3]>,
    pub(crate) stretch: Spring,
    pub(crate) shear: Option<Spring>,
    pub(crate) bend: Option<Spring>,
    /// The largest strain that links may have.
    pub(crate) limit: Option<f64>,
    /// The slack of tethers to the pins.
    pub(crate) tether: Option<f64>,
    /// m/s²
    pub(crate) gravity: [f64; 3],
    pub(crate) drag: Option<Drag>,
    pub(crate) wind: Option<Wind>,
    pub(crate) ball: Option<Ball>,
    pub(crate) rod: Option<Rod>,
    pub(crate) ground: Option<Ground>,
    /// A frame, s.
    pub(crate) frame: f64,
}

/// The mass of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mass {
    /// kg
    PerParticle(f64),
    /// kg/m²
    PerArea(f64),
}

/// Stiffness (N/m) and damping (N·s/m) of a family of links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spring {
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Drag {
    /// γ, 1/s
    Rate(f64),
    /// The part of its displacement that a sheet loses in a frame, however long it is.
    Verlet(f64),
}

/// Velocity of the air, m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Wind {
    Facet([f64; 3]),
    /// Air of 1.2 kg/m³ against plates with a drag coefficient of 1.2.
    Aerodynamic([f64; 3]),
}

/// Centre (m), radius (m) and velocity (m/s) of a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball {
    pub(crate) centre: [f64; 3],
    pub(crate) radius: f64,
    pub(crate) velocity: [f64; 3],
    pub(crate) surface: Surface,
}

/// Ends of the axis and radius of a capsule, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rod {
    pub(crate) ends: [[f64; 3]; 2],
    pub(crate) radius: f64,
    pub(crate) surface: Surface,
}

/// A point (m) and the normal of a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ground {
    pub(crate) point: [f64; 3],
    pub(crate) normal: [f64; 3],
    pub(crate) surface: Surface,
}

/// Margin (m) and Coulomb's coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    pub(crate) margin: f64,
    pub(crate) friction: f64,
}
