//! Number types on an FPU: the board and a host compute the same sheets, and the board's clock agrees with a second counter.

use emulator::board::feather::{FIRMWARE, run_marked};
use emulator::counter::Counter;
use feather::race::{FRAMES, Judge, Result, race};

/// The host's results. Costs are measured on the board only.
struct Results(Vec<Result>);

impl Judge for Results {
    fn frame(&mut self, frame: impl FnOnce()) -> u64 {
        frame();
        0
    }

    fn result(&mut self, result: Result) {
        self.0.push(result);
    }
}

/// A row of the board's table: number, solver, cost, strain, digest.
fn parse(line: &str) -> Option<([String; 4], u64)> {
    let cells: Vec<_> = line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    let [number, solver, cost, strain, digest] = <[String; 5]>::try_from(cells).ok()?;
    Some(([number, solver, strain, digest], cost.parse().ok()?))
}

#[test]
fn the_feather_computes_what_a_host_computes() {
    let mut rows = Vec::new();
    let program = &FIRMWARE.build().unwrap()[FIRMWARE.targets[0]];
    let counts = run_marked(program, &Counter::build().unwrap(), |line| {
        println!("{line}");
        rows.extend(parse(line));
    })
    .unwrap();
    let mut results = Results(Vec::new());
    race(&mut results);
    let expected = results.0.iter().map(|Result { number, solver, strain, digest, .. }| {
        let strain = format!("{}.{:02} %", strain / 100, strain % 100);
        [(*number).to_owned(), (*solver).to_owned(), strain, format!("{digest:08x}")]
    });
    assert!(expected.eq(rows.iter().map(|(row, _)| row.clone())), "{rows:?} {:?}", results.0);

    // the second counter is independent of the board's clock
    let counts: Vec<_> = counts.chunks(FRAMES as usize).map(|frames| frames.iter().sum::<u64>() as f64).collect();
    assert_eq!(counts.len(), rows.len());
    for ((row, cost), count) in rows.iter().zip(counts) {
        let frame = count / f64::from(FRAMES);
        assert!((*cost as f64 - frame).abs() <= 0.01 * frame, "{row:?}: {cost} by the clock, not {frame}");
    }

    // two solvers for each of three number types, floating point first
    let cost = |row: usize| rows[row].1 as f64;
    for (solver, name) in ["XPBD", "lines"].into_iter().enumerate() {
        let [q24, q13] = [2, 4].map(|row| cost(row + solver) / cost(solver));
        println!("{name}: instructions of q24 and q13 in those of f32: {q24:.2}, {q13:.2}");
    }
    // with an FPU, the line solver is cheaper in f32 than in q24; thanks to 32-bit products, XPBD is cheaper in q13 than in f32
    assert!(cost(1) < cost(3) && cost(4) < cost(0), "{rows:?}");
}
