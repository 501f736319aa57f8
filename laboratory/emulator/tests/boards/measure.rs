//! Measures the figures on the emulated boards, and compares the committed ones with them.

use std::collections::BTreeMap;
use std::thread;

use cases::bench::{self, Bench, SIDE, WARM_UP, counted};
use emulator::Firmware;
use emulator::machine::{M0, M3, M4F};
use kerchief::force::Force;
use kerchief::{Cloth, Collider, Links, Scalar, Scene, Solver, measure};

use crate::figures::{self, Figure, TICK};
use crate::image::Image;
use crate::{report, rules};

/// The number type whose figures are measured in every test run.
pub(crate) const USUAL: &str = "q24";

#[test]
fn figures_of_q24_are_those_that_are_published() {
    check(|number| number == USUAL);
    report::check(&figures::read());
}

#[test]
#[ignore = "long: the figures of every other number type, and all of them where they are written"]
fn figures_are_those_that_are_published() {
    if std::env::var_os("UPDATE_INSTRUCTIONS").is_some() {
        let found = measured(|_| true);
        figures::write(&found);
        report::write(&found);
    }
    check(|number| number != USUAL);
    report::check(&figures::read());
}

/// Compares the committed figures of some number types with measured ones.
fn check(is_wanted: impl Fn(&str) -> bool) {
    let found = measured(&is_wanted);
    let committed: Vec<_> = figures::read().into_iter().filter(|figure| is_wanted(&figure.number)).collect();
    let differences = figures::differences(&committed, &found);
    let help = "`UPDATE_INSTRUCTIONS=1 cargo test -p emulator --test boards -- --ignored published` writes them anew";
    assert!(differences.is_empty(), "other figures than the published ones ({help}):\n{}", differences.join("\n"));
    nothing_is_free(&found);
    rest_is_cheap(&found);
}

/// Parts that a scene doesn't name cost nothing: a scene with `()` for each of them takes the flash and memory of the bare scene, and its instructions within a tick.
fn nothing_is_free(figures: &[Figure]) {
    for bare in figures.iter().filter(|figure| figure.scene == "bare") {
        let unnamed = figures.iter().find(|figure| figure.number == bare.number && figure.scene == "unnamed");
        let unnamed = unnamed.expect("both are measured");
        assert_eq!((bare.flash, bare.memory), (unnamed.flash, unnamed.memory), "in {}", bare.number);
        for (bare, unnamed) in bare.instructions().into_iter().zip(unnamed.instructions()) {
            assert!(bare.abs_diff(unnamed) <= TICK, "{bare} {unnamed}");
        }
    }
}

/// A sheet at rest costs at most a hundredth of a sheet in motion, by XPBD and by the line solver.
fn rest_is_cheap(figures: &[Figure]) {
    for moving in figures.iter().filter(|figure| ["xpbd", "lines"].contains(&figure.scene.as_str())) {
        let rest = figures.iter().find(|figure| figure.number == moving.number && figure.scene == "xpbd, at rest");
        let rest = rest.expect("both are measured");
        for (in_motion, at_rest) in moving.instructions().into_iter().zip(rest.instructions()) {
            assert!(100 * at_rest <= in_motion, "{at_rest} of {in_motion}: {} in {}", moving.scene, moving.number);
        }
    }
}

/// The figures of every scene in some number types.
fn measured(is_wanted: impl Fn(&str) -> bool) -> Vec<Figure> {
    let mut here = Here::default();
    bench::play_all(&mut here);
    here.0.retain(|played| is_wanted(played.number));
    let mut numbers: Vec<_> = here.0.iter().map(|scene| scene.number).collect();
    numbers.dedup();
    // boards count while the other programs are linked
    thread::scope(|scope| {
        let flash = scope.spawn(|| here.0.iter().map(linked).collect::<Vec<_>>());
        let counted: Vec<_> = numbers.into_iter().flat_map(|number| executed(number, &here)).collect();
        let flash = flash.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        counted.into_iter().zip(flash).map(|(figure, flash)| Figure { flash, ..figure }).collect()
    })
}

/// The figures of all scenes in a number type as the boards print them: instructions and bytes of RAM.
fn executed(number: &str, here: &Here) -> Vec<Figure> {
    let machines = [M0, M3, M4F];
    let targets = machines.map(|machine| machine.target);
    let firmware = Firmware::measuring("instructions", &targets, [Some(number), None]);
    let programs = firmware.build().unwrap();
    let [m0, m3, m4f] = machines.map(|machine| {
        let printed = machine.run_counted(&programs[machine.target]).unwrap();
        printed.lines().map(|line| parse(line, machine.name, here)).collect::<Vec<_>>()
    });
    let expected = here.0.iter().filter(|scene| scene.number == number).count();
    assert_eq!([m0.len(), m3.len(), m4f.len()], [expected; 3], "a line for every scene");
    let order = here.0.iter().filter(|scene| scene.number == number).map(|scene| scene.scene);
    assert!(order.eq(m0.iter().map(|figure| figure.scene.as_str())), "boards meet scenes in another order");
    let scenes = m0.into_iter().zip(m3).zip(m4f);
    scenes.map(|((m0, m3), m4f)| Figure { m3: m3.m0, m4f: m4f.m0, ..m0 }).collect()
}

/// Parses a line of the firmware `instructions`. Its count is stored in `m0`, whatever the processor.
fn parse(line: &str, machine: &str, here: &Here) -> Figure {
    let fields: Vec<_> = line.split("; ").collect();
    let &[number, scene, instructions, cloth, memory, digest] = fields.as_slice() else {
        panic!("{machine} prints {line:?}");
    };
    let [m0, cloth, memory] = [instructions, cloth, memory].map(|field| field.parse().expect("a number"));
    let expected = here.0.iter().find(|known| (known.number, known.scene) == (number, scene)).expect("a scene");
    assert_eq!(digest, format!("{:08x}", expected.digest), "{machine}: {scene} in {number} moved otherwise");
    Figure { number: number.into(), scene: scene.into(), m0, cloth, memory, ..Figure::default() }
}

/// The flash of a program with a single scene, checked against the [`rules`].
fn linked(played: &Played) -> u64 {
    let Played { number, scene, .. } = *played;
    let only = [Some(number), Some(scene)];
    let targets = [M0.target];
    let firmware = Firmware::measuring("footprint", &targets, only);
    let image = Image::read(&firmware.build().unwrap()[M0.target]);
    rules::check(&image, number, scene);
    assert_eq!(image.ram, 0, "{scene} in {number} has variables of its own");
    image.flash
}

/// The result of a scene on this host.
#[derive(Clone, Copy, Debug)]
struct Played {
    number: &'static str,
    scene: &'static str,
    digest: u32,
}

#[derive(Debug, Default)]
struct Here(Vec<Played>);

impl Bench for Here {
    const NUMBER: Option<&'static str> = None;
    const SCENE: Option<&'static str> = None;

    fn scene<S, F, L, C, V>(&mut self, name: &'static str, scene: &Scene<F, L, C, V>, mut cloth: Cloth<S, SIDE, SIDE>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
    {
        let mut memory = scene.memory();
        for _ in 0..WARM_UP + counted(name) {
            scene.step_one(&mut cloth, &mut memory);
        }
        self.0.push(Played { number: S::NAME, scene: name, digest: measure::digest(&cloth) });
    }
}

/// The largest strain of a stretch link at the end of a frame, in the first second by the line solver, for each number type.
pub(crate) fn strains() -> BTreeMap<&'static str, f64> {
    let mut strains = Strains::default();
    bench::play_all(&mut strains);
    strains.0
}

#[derive(Debug, Default)]
struct Strains(BTreeMap<&'static str, f64>);

impl Bench for Strains {
    const NUMBER: Option<&'static str> = None;
    const SCENE: Option<&'static str> = Some("lines");

    fn scene<S, F, L, C, V>(&mut self, _name: &'static str, scene: &Scene<F, L, C, V>, mut cloth: Cloth<S, SIDE, SIDE>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
    {
        let mut memory = scene.memory();
        let mut largest = 0.0_f64;
        for _ in 0..60 {
            scene.step_one(&mut cloth, &mut memory);
            largest = largest.max(bench::stretch_strain(&cloth));
        }
        self.0.insert(S::NAME, largest);
    }
}
