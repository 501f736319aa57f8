//! Choices that a scene file makes by name.

use serde::Deserialize;

/// The initial pose of a sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pose {
    /// Flat in the x-y plane, rows along y.
    #[default]
    Lay,
    /// Upright in the x-z plane, row 0 on top.
    Hang,
}

/// The pattern of a sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weave {
    /// The second colour alone.
    #[default]
    Plain,
    /// Bands from the first row to the last.
    Stripes,
    /// A chessboard.
    Checks,
    /// Bands in both directions: full colour where two bands cross, half on the rest of a band.
    Gingham,
    /// Gingham with a border of the second colour.
    Kerchief,
}

/// A method of [`solver`](crate::solver), by its name in a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverKind {
    /// Position Verlet with relaxation sweeps.
    Verlet,
    /// Explicit Euler.
    ForwardEuler,
    /// Implicit Euler.
    BackwardEuler,
    /// Leapfrog (drift, kick, drift).
    Leapfrog,
    /// Extended position-based dynamics.
    Xpbd,
    /// Whole rows and columns of links, each solved at once.
    Lines,
}

impl SolverKind {
    /// Every method.
    pub const ALL: [Self; 6] =
        [Self::Verlet, Self::ForwardEuler, Self::BackwardEuler, Self::Leapfrog, Self::Xpbd, Self::Lines];

    /// Its name in a scene file and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Verlet => "verlet",
            Self::ForwardEuler => "forward-euler",
            Self::BackwardEuler => "backward-euler",
            Self::Leapfrog => "leapfrog",
            Self::Xpbd => "xpbd",
            Self::Lines => "lines",
        }
    }

    /// The method of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}
