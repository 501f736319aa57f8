//! The flag on the Pico's LCD: the board and a host move and draw alike.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics_simulator::SimulatorDisplay;
use kerchief::measure;

use crate::pico_board::{Plan, SIDE, build, run};
use crate::pico_show::{SCREEN, Show};
use crate::report::reports;

/// Steps.
const STEPS: u32 = 120;
/// Bytes of stack that may be used.
const STACK: usize = 48 << 10;
/// After this picture the button is pressed, and after that one released.
const PRESSED: (usize, usize) = (30, 32);

#[test]
fn the_pico_shows_what_a_host_computes() {
    let plan = Plan {
        until: STEPS,
        shots: vec![1, 2, 20, 40, usize::MAX],
        presses: vec![(PRESSED.0, true), (PRESSED.1, false)],
    };
    let run = run(&build(), &plan).unwrap();
    assert_eq!(run.errors, [""; 0]);
    println!("{} pictures of {STEPS} steps; {:?} bytes of stack; {:?}", run.steps.len(), run.stack, run.log);
    assert!(run.stack[0] <= STACK, "{:?}", run.stack);
    let reports = reports(&run.log);
    assert_eq!(reports.len(), 2, "a line for every 60 steps");

    let mut show = Show::new();
    let mut shots = run.shots.iter();
    let mut before = 0;
    for (picture, step) in (1..).zip(&run.steps) {
        // the board looks at its button before it makes a picture's steps
        if picture == PRESSED.0 + 1 {
            show.press();
        }
        assert!((before + 1..=before + 2).contains(step), "{before} is followed by {step}");
        (before..*step).for_each(|_| assert!(show.step()));
        before = *step;
        if let Some(report) = reports.get(step) {
            assert_eq!(report.digest, measure::digest(&show.cloth), "after step {step}");
        }
        if plan.shots.contains(&picture) || picture == run.steps.len() {
            let shot = shots.next().expect("a shot of this picture");
            assert_same_picture(shot, &mut show, *step);
        }
    }
    assert!(before >= STEPS && shots.next().is_none());
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
