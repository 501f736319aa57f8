//! A random sheet and its run.

use kerchief::{
    Bend, Cloth, Drag, Gravity, Grid, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Stretch, Units, Vec3, measure,
};

const DOWN: [f64; 3] = [0.0, 0.0, -9.81];

#[derive(Clone, Copy, Debug)]
enum Pins {
    Corners,
    Edge,
    Centre,
    Single,
    /// Two corners. One of them is moved to and fro in the first two seconds.
    Moving,
}

#[derive(Clone, Copy, Debug)]
enum Start {
    Laid,
    Hung,
    /// Laid, with its far half folded over the near one.
    Folded,
}

/// A sheet in SI units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    side: usize,
    size: f64,
    /// The mass of the whole sheet.
    mass: f64,
    /// The stiffness of stretch, shear and bend.
    springs: [f64; 3],
    pins: Pins,
    start: Start,
    frame: f64,
    drag: f64,
}

/// The measurements of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// The largest strain of a stretch link at the end.
    pub(super) strain: f64,
    /// The largest kinetic and gravitational energy in the second half of the time, minus the total energy at the start, over m·g·size.
    pub(super) energy: f64,
    /// The largest speed along an axis in the last second, m/s.
    pub(super) speed: f64,
}

/// Pseudorandom numbers (G. Steele and others, *Fast splittable pseudorandom number generators*, 2014).
struct Lot(u64);

impl Lot {
    /// From 0 to 1.
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    /// Uniform in the logarithm.
    fn power(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.part())
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.part() * all.len() as f64) as usize]
    }
}

impl Sheet {
    /// The random sheet with this number, always the same.
    pub(super) fn by_lot(number: u64, sides: &[usize]) -> Self {
        let mut lot = Lot(number.wrapping_mul(0xd134_2543_de82_ef95));
        let (side, size) = (lot.one_of(sides), lot.power(0.1, 3.0));
        let stretch = lot.power(1e2, 1e6);
        Self {
            side,
            size,
            mass: lot.between(0.1, 0.4) * size * size,
            springs: [stretch, stretch * lot.power(0.01, 1.0), stretch * lot.power(1e-3, 0.1)],
            pins: lot.one_of(&[Pins::Corners, Pins::Edge, Pins::Centre, Pins::Single, Pins::Moving]),
            start: lot.one_of(&[Start::Laid, Start::Hung, Start::Folded]),
            frame: lot.between(8e-3, 33e-3),
            drag: lot.between(1.0, 4.0),
        }
    }

    /// Whether the number type represents the speed after a fall by more than the sheet's diagonal, and the grid is compiled for it.
    pub(super) fn fits(&self, kind: Kind) -> bool {
        let cell = self.size / (self.side - 1) as f64;
        let fast = (2.0 * 9.81 * 2.0 * self.size).sqrt() * 2.0 * self.frame / cell;
        match kind {
            Kind::F32 => true,
            Kind::F64 => self.side <= 64,
            Kind::Q24 | Kind::Q13 => self.side <= 64 && fast < 100.0,
        }
    }

    /// Whether it has a single pin.
    pub(super) fn hangs_from_one(&self) -> bool {
        matches!(self.pins, Pins::Centre | Pins::Single)
    }

    /// Runs it for so many seconds.
    pub(super) fn run(&self, kind: Kind, substeps: u32, seconds: f64) -> Found {
        macro_rules! run {
            ($scalar:ty) => {
                match self.side {
                    8 => self.run_on::<$scalar, 8>(substeps, seconds),
                    16 => self.run_on::<$scalar, 16>(substeps, seconds),
                    32 => self.run_on::<$scalar, 32>(substeps, seconds),
                    // only in the long version, which is optimised: each grid takes seconds to compile
                    #[cfg(not(debug_assertions))]
                    64 => self.run_on::<$scalar, 64>(substeps, seconds),
                    side => unreachable!("{side} particles a side"),
                }
            };
        }
        match kind {
            Kind::F32 if self.side == 128 => self.run_on::<f32, 128>(substeps, seconds),
            Kind::F32 => run!(f32),
            Kind::F64 => run!(f64),
            Kind::Q24 => run!(Q24),
            Kind::Q13 => run!(Q13),
        }
    }

    fn units(&self, substeps: u32) -> Units {
        let side = self.side;
        Units::sheet([side, side], [self.size; 2], self.mass / (side * side) as f64, self.frame, substeps)
    }

    /// Puts the particles in their initial places and sets the pins.
    fn place<S: Scalar, const N: usize>(&self, cloth: &mut Cloth<S, N, N>) {
        let (units, half) = (self.units(1), 0.5 * self.size);
        match self.start {
            Start::Hung => cloth.hang_here(&units, units.point([-half, 0.0, half])),
            Start::Laid | Start::Folded => cloth.lay_here(&units, units.point([-half, -half, 0.0])),
        }
        let corners = [Node::new(0, 0), Node::new(N - 1, 0)];
        match self.pins {
            Pins::Corners | Pins::Moving => corners.into_iter().for_each(|node| cloth.pin(node)),
            Pins::Edge => (0..N).for_each(|column| cloth.pin(Node::new(column, 0))),
            Pins::Centre => cloth.pin(Node::new(N / 2, N / 2)),
            Pins::Single => cloth.pin(corners[0]),
        }
        if let Start::Folded = self.start {
            for node in Grid::<S, N, N>::nodes().filter(|node| node.row >= N / 2) {
                let over = cloth.position.at(Node::new(node.column, N - 1 - node.row));
                if !cloth.is_pinned(node) {
                    cloth.position.set(node, over + Vec3::from_f64([0.0, 0.0, 1.0]));
                }
            }
        }
    }

    fn run_on<S: Scalar, const N: usize>(&self, substeps: u32, seconds: f64) -> Found {
        let Self { size, mass, springs, frame, drag, .. } = *self;
        let (units, mut cloth) = (self.units(substeps), Box::new(Cloth::<S, N, N>::BLANK));
        self.place(&mut cloth);
        // random velocities, so that rounding does not decide where the sheet goes
        let mut lot = Lot(1);
        for node in Grid::<S, N, N>::nodes() {
            if !cloth.is_pinned(node) {
                let kick = core::array::from_fn(|_| lot.between(-0.02, 0.02));
                cloth.velocity.set(node, Vec3::from_f64(units.velocity(kick).0));
            }
        }
        let [stretch, shear, bend] = springs.map(|stiffness| units.stiffness(stiffness));
        let links = (Stretch::<S>::new(&units, stretch), Shear::new(&units, shear), Bend::new(&units, bend));
        let forces = (Gravity::new(units.acceleration(DOWN)), Drag::new(units.drag(drag)));
        let scene = Scene::new(&units, forces, links, (), Lines::new());
        let mut memory = Box::new(scene.memory::<S, N, N>());
        let unit = mass * 9.81 * size;
        let moved = |cloth: &Cloth<S, N, N>| {
            (measure::kinetic_energy(cloth, &units) + measure::gravitational_energy(cloth, &units, DOWN)) / unit
        };
        let start = moved(&cloth) + measure::elastic_energy(&cloth, &units, &scene.links) / unit;
        let (mut energy, mut speed) = (f64::NEG_INFINITY, 0.0_f64);
        let frames = (seconds / frame) as u32;
        let corner = Node::new(N - 1, 0);
        let target = cloth.position.at(corner);
        for k in 0..frames {
            let time = f64::from(k + 1) * frame;
            if matches!(self.pins, Pins::Moving) && time < 2.0 + 2.0 * frame {
                let way = if time < 2.0 { 0.3 * (std::f64::consts::PI * time).sin() * (N - 1) as f64 } else { 0.0 };
                scene.move_pin(&mut cloth, corner, target - Vec3::from_f64([way.abs(), 0.0, 0.0]));
            }
            scene.step(&mut cloth, &mut memory);
            if 2 * k > frames {
                energy = energy.max(nan_is_infinite(moved(&cloth) - start));
            }
            if f64::from(frames - k) * frame < 1.0 {
                let now = cloth.velocity.values().flat_map(Vec3::to_f64).map(|v| nan_is_infinite(v.abs()));
                speed = speed.max(now.fold(0.0, f64::max) * units.cell / units.tick());
            }
        }
        Found { strain: nan_is_infinite(measure::strain(&cloth, &scene.links.0).largest.to_f64()), energy, speed }
    }
}

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    F32,
    F64,
    Q24,
    Q13,
}

fn nan_is_infinite(x: f64) -> f64 {
    if x.is_nan() { f64::INFINITY } else { x }
}
