//! Two counters that share nothing agree: the boards' clock, whose figures are published, and a plugin of the emulator.

use std::thread;

use cases::bench::counted;
use emulator::Firmware;
use emulator::counter::Counter;
use emulator::machine::{M0, M3, M4F, Machine};

use crate::figures::TICK;
use crate::measure::USUAL;

/// How far apart they may be.
const TOLERANCE: f64 = 0.01;

#[test]
fn the_clock_of_the_boards_agrees_with_a_second_counter() {
    let machines = [M0, M3, M4F];
    let targets = machines.map(|machine| machine.target);
    let programs = Firmware::measuring("instructions", &targets, [Some(USUAL), None]).build().unwrap();
    let counter = &Counter::build().unwrap();
    let differences: Vec<_> = thread::scope(|scope| {
        let compare = |machine: &'static Machine| scope.spawn(|| compare(machine, &programs[machine.target], counter));
        let runs = [&M0, &M3, &M4F].map(compare);
        runs.into_iter().flat_map(|run| run.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    });
    assert!(differences.is_empty(), "the counters disagree:\n{}", differences.join("\n"));
}

/// Every scene of which they count something else.
fn compare(machine: &Machine, program: &std::path::Path, counter: &Counter) -> Vec<String> {
    let (printed, counts) = machine.run_marked(program, counter).unwrap();
    let mut counts = counts.into_iter();
    let mut differences = Vec::new();
    for line in printed.lines() {
        let [_, scene, clock, ..] = line.split("; ").collect::<Vec<_>>()[..] else {
            panic!("{} prints {line:?}", machine.name);
        };
        let clock: u64 = clock.parse().expect("a number");
        let frames = counted(scene) as usize;
        let own: Vec<_> = counts.by_ref().take(frames).collect();
        assert_eq!(own.len(), frames, "{}: frames of {scene} without marks", machine.name);
        let second = own.iter().sum::<u64>() / frames as u64;
        println!("{}, {scene}: {clock} by the clock, {second} by the second counter", machine.name);
        // a frame at rest takes no more than the clock tells apart
        if clock.abs_diff(second) as f64 > (TOLERANCE * second as f64).max(2.0 * TICK as f64) {
            differences.push(format!("{}, {scene}: {clock} by the clock, not {second}", machine.name));
        }
    }
    assert_eq!(counts.next(), None, "{}: more marks than frames", machine.name);
    differences
}
