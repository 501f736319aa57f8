//! The flag of 8 × 8 particles and its picture on the LEDs, brighter where it blows towards the viewer.

use kerchief::scene::Only;
use kerchief::solver::Stateless;
use kerchief::{Cloth, Gravity, Node, PanelWind, Q13, Scalar, Scene, Shear, Sheet, Stretch, Vec3, Xpbd};

use crate::leds::{BRIGHTEST, LEDS};

/// Particles a side.
const SIDE: usize = 8;
/// Steps in a second.
pub const RATE: u32 = 60;

/// A flag of 7 m × 7 m.
const SHEET: Sheet<Q13, SIDE, SIDE> = Sheet::new([7.0, 7.0], 0.2, 1.0 / RATE as f64, 1);
/// The strongest wind that the buttons set.
const STRONGEST: u32 = 3;

type Forces = (Gravity<Q13>, PanelWind<Q13>);
type Springs = (Stretch<Q13>, Shear<Q13>);

/// The flag, its scene and the wind.
#[derive(Debug)]
pub struct Show {
    /// The flag.
    pub cloth: Cloth<Q13, SIDE, SIDE>,
    scene: Scene<Forces, Springs, (), Xpbd, Only<Q13, SIDE, SIDE>>,
    /// The strength of the wind in units of 3 m/s: 0 is calm.
    wind: u32,
    /// Steps since the start.
    step: u32,
}

impl Show {
    /// A flag that hangs from its pole, in wind.
    pub fn new() -> Self {
        let mut cloth = SHEET.hang([0.0; 3]);
        (0..SIDE).for_each(|row| cloth.pin(Node::new(0, row)));
        let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.panel_wind([0.0; 3], 1.2, 1.2));
        let links = (SHEET.stretch(5_000.0), SHEET.shear(500.0));
        Self { cloth, scene: SHEET.scene(forces, links, (), Xpbd::new()), wind: 2, step: 0 }
    }

    /// Makes the wind stronger or weaker.
    pub fn press(&mut self, more: bool) {
        self.wind = if more { (self.wind + 1).min(STRONGEST) } else { self.wind.saturating_sub(1) };
    }

    /// Advances the flag by a step.
    pub fn step(&mut self) {
        /// 3 m/s, in 2⁻²⁴ cells per tick.
        const UNIT: i32 = (SHEET.units.velocity([3.0, 0.0, 0.0]).0[0] * (1 << 24) as f64) as i32;
        self.step += 1;
        let strength = UNIT * self.wind as i32;
        // the wind turns from side to side
        let aside = (strength >> 6) * swing(self.step);
        self.scene.forces.1.wind = Vec3::new(Q13::from_bits(strength), Q13::from_bits(aside), Q13::ZERO);
        self.scene.step(&mut self.cloth, &mut Stateless::new());
    }

    /// The brightness of each LED: the depth of the cloth in front of it, dark where there is none. Row 0 is the top row.
    pub fn picture(&self) -> [[u32; LEDS]; LEDS] {
        let mut sums = [[(0, 0); LEDS]; LEDS];
        for place in self.cloth.position.values() {
            // a LED is 1.6 cells wide; the flag may sink to the lowest row
            let at = |cells: Q13| usize::try_from((cells + Q13::HALF).round_times(40) >> 6).ok();
            let (Some(column), Some(row)) = (at(place.x), at(-place.z)) else { continue };
            if let Some((depth, count)) = sums.get_mut(row).and_then(|row| row.get_mut(column)) {
                *depth += place.y.round_times(16);
                *count += 1;
            }
        }
        // half as bright in the plane of the pole; a cell nearer or further changes the brightness by 1
        let level = |(depth, count): (i32, i32)| {
            if count == 0 {
                0
            } else {
                ((40 - depth.checked_div(count).unwrap_or(0)) >> 4).clamp(1, BRIGHTEST as i32) as u32
            }
        };
        sums.map(|row| row.map(level))
    }
}

/// A triangle wave of 90 steps, from −64 to 64.
fn swing(step: u32) -> i32 {
    let phase = (step % 90) as i32;
    let rising = if phase < 45 { phase } else { 90 - phase };
    (rising * 128 / 45) - 64
}
