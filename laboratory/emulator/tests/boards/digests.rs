//! Sheets move identically, to the last bit, on every machine.

use std::collections::BTreeMap;
use std::thread;

use cases::{CASES, METHODS, NUMBERS, TABLE};
use emulator::Firmware;
use emulator::machine::{ALL, M0, M4F, Machine, WASM};

/// The digest after every frame, by scene, solver and number type.
type Trails = BTreeMap<[String; 3], Vec<u32>>;

/// A processor without a unit for `f32`, one with it, and WebAssembly.
const FEW: [&Machine; 3] = [&M0, &M4F, &WASM];

#[test]
fn digests_are_the_same_on_a_few_machines() {
    compare_on(&FEW);
}

#[test]
#[ignore = "long: the digests on every other machine"]
fn digests_are_the_same_on_every_machine() {
    let others: Vec<_> = ALL.iter().filter(|machine| !FEW.iter().any(|few| few.name == machine.name)).collect();
    compare_on(&others);
}

fn compare_on(machines: &[&'static Machine]) {
    let mut targets: Vec<_> = machines.iter().map(|machine| machine.target).collect();
    targets.sort_unstable();
    targets.dedup();
    let firmware = Firmware { profile: "small", ..Firmware::measuring("digests", &targets, [None; 2]) };
    let programs = firmware.build().unwrap();
    let expected = here();
    let differences: Vec<_> = thread::scope(|scope| {
        let (programs, expected) = (&programs, &expected);
        let run = |machine: &&'static Machine| {
            let machine = *machine;
            scope.spawn(move || compare(machine, expected, &parse(&machine.run(&programs[machine.target]).unwrap())))
        };
        let runs: Vec<_> = machines.iter().map(run).collect();
        runs.into_iter().flat_map(|run| run.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    });
    assert!(differences.is_empty(), "sheets moved otherwise:\n{}", differences.join("\n"));
}

/// The digests of this host, frame by frame. The last of each run is compared with the table.
fn here() -> Trails {
    let mut trails = Trails::new();
    for case in &CASES {
        for method in METHODS {
            let solver = format!("{method:?}");
            let row = TABLE.iter().find(|row| (row.0, row.1) == (case.name, solver.as_str()));
            let (_, _, expected) = row.expect("the table has a row for each scene and solver");
            for (number, last) in NUMBERS.iter().zip(expected) {
                let mut trail = Vec::new();
                let outcome = (number.play)(case, method, &mut |digest| trail.push(digest));
                assert!(outcome.finite, "{} by {solver} in {}", case.name, number.name);
                let key = [case.name, &solver, number.name].map(str::to_owned);
                assert_eq!(trail.last(), Some(last), "{key:?}: here and in the table");
                trails.insert(key, trail);
            }
        }
    }
    trails
}

fn parse(printed: &str) -> Trails {
    let row = |line: &str| {
        let mut words = line.split(' ').map(str::to_owned);
        let key = std::array::from_fn(|_| words.next().expect("scene, solver, number"));
        let digest = |word: String| u32::from_str_radix(&word, 16).expect("a digest");
        (key, words.map(digest).collect())
    };
    printed.lines().map(row).collect()
}

fn compare(machine: &Machine, expected: &Trails, found: &Trails) -> Vec<String> {
    let boards = NUMBERS.iter().filter(|number| number.name != "f64" || machine.target.starts_with("wasm"));
    let names: Vec<_> = boards.map(|number| number.name).collect();
    let expected = expected.iter().filter(|([.., number], _)| names.contains(&number.as_str()));
    let count = expected.clone().count();
    let mut differences = Vec::new();
    for (key @ [scene, solver, number], expected) in expected {
        let place = format!("{}: {scene} by {solver} in {number}", machine.name);
        match found.get(key) {
            None => differences.push(format!("{place} is missing")),
            Some(found) if found != expected => {
                let frame = expected.iter().zip(found).take_while(|(expected, found)| expected == found).count();
                differences.push(format!("{place} differs from frame {} on", frame + 1));
            }
            Some(_) => {}
        }
    }
    if found.len() != count {
        differences.push(format!("{}: {} runs instead of {count}", machine.name, found.len()));
    }
    differences
}
