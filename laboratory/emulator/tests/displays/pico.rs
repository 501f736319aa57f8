//! The flag on the Pico's LCD: the board and a host compute the same motion and the same pictures.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics_simulator::SimulatorDisplay;
use emulator::board::lcd::{Run, SIDE};
use emulator::board::pico::{FIRMWARE, Plan, run};
use kerchief::{Scalar, measure};
use pico::show::{RATE, SCREEN, Show};

use crate::figures::{self, Figures};
use crate::report::{Report, reports};

/// Upper bound of the stack in use, bytes.
const STACK: usize = 32 << 10;
/// Pictures after which the button is pressed; it is released two pictures later.
const PRESSED: [usize; 2] = [122, 132];
/// Clock frequency, Hz.
const FREQUENCY: u32 = 200_000_000;
/// Lower bound of the pictures in a second.
const PICTURES: u32 = 60;
/// Seconds of gusts that the host simulates.
const PLAYED: u32 = 200;
/// Upper bound of the strain in these gusts.
const STRAIN: f64 = 0.02;

/// Numbers of the pictures that are compared.
const SHOTS: [usize; 9] = [1, 2, 20, 60, 115, 124, 125, 134, 142];

fn play(plan: &Plan) -> Run {
    let run = run(&FIRMWARE.build().unwrap()[FIRMWARE.targets[0]], plan, |_| {}).unwrap();
    assert_eq!(run.errors, [""; 0]);
    run
}

/// The run from the start to the rest, without the model of the flash's cache. It is shared by all tests.
fn shown() -> &'static Run {
    static RUN: OnceLock<Run> = OnceLock::new();
    RUN.get_or_init(|| {
        let presses = PRESSED.into_iter().flat_map(|picture| [(picture, true), (picture + 2, false)]).collect();
        play(&Plan { until: None, shots: SHOTS.to_vec(), presses, cached: false })
    })
}

#[test]
fn the_pico_shows_what_a_host_computes() {
    let run = shown();
    println!("{} pictures; {:?} bytes of stack; {:#?}", run.steps.len(), run.stack, run.log);
    assert!(run.stack[0] <= STACK, "{:?}", run.stack);
    assert_eq!(run.frequency, FREQUENCY);
    let reports = reports(&run.log);

    let mut show = Show::new();
    let mut shots = run.shots.iter();
    let mut before = 0;
    for (picture, step) in (1_usize..).zip(&run.steps) {
        // when a picture appears, the step of the next one has already been made
        if PRESSED.contains(&picture.saturating_sub(2)) {
            show.press();
        }
        assert_eq!(*step, before + 1, "a picture for each step");
        assert!(show.step(), "a picture of nothing new");
        before = *step;
        if SHOTS.contains(&picture) {
            let shot = shots.next().expect("a shot of this picture");
            assert_same_picture(shot, &mut show, *step);
        }
        if let Some(report) = reports.get(step) {
            assert_eq!(report.digest, measure::digest(&show.cloth), "after step {step}");
            // the next pictures show this rate
            show.note(report.rate, FREQUENCY / 1_000_000);
            assert!(report.rate >= PICTURES, "{} pictures a second", report.rate);
        }
    }
    assert_same_picture(shots.next().expect("a shot at rest"), &mut show, before);
    assert!(!show.step(), "the board rests before the host");
    let [bytes, awake] = run.idle.expect("the cloth comes to rest");
    println!("awake for {awake} cycles in a second of rest");
    assert_eq!(bytes, 0, "bytes to the display at rest");
    assert!(awake <= FREQUENCY / 1000, "awake for {awake} cycles in a second of rest");

    let gusts = flying(&reports);
    println!(
        "{:?} cycles to simulate, sort, fill, wait for the transfer; {} pictures a second",
        gusts.cycles, gusts.rate
    );
    figures::check("pico", &Figures { parts: gusts.cycles, rate: gusts.rate });
}

/// The second line of the log: a flag in gusts, without the costs of the start.
fn flying(reports: &BTreeMap<u32, Report>) -> &Report {
    reports.values().nth(1).expect("two lines")
}

#[test]
fn the_cache_of_its_flash_costs_the_pico_no_picture() {
    let cached = play(&Plan { until: Some(121), cached: true, ..Plan::default() });
    let [direct, cached] = [shown(), &cached].map(|run| {
        let reports = reports(&run.log);
        let Report { digest, cycles, rate, .. } = flying(&reports);
        (*digest, cycles.iter().sum::<u32>(), *rate)
    });
    println!("cycles of a picture without and with the model of the cache: {} and {}", direct.1, cached.1);
    assert_eq!((direct.0, direct.2), (cached.0, cached.2));
    assert!(cached.1 > direct.1, "the model counts nothing");
}

#[test]
fn gusts_strain_the_flag_of_the_pico_by_less_than_two_percent() {
    let mut show = Show::new();
    let strains = (0..PLAYED * RATE).map(|_| {
        assert!(show.step(), "a flag in wind that rests");
        let strain = measure::strain(&show.cloth, show.stretch()).largest;
        assert_eq!(show.strain(), strain, "what the display shows");
        strain.to_f64()
    });
    let largest = strains.fold(0.0, f64::max);
    println!("the largest strain in {PLAYED} s is {:.2} %", 100.0 * largest);
    assert!(largest <= STRAIN, "{largest}");
    // the flag must fly, not hang
    assert!(largest > STRAIN / 10.0, "{largest}");
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
