//! The scenes of the digests: one for each kind of force, link, collider and motion of a pin, and the built-in scenes on a grid that fits a board.

use crate::setup::{Ball, Drag, Ground, Mass, Rod, SIDE, Setup, Spring, Surface, Wind};

/// Every scene.
pub const CASES: [Setup; 16] = [
    DRAGGED,
    FACET_WIND,
    AERODYNAMIC_WIND,
    PANEL_WIND,
    BALL_WITH_FRICTION,
    DAMPED_LINKS,
    STRAIN_LIMIT,
    TETHERS,
    MOVING_PIN_AND_BALL,
    GRAVITY,
    SPHERE,
    WIND,
    NO_SHEAR,
    FLAG,
    CURTAIN,
    DRAPE,
];

const EDGE: usize = SIDE - 1;
const TOP_CORNERS: &[[usize; 2]] = &[[0, 0], [EDGE, 0]];
const THREE_CORNERS: &[[usize; 2]] = &[[0, 0], [EDGE, 0], [0, EDGE]];
const LEFT: &[[usize; 2]] = &{
    let mut pins = [[0; 2]; SIDE];
    let mut row = 0;
    while row < SIDE {
        pins[row] = [0, row];
        row += 1;
    }
    pins
};
/// The curtain's eight pegs, spread over fewer columns.
const PEGS: &[[usize; 2]] = &[[0, 0], [1, 0], [3, 0], [4, 0], [5, 0], [6, 0], [8, 0], [EDGE, 0]];

const fn undamped(stiffness: f64) -> Spring {
    Spring { stiffness, damping: 0.0 }
}

const fn damped(stiffness: f64, damping: f64) -> Spring {
    Spring { stiffness, damping }
}

/// A sheet that falls, in cells of 5 cm × 4 cm.
const FALLING: Setup = Setup {
    name: "falling",
    size: [0.75, 0.6],
    upright: false,
    origin: [-0.4, -0.3, 0.0],
    mass: Mass::PerParticle(5e-4),
    hem: None,
    pins: &[],
    hand: None,
    stretch: undamped(40.0),
    shear: Some(undamped(8.0)),
    bend: Some(undamped(2.0)),
    limit: None,
    tether: None,
    gravity: [0.0, 0.0, -9.81],
    drag: None,
    wind: None,
    ball: None,
    rod: None,
    ground: None,
    frame: 1.0 / 60.0,
};

const DRAGGED: Setup = Setup { name: "dragged", pins: TOP_CORNERS, drag: Some(Drag::Verlet(0.02)), ..FALLING };

const FACET_WIND: Setup =
    Setup { name: "facet-wind", upright: true, pins: LEFT, wind: Some(Wind::Facet([3.0, 2.0, 0.5])), ..FALLING };

const AERODYNAMIC_WIND: Setup = Setup {
    name: "aerodynamic-wind",
    upright: true,
    pins: TOP_CORNERS,
    wind: Some(Wind::Aerodynamic([1.0, 5.0, 0.0])),
    ..FALLING
};

const PANEL_WIND: Setup = Setup { name: "panel-wind", wind: Some(Wind::Panel([1.0, 5.0, 0.0])), ..AERODYNAMIC_WIND };

// The sheet touches the ball from the start, because explicit solvers play only a few milliseconds.
const BALL_WITH_FRICTION: Setup = Setup {
    name: "ball-with-friction",
    mass: Mass::PerArea(0.25),
    hem: Some(1.5),
    ball: Some(Ball {
        centre: [0.01, 0.02, -0.205],
        radius: 0.2,
        velocity: [0.0; 3],
        surface: Surface { margin: 0.01, friction: 0.4 },
    }),
    ..FALLING
};

const DAMPED_LINKS: Setup = Setup {
    name: "damped-links",
    pins: &[[0, 0]],
    stretch: damped(40.0, 0.01),
    bend: Some(damped(2.0, 0.01)),
    ..FALLING
};

const STRAIN_LIMIT: Setup = Setup {
    name: "strain-limit",
    upright: true,
    pins: TOP_CORNERS,
    stretch: undamped(4.0),
    shear: Some(undamped(1.0)),
    bend: None,
    limit: Some(0.05),
    ..FALLING
};

const TETHERS: Setup = Setup {
    name: "tethers",
    pins: TOP_CORNERS,
    stretch: undamped(4.0),
    shear: Some(undamped(1.0)),
    bend: None,
    tether: Some(0.0),
    ..FALLING
};

const MOVING_PIN_AND_BALL: Setup = Setup {
    name: "moving-pin-and-ball",
    pins: &[[EDGE, EDGE]],
    hand: Some([-0.05, 0.02, 0.1]),
    ball: Some(Ball {
        centre: [0.03, 0.02, -0.103],
        radius: 0.1,
        velocity: [0.3, 0.0, 0.1],
        surface: Surface { margin: 0.005, friction: 0.0 },
    }),
    rod: Some(Rod {
        ends: [[-0.2, -0.2, -0.044], [-0.2, 0.2, -0.042]],
        radius: 0.04,
        surface: Surface { margin: 0.005, friction: 0.5 },
    }),
    ground: Some(Ground {
        point: [0.0, 0.0, -0.03],
        normal: [0.1, 0.0, 1.0],
        surface: Surface { margin: 0.005, friction: 0.0 },
    }),
    ..FALLING
};

/// The sheet of the thesis.
const THESIS: Setup = Setup {
    name: "thesis",
    size: [10.0, 10.0],
    origin: [-5.0, -5.0, 0.0],
    mass: Mass::PerParticle(1.0),
    stretch: undamped(94_270.0),
    shear: Some(undamped(9_427.0)),
    bend: Some(undamped(942.7)),
    drag: Some(Drag::Verlet(0.1)),
    frame: 0.1,
    ..FALLING
};

const BALL: Ball = Ball {
    centre: [-1.0, -1.0, -7.0],
    radius: 2.0,
    velocity: [0.0; 3],
    surface: Surface { margin: 0.59, friction: 0.0 },
};

const GRAVITY: Setup = Setup { name: "gravity", pins: THREE_CORNERS, ..THESIS };

const SPHERE: Setup = Setup { name: "sphere", pins: TOP_CORNERS, ball: Some(BALL), ..THESIS };

const WIND: Setup = Setup { name: "wind", pins: LEFT, wind: Some(Wind::Facet([5.0, 0.0, -3.0])), ..THESIS };

const NO_SHEAR: Setup = Setup { name: "no-shear", pins: THREE_CORNERS, shear: None, ball: Some(BALL), ..THESIS };

const FLAG: Setup = Setup {
    name: "flag",
    size: [1.5, 1.0],
    upright: true,
    origin: [0.0, 0.0, 2.0],
    mass: Mass::PerArea(0.12),
    hem: Some(1.5),
    pins: LEFT,
    stretch: damped(2_000.0, 0.003),
    shear: Some(damped(30.0, 0.003)),
    bend: Some(damped(80.0, 0.003)),
    wind: Some(Wind::Aerodynamic([7.0, 0.5, 0.0])),
    rod: Some(Rod {
        ends: [[0.0, 0.0, -0.5], [0.0, 0.0, 2.1]],
        radius: 0.02,
        surface: Surface { margin: 0.0, friction: 0.0 },
    }),
    frame: 0.02,
    ..FALLING
};

const CURTAIN: Setup = Setup {
    name: "curtain",
    size: [1.2, 1.2],
    upright: true,
    origin: [-0.6, 0.0, 1.3],
    mass: Mass::PerArea(0.15),
    hem: Some(2.0),
    pins: PEGS,
    stretch: damped(1_000.0, 0.002),
    shear: Some(damped(15.0, 0.002)),
    bend: Some(damped(2.0, 0.002)),
    drag: Some(Drag::Rate(0.2)),
    wind: Some(Wind::Aerodynamic([0.1, 0.5, 0.0])),
    ball: Some(Ball {
        centre: [0.1, -0.75, 0.35],
        radius: 0.2,
        velocity: [0.0, 0.4, 0.1],
        surface: Surface { margin: 0.01, friction: 0.2 },
    }),
    rod: Some(Rod {
        ends: [[-0.7, 0.0, 1.3], [0.7, 0.0, 1.3]],
        radius: 0.02,
        surface: Surface { margin: 0.0, friction: 0.0 },
    }),
    frame: 0.02,
    ..FALLING
};

const DRAPE: Setup = Setup {
    name: "drape",
    size: [1.0, 1.0],
    origin: [-0.46, -0.53, 0.7],
    mass: Mass::PerArea(0.15),
    hem: Some(1.5),
    stretch: undamped(1_000.0),
    shear: Some(undamped(15.0)),
    bend: Some(undamped(3.0)),
    drag: Some(Drag::Rate(0.5)),
    wind: Some(Wind::Aerodynamic([0.0; 3])),
    ball: Some(Ball {
        centre: [0.0, 0.0, 0.4],
        radius: 0.22,
        velocity: [0.0; 3],
        surface: Surface { margin: 0.006, friction: 0.4 },
    }),
    rod: Some(Rod {
        ends: [[0.0, 0.0, 0.0], [0.0, 0.0, 0.2]],
        radius: 0.04,
        surface: Surface { margin: 0.0, friction: 0.4 },
    }),
    ground: Some(Ground {
        point: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
        surface: Surface { margin: 0.004, friction: 0.6 },
    }),
    frame: 0.02,
    ..FALLING
};
