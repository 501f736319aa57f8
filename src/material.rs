//! Materials, and the springs that make a grid behave like them.
//!
//! A [`Material`] contains the constants of a thin sheet. They belong to the fabric and are independent of any grid. [`Material::units`] and
//! [`Material::springs`] turn them into the mass of a particle and the stiffness of the links of a grid:
//!
//! ```
//! use kerchief::material::{DENIM, Springs};
//! use kerchief::{Bend, Cloth, Q24, Shear, Stretch, Units};
//!
//! const UNITS: Units = DENIM.units([16, 16], [0.3, 0.3], 1.0 / 60.0, 16);
//! const SPRINGS: Springs = DENIM.springs(&UNITS, 0.5);
//!
//! let mut cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
//! cloth.share_area();
//! let links = (
//!     Stretch::<Q24>::new(&UNITS, UNITS.stiffness(SPRINGS.stretch)),
//!     Shear::<Q24>::new(&UNITS, UNITS.stiffness(SPRINGS.shear)),
//!     Bend::<Q24>::new(&UNITS, UNITS.stiffness(SPRINGS.bend)),
//! );
//! ```
//!
//! # From the membrane to springs
//!
//! A membrane strained by ε₁ along rows, ε₂ along columns and sheared by the angle γ stores the energy per area
//!
//! `½·C·(ε₁² + ε₂²) + C₁₂·ε₁·ε₂ + ½·G·γ²`.
//!
//! In a large grid each square cell of side a has one stretch and one bend spring in either direction, and two diagonals. To first order a stretch spring is
//! elongated by a·ε, a bend spring by 2·a·ε, and a diagonal by a·(ε₁ + ε₂ ± γ)/√2. Together they store
//!
//! `½·(k_stretch + 4·k_bend)·(ε₁² + ε₂²) + ½·k_shear·((ε₁ + ε₂)² + γ²)`
//!
//! per area, for every a. Comparison gives `k_shear = G` and `k_stretch = C − G − 4·k_bend`; C₁₂ equals G, as springs leave no choice there. Two properties
//! differ from the membrane. Links on the border have a cell on one side only and are twice as stiff as they should be, as a selvage is. And a cell of a × b
//! would need springs b/a times as stiff along a as along b: cells should be square.
//!
//! # Bend springs
//!
//! A plate of rigidity B bent by the angle θ between neighbouring cells stores ½·B·θ² in each cell of the fold. A bend spring connects a particle to the next
//! but one. It is shortened by 2·a·(1 − cos ½θ) ≈ ¼·a·θ² and stores 1/32·k·a²·θ⁴. This is negligible while the sheet is nearly flat, and more than the plate's
//! energy when it is sharply folded. The two energies are equal at one angle, the `fold` of [`Material::springs`], if
//!
//! `k_bend = 16·B/(a·θ)²`
//!
//! (to first order: the energy is 1 % too small at 0.5 rad, 4 % at 1 rad). Choose the angle of the folds that the sheet shows: a fold of radius R has θ = a/R.
//!
//! # The presets
//!
//! Eight fabrics measured by H. Wang, J. F. O'Brien and R. Ramamoorthi (*Data-driven elastic models for cloth: modeling and measurement*, 2011). Each is listed
//! with its name in their database, which the simulator `ARCSim` contains. The values are the area density, and to three digits the coefficients c₁₁, c₂₂ and
//! c₃₃ of `stretching` for the sheet at rest (N/m) and k of `bending` across weft and warp for the flat sheet (N·m).
//!
//! They are interpreted as in `ARCSim`, which doubles c and stores ½·2·(c₁₁·ε₁² + c₂₂·ε₂² + c₃₃·(½·γ)²) per area, besides the term in ε₁·ε₂. So C is 2·c₁₁
//! along the weft and 2·c₂₂ along the warp, here their mean, and G is ½·c₃₃. In `ARCSim` a hinge of length l between two triangles of area A together stores
//! k·l²/(2·A)·θ²/4, which is ⅛·k·κ² per area at the curvature κ. So B is ¼·k, here the mean of both directions.
//!
//! The coefficients are valid for small strains: fabrics stiffen when they are stretched, springs don't. The database contains neither silk nor wool, and no
//! damping.

use crate::units::Units;

/// The constants of a thin sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Mass per area, kg/m².
    pub density: f64,
    /// C, tension per strain in a strip of constrained width, N/m. Springs are equal along rows and columns, so it is the mean of both.
    pub stretch: f64,
    /// G, shear force per length and angle, N/m.
    pub shear: f64,
    /// B, moment per length and curvature, N·m.
    pub bend: f64,
    /// The time constant τ of internal damping after W. Voigt, s: a damper τ·k is parallel to a spring k. Zero in the presets. The dampers of
    /// [`Damped`](crate::Damped) slow a link's rotation as much as its stretching, which no fabric does: keep τ small.
    pub damping: f64,
}

/// The stiffness of a grid's springs, N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Springs {
    /// For [`Stretch`](crate::Stretch).
    pub stretch: f64,
    /// For [`Shear`](crate::Shear).
    pub shear: f64,
    /// For [`Bend`](crate::Bend).
    pub bend: f64,
}

impl Material {
    /// The units of a sheet of this material: [`Units::sheet`] with the mass of one cell as the mass of a particle.
    ///
    /// [`Cloth::share_area`](crate::Cloth::share_area) gives particles on the border their smaller share, so that the sheet's mass is `density` times its area.
    ///
    /// # Panics
    /// As [`Units::sheet`].
    #[track_caller]
    pub const fn units(&self, particles: [usize; 2], size: [f64; 2], frame: f64, substeps: u32) -> Units {
        let across = if particles[0] > 1 { size[0] / (particles[0] - 1) as f64 } else { size[0] };
        let down = if particles[1] > 1 { size[1] / (particles[1] - 1) as f64 } else { size[1] };
        Units::sheet(particles, size, self.density * across * down, frame, substeps)
    }

    /// The springs of a grid of square cells that behaves like this material. Its bending rigidity is matched in folds by the angle `fold` (rad) between
    /// neighbouring cells.
    ///
    /// For a scene without bend springs pass an infinite `fold`.
    ///
    /// # Panics
    /// At compile time in a constant: if no stiffness is left for stretch springs, because `fold` is too flat an angle for so small a cell.
    #[track_caller]
    pub const fn springs(&self, units: &Units, fold: f64) -> Springs {
        let span = units.cell * fold;
        let bend = 16.0 * self.bend / (span * span);
        let stretch = self.stretch - self.shear - 4.0 * bend;
        assert!(
            stretch > 0.0,
            "bend springs this stiff leave nothing for stretch springs: choose a sharper fold or larger cells"
        );
        Springs { stretch, shear: self.shear, bend }
    }

    /// The damper (N·s/m) parallel to a spring of `stiffness` (N/m).
    pub const fn damper(&self, stiffness: f64) -> f64 {
        self.damping * stiffness
    }

    /// From c₁₁, c₂₂, c₃₃ and k across weft and warp: see "The presets" in the module's documentation.
    const fn measured(density: f64, [c11, c22, c33]: [f64; 3], [weft, warp]: [f64; 2]) -> Self {
        Self { density, stretch: c11 + c22, shear: c33 / 2.0, bend: (weft + warp) / 8.0, damping: 0.0 }
    }
}

/// Interlock for T-shirts, 60 % cotton, 40 % polyester ("gray interlock").
pub const INTERLOCK: Material = Material::measured(0.187, [16.6, 34.5, 36.9], [23.2e-6, 14.3e-6]);

/// Rib knit for underwear, 95 % cotton, 5 % elastane ("ivory rib knit").
pub const RIB_KNIT: Material = Material::measured(0.276, [42.9, 65.2, 83.2], [46.2e-6, 32.2e-6]);

/// Ponte Roma, a firm knit for jackets, 60 % polyester, 40 % rayon ("camel ponte roma").
pub const PONTE_ROMA: Material = Material::measured(0.284, [31.1, 44.0, 31.9], [36.3e-6, 37.2e-6]);

/// Denim of 11 ounces, 99 % cotton, 1 % elastane ("11oz black denim").
pub const DENIM: Material = Material::measured(0.324, [205.0, 1010.0, 53.4], [64.2e-6, 97.0e-6]);

/// Cloth for trousers, 65 % cotton, 35 % polyester ("royal target").
pub const TROUSERS: Material = Material::measured(0.220, [2020.0, 2030.0, 105.0], [125e-6, 125e-6]);

/// Light cloth for jackets, polyester ("tango red jet set").
pub const JACKET: Material = Material::measured(0.113, [43.1, 171.0, 14.3], [14.3e-6, 20.3e-6]);

/// Tablecloth, polyester ("white dots on black").
pub const TABLECLOTH: Material = Material::measured(0.128, [2000.0, 2030.0, 19.2], [51.7e-6, 31.3e-6]);

/// Blanket, polyester ("pink ribbon brown").
pub const BLANKET: Material = Material::measured(0.228, [152.0, 245.0, 30.3], [117e-6, 59.8e-6]);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Bend, Cloth, Damped, Leapfrog, Node, Scene, Shear, Stretch, Vec3, measure};

    const CELL: f64 = 0.02;

    fn units(particles: [usize; 2]) -> Units {
        DENIM.units(particles, particles.map(|count| CELL * (count - 1) as f64), 0.02, 4)
    }

    fn links(units: &Units, springs: Springs) -> (Stretch<f64>, Shear<f64>, Bend<f64>) {
        (
            Stretch::new(units, units.stiffness(springs.stretch)),
            Shear::new(units, units.stiffness(springs.shear)),
            Bend::new(units, units.stiffness(springs.bend)),
        )
    }

    /// The energy of a square sheet of `N` × `N` particles under a small strain, J.
    fn strained<const N: usize>(material: Material, fold: f64, across: f64, down: f64, shear: f64) -> f64 {
        let units = units([N, N]);
        let mut cloth = Cloth::<f64, N, N>::lay(&units, units.point([0.0; 3]));
        cloth.position.change(|Vec3 { x, y, .. }| Vec3::new(x + across * x + shear * y, y + down * y, 0.0));
        let springs = material.springs(&units, fold);
        measure::elastic_energy(&cloth, &units, &links(&units, springs))
    }

    #[test]
    fn springs_store_the_energy_of_the_membrane() {
        const SMALL: f64 = 1e-5;
        let fabrics = [INTERLOCK, RIB_KNIT, PONTE_ROMA, DENIM, TROUSERS, JACKET, TABLECLOTH, BLANKET];
        for (material, fold) in fabrics.into_iter().flat_map(|fabric| [(fabric, 0.3), (fabric, f64::INFINITY)]) {
            for [across, down, shear] in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, -0.4, 0.7]] {
                let [across, down, shear] = [across, down, shear].map(|strain| strain * SMALL);
                let energy = [
                    strained::<6>(material, fold, across, down, shear),
                    strained::<7>(material, fold, across, down, shear),
                    strained::<8>(material, fold, across, down, shear),
                ];
                // a sheet of n² cells stores n²·inside + n·border + corners: the second difference is twice the energy of an inner cell
                let inside = 0.5 * (energy[0] - 2.0 * energy[1] + energy[2]);
                let Material { stretch, shear: modulus, .. } = material;
                let expected = 0.5 * stretch * (across * across + down * down)
                    + modulus * across * down
                    + 0.5 * modulus * shear * shear;
                let found = inside / (CELL * CELL);
                assert!((found - expected).abs() < 1e-3 * expected, "{material:?}: {found} {expected}");
            }
        }
    }

    /// The energy of a sheet of 5 × 4 particles folded by an angle along its middle column, J.
    fn folded(links: impl Fn(&Units) -> Bend<f64>, angle: f64) -> f64 {
        let units = units([5, 4]);
        let mut cloth = Cloth::<f64, 5, 4>::lay(&units, units.point([-2.0 * CELL, 0.0, 0.0]));
        cloth.position.change(|Vec3 { x, y, z }| {
            if x > 0.0 { Vec3::new(x * libm::cos(angle), y, x * libm::sin(angle)) } else { Vec3::new(x, y, z) }
        });
        measure::elastic_energy(&cloth, &units, &links(&units))
    }

    #[test]
    fn bend_springs_store_the_energy_of_the_plate_at_their_angle_only() {
        for fold in [0.3, 0.5, 1.0] {
            let bend = |units: &Units| links(units, DENIM.springs(units, fold)).2;
            // a fold of one cell's width in each of the 4 rows
            let plate = |angle: f64| 4.0 * 0.5 * DENIM.bend * angle * angle;
            let at_fold = folded(bend, fold) / plate(fold);
            let expected = 1.0 - fold * fold / 24.0;
            assert!((at_fold - expected).abs() < 0.002, "{fold}: {at_fold}");
            // at half the angle a quarter of the plate's energy
            let flatter = folded(bend, fold / 2.0) / plate(fold / 2.0);
            assert!((flatter - 0.25).abs() < 0.01, "{fold}: {flatter}");
        }
    }

    #[test]
    fn a_sheet_weighs_its_density_times_its_area() {
        let units = DENIM.units([7, 5], [0.3, 0.2], 0.02, 4);
        let mut cloth = Cloth::<f64, 7, 5>::lay(&units, units.point([0.0; 3]));
        cloth.share_area();
        let mass: f64 = cloth.inverse_mass.values().map(|inverse| units.mass / inverse).sum();
        assert!((mass - 0.324 * 0.06).abs() < 1e-15, "{mass}");
    }

    /// A particle on a spring k with its damper oscillates as exp(−δ·t)·cos(ω·t) up to a phase, with 2·δ = τ·k/m and ω² = k/m − δ². After one period its
    /// velocity is zero again.
    #[test]
    fn dampers_slow_an_oscillation_as_voigts_element_does() {
        let (stiffness, mass) = (10.0, 1e-3);
        let damper = Material { damping: 2e-3, ..DENIM }.damper(stiffness);
        let decay = damper / (2.0 * mass);
        let period = core::f64::consts::TAU / libm::sqrt(stiffness / mass - decay * decay);
        let units = Units::sheet([2, 1], [0.1, 0.1], mass, period / 16.0, 64);
        let mut cloth = Cloth::<f64, 2, 1>::lay(&units, units.point([0.0; 3]));
        cloth.pin(Node::new(0, 0));
        let elongation = 0.1;
        cloth.position.0[0].x[1] += elongation;
        let spring = Stretch::new(&units, units.stiffness(stiffness));
        let scene = Scene::new(&units, (), Damped::new(spring, units.damping(damper)), (), Leapfrog);
        let mut memory = scene.memory();
        for _ in 0..16 {
            scene.step(&mut cloth, &mut memory);
        }
        let found = (cloth.position.0[0].x[1] - 1.0) / elongation;
        let expected = libm::exp(-decay * period);
        assert!((found - expected).abs() < 1e-5, "{found} {expected}");
    }
}
