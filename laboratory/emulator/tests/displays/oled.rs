//! The curtain on the OLED: the board and a host compute the same motion and the same pictures.

use std::path::PathBuf;

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics_simulator::SimulatorDisplay;
use emulator::board::oled::{FIRMWARE, MACHINE, greys};
use emulator::qemu::Qemu;
use kerchief::{Scalar, measure};
use oled::show::{Room, SCREEN, Show, Stick};

use crate::figures::{self, Figures};
use crate::report::reports;

/// A cycle at 50 MHz takes twenty nanoseconds, an emulated instruction one nanosecond.
const INSTRUCTIONS_OF_A_CYCLE: u32 = 20;
/// Upper bound of a picture's instructions.
const GOAL: u32 = 1_500_000;
/// Upper bound of the stack in use, bytes.
const STACK: u32 = 40 << 10;
/// Upper bounds of the strain while the curtain swings freely, and while the joystick shakes it. With XPBD in five substeps a step the strains were 6 and 14 %.
const STRAINS: [f64; 2] = [0.01, 0.021];
const RIGHT: Stick = Stick { right: 1, away: 0 };
const FREE: Stick = Stick { right: 0, away: 0 };

#[test]
fn the_curtain_hardly_stretches() {
    let mut room = Room::BLANK;
    let mut show = Show::new(&mut room);
    let mut steps = 0;
    while show.step(FREE) {
        steps += 1;
        assert!(steps < 1200, "no rest");
        assert!(show.strain().to_f64() < STRAINS[0], "{:?} in step {steps}", show.strain());
    }
    // a minute of shaking, each direction for one or two seconds
    for step in 0..1800 {
        let stick = Stick { right: [1, -1, 0, 1, 0][step / 37 % 5], away: [0, 1, -1, 0, 0, 1][step / 53 % 6] };
        show.step(stick);
        assert!(show.strain().to_f64() < STRAINS[1], "{:?} in step {step} of shaking", show.strain());
    }
}

fn program() -> PathBuf {
    FIRMWARE.build().unwrap()[FIRMWARE.targets[0]].clone()
}

#[test]
fn the_oled_shows_what_a_host_computes() {
    let mut board = Qemu::start(MACHINE, None, &program(), 0).unwrap();
    let mut room = Room::BLANK;
    let mut show = Show::new(&mut room);
    for step in 1..=120 {
        assert_eq!(board.picture().unwrap(), step, "a picture for every step");
        assert!(show.step(FREE));
        if step == 1 || step % 20 == 0 {
            assert_same_picture(&mut board, &mut show, step);
        }
    }
    let reports = reports(&board.log().unwrap());
    let report = &reports[&120];
    assert_eq!(report.digest, measure::digest(show.cloth), "after 120 steps");
    assert_eq!((report.pictures, report.dropped), (60, 0));
    let instructions = report.cycles.map(|cycles| cycles * INSTRUCTIONS_OF_A_CYCLE);
    println!("instructions to simulate, sort, fill, transfer: {instructions:?}");
    assert!(instructions.iter().sum::<u32>() <= GOAL, "{instructions:?}");
    figures::check("oled", &Figures { parts: instructions, rate: report.rate });

    // the curtain comes to rest, and the joystick wakes it
    let mut step = 120;
    while show.step(FREE) {
        step += 1;
        assert_eq!(board.picture().unwrap(), step);
        assert!(step < 1200, "no rest");
    }
    assert!(board.rests().unwrap(), "a picture at rest, after step {step}");
    // emulated buttons read as pressed until they have been released once
    board.press("right", 100).unwrap();
    assert!(board.still_rests().unwrap(), "a button that was never up");
    board.press("right", 2000).unwrap();
    let woken = board.stopped().unwrap();
    assert!(woken > step + 1, "{woken} comes right after {step}");
    let upright = measure::bounds(show.cloth)[1].x;
    for step in woken..woken + 20 {
        assert!(show.step(RIGHT));
        if step > woken {
            assert_eq!(board.picture().unwrap(), step);
        }
    }
    assert!(measure::bounds(show.cloth)[1].x > upright, "the curtain swings to the right");
    assert_same_picture(&mut board, &mut show, woken + 19);

    let [used, size] = board.stack().unwrap();
    println!("{used} of {size} bytes of stack");
    assert!(used <= STACK, "{used} of {size} bytes of stack");
    assert_eq!(board.errors().unwrap(), "");
}

/// With instructions of 128 ns a picture takes as long as five steps: the program makes two of them and drops three.
#[test]
fn a_slow_oled_drops_steps_and_moves_as_ever() {
    let mut board = Qemu::start(MACHINE, None, &program(), 7).unwrap();
    let mut room = Room::BLANK;
    let mut show = Show::new(&mut room);
    let (mut step, mut pictures) = (0, 0);
    while step < 120 {
        let next = board.picture().unwrap();
        assert!(next - step <= 2, "{} steps between two pictures", next - step);
        pictures += 1;
        (step..next).for_each(|_| assert!(show.step(FREE)));
        step = next;
    }
    assert_same_picture(&mut board, &mut show, step);
    assert!(pictures <= 61, "{pictures} pictures");
    let reports = reports(&board.log().unwrap());
    assert!(reports.values().any(|report| report.dropped > 60), "{reports:?}");
    assert_eq!(board.errors().unwrap(), "");
}

fn assert_same_picture(board: &mut Qemu, show: &mut Show<'_>, step: u32) {
    let mut expected = SimulatorDisplay::<Gray4>::new(SCREEN);
    show.draw_rod(&mut expected).unwrap();
    show.draw(&mut expected).unwrap();
    let found = greys(board).unwrap();
    assert_eq!(Size::new(found.width(), found.height()), expected.size());
    for (x, y, grey) in found.enumerate_pixels() {
        let at = Point::new(x as i32, y as i32);
        assert_eq!(grey[0], expected.get_pixel(at).luma(), "step {step} at {at}");
    }
}
