//! The flag on the Pico's LCD: the board and a host move and draw alike.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics_simulator::SimulatorDisplay;
use emulator::board::pico::{FIRMWARE, Plan, SIDE, run};
use kerchief::measure;
use pico::show::{SCREEN, Show};

use crate::figures::{self, Figures};
use crate::report::reports;

/// Bytes of stack that may be used.
const STACK: usize = 48 << 10;
/// After these pictures the button is pressed, and two pictures later released.
const PRESSED: [usize; 2] = [110, 120];
/// 125 MHz.
const FREQUENCY: u32 = 125_000_000;
/// Pictures in a second, at least.
const RATE: u32 = 30;
/// Cycles to simulate for a picture, at most: 7 ms, of which the wind on every cell takes one and a half.
const SIMULATE: u32 = FREQUENCY / 1000 * 7;

#[test]
fn the_pico_shows_what_a_host_computes() {
    let presses = PRESSED.into_iter().flat_map(|picture| [(picture, true), (picture + 2, false)]).collect();
    let plan = Plan { until: None, shots: vec![1, 2, 20, 60, 90, 111, 125], presses };
    let run = run(&FIRMWARE.build().unwrap()[FIRMWARE.targets[0]], &plan, |_| {}).unwrap();
    assert_eq!(run.errors, [""; 0]);
    println!("{} pictures; {:?} bytes of stack; {:#?}", run.steps.len(), run.stack, run.log);
    assert!(run.stack[0] <= STACK, "{:?}", run.stack);
    let reports = reports(&run.log);

    let mut show = Show::new();
    let mut shots = run.shots.iter();
    let mut before = 0;
    for (picture, step) in (1..).zip(&run.steps) {
        // the board looks at its button before it makes a picture's steps
        if PRESSED.contains(&(picture - 1)) {
            show.press();
        }
        assert!((before + 1..=before + 2).contains(step), "{before} is followed by {step}");
        // of two steps the second may find the sheet at rest
        assert!((before..*step).fold(false, |changed, _| changed | show.step()), "a picture of nothing new");
        before = *step;
        if plan.shots.contains(&picture) {
            let shot = shots.next().expect("a shot of this picture");
            assert_same_picture(shot, &mut show, *step);
        }
        if let Some(report) = reports.get(step) {
            assert_eq!(report.digest, measure::digest(&show.cloth), "after step {step}");
            // what it shows from the next picture on
            show.note(report.rate);
        }
    }
    assert_same_picture(shots.next().expect("a shot at rest"), &mut show, before);
    assert!(!show.step(), "the board rests before the host");
    assert_eq!(run.idle, Some(0), "bytes to the display at rest");

    // the second line of the log: a flag in gusts, without what the start costs
    let gusts = reports.values().nth(1).expect("two lines");
    let [cycles, rate] = [gusts.cycles.iter().sum::<u32>(), gusts.rate];
    println!("{:?} cycles to simulate, sort, fill, transfer: {cycles}; {rate} pictures a second", gusts.cycles);
    assert!(rate >= RATE, "{rate} pictures a second");
    assert!(gusts.cycles[0] <= SIMULATE, "{:?}", gusts.cycles);
    figures::check("pico", &Figures { parts: gusts.cycles, rate });
}

fn assert_same_picture(shot: &[u16], show: &mut Show, step: u32) {
    let mut expected = SimulatorDisplay::<Rgb565>::new(SCREEN);
    show.draw_sky(&mut expected).unwrap();
    show.draw(&mut expected).unwrap();
    for (place, pixel) in (0..).zip(shot) {
        let at = Point::new(place % SIDE as i32, place / SIDE as i32);
        assert_eq!(*pixel, RawU16::from(expected.get_pixel(at)).into_inner(), "step {step} at {at}");
    }
}
