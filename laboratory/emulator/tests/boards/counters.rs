//! Two independent counters agree: the boards' clock, which gives the published figures, and a QEMU plugin.

use std::path::Path;
use std::thread;

use cases::bench::counted;
use emulator::Firmware;
use emulator::counter::Counter;
use emulator::machine::{M0, M3, M4F, Machine};

use crate::figures::TICK;
use crate::measure::USUAL;

/// Largest relative difference of the two counters.
const TOLERANCE: f64 = 0.01;

#[test]
fn the_clock_of_the_boards_agrees_with_a_second_counter() {
    compare_in(USUAL);
}

#[test]
#[ignore = "long: the same in the other number types"]
fn the_clock_of_the_boards_agrees_with_a_second_counter_in_every_number_type() {
    ["f32", "q13"].into_iter().for_each(compare_in);
}

fn compare_in(number: &str) {
    let machines = [M0, M3, M4F];
    let targets = machines.map(|machine| machine.target);
    let programs = Firmware::measuring("instructions", &targets, [Some(number), None]).build().unwrap();
    let counter = &Counter::build().unwrap();
    let differences: Vec<_> = thread::scope(|scope| {
        let compare = |machine: &'static Machine| scope.spawn(|| compare(machine, &programs[machine.target], counter));
        let runs = [&M0, &M3, &M4F].map(compare);
        runs.into_iter().flat_map(|run| run.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    });
    assert!(differences.is_empty(), "the counters disagree:\n{}", differences.join("\n"));
}

/// A message for every scene whose counts differ.
fn compare(machine: &Machine, program: &Path, counter: &Counter) -> Vec<String> {
    let (printed, counts) = machine.run_marked(program, counter).unwrap();
    let mut counts = counts.into_iter();
    let mut differences = Vec::new();
    for line in printed.lines() {
        let [_, scene, clock, ..] = line.split("; ").collect::<Vec<_>>()[..] else {
            panic!("{} prints {line:?}", machine.name);
        };
        let clock: u64 = clock.parse().expect("a number");
        let Some(count) = counts.next() else { panic!("{}: no marks around {scene}", machine.name) };
        let second = count / u64::from(counted(scene));
        println!("{}, {scene}: {clock} by the clock, {second} by the second counter", machine.name);
        // reading the clock is counted, too, and matters in short frames
        if clock.abs_diff(second) as f64 > (TOLERANCE * second as f64).max(TICK as f64) {
            differences.push(format!("{}, {scene}: {clock} by the clock, not {second}", machine.name));
        }
    }
    assert_eq!(counts.next(), None, "{}: more marks than scenes", machine.name);
    differences
}
