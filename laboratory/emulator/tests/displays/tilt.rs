//! The kerchief on the round LCD: with the same gesture, the board and a host compute the same motion and the same pictures.

use std::sync::OnceLock;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics_simulator::SimulatorDisplay;
use emulator::board::lcd::{Run, SIDE};
use emulator::board::tilt::{FIRMWARE, Gesture, Plan, gesture, run};
use kerchief::{Scalar, measure};
use tilt::show::{RATE, SCREEN, Show, WEIGHT};

use crate::figures::{self, Figures};
use crate::report::{Report, reports};

/// Upper bound of the stack in use, bytes.
const STACK: usize = 32 << 10;
/// Clock frequency, Hz.
const FREQUENCY: u32 = 200_000_000;
/// Upper bound of the steps between two pictures in motion.
const MOST: u32 = 2;
/// Lower bound of the pictures in a second while the board is in the hand.
const RATE_IN_HAND: u32 = 30;
/// Largest difference of a reading from the gesture by noise and rounding, g.
const NOISE: f64 = 0.0025;
/// Upper bounds of the strain: in the gesture, and in long shaking.
const STRAINS: [f64; 2] = [0.02, 0.03];
/// Amplitudes of the shaking, g.
const SHAKES: [f64; 4] = [1.5, 2.5, 3.0, 4.0];
/// Seconds of shaking for each amplitude.
const SHAKEN: u32 = 60;
/// Numbers of the pictures that are compared.
const SHOTS: [usize; 10] = [1, 2, 40, 80, 130, 180, 230, 280, 330, 380];

fn play(plan: &Plan) -> Run {
    let run = run(&FIRMWARE.build().unwrap()[FIRMWARE.targets[0]], plan, |_| {}).unwrap();
    assert_eq!(run.errors, [""; 0]);
    run
}

/// The run through the whole gesture, until the kerchief rests. It is shared by all tests.
fn shown() -> &'static Run {
    static RUN: OnceLock<Run> = OnceLock::new();
    RUN.get_or_init(|| play(&Plan { shots: Some(SHOTS.to_vec()), ..Plan::default() }))
}

/// Converts the sensor's axes to the display's: right, away from the viewer, up.
fn turned([x, y, z]: [i32; 3]) -> [i32; 3] {
    [-y, z, -x]
}

/// The force of the gesture at a time, g, interpolated linearly.
fn felt(gesture: &Gesture, seconds: f64) -> [f64; 3] {
    let next = gesture.partition_point(|row| row[0] <= seconds);
    let [from, to] = [next.saturating_sub(1), next.min(gesture.len() - 1)].map(|row| gesture[row]);
    let part = if to[0] > from[0] { (seconds - from[0]) / (to[0] - from[0]) } else { 0.0 };
    [1, 2, 3].map(|axis| from[axis] + part * (to[axis] - from[axis]))
}

#[test]
fn the_board_in_a_hand_shows_what_a_host_computes() {
    let run = shown();
    println!("{} pictures; {:?} bytes of stack; {:#?}", run.steps.len(), run.stack, run.log);
    assert!(run.stack[0] <= STACK, "{:?}", run.stack);
    assert_eq!(run.frequency, FREQUENCY);
    let reports = reports(&run.log);

    let mut show = Show::new();
    let mut readings = run.readings.iter().map(|(_, axes)| axes.map(i32::from));
    let mut shots = run.shots.iter();
    let (mut before, mut largest) = (0, 0.0_f64);
    let mut rests = Vec::new();
    for (picture, last) in (1_usize..).zip(&run.steps) {
        let changed: Vec<_> = (before..*last)
            .map(|_| {
                if show.is_attentive() {
                    show.feel(turned(readings.next().expect("the board has read as often")));
                }
                let changed = show.step();
                largest = largest.max(show.strain().to_f64());
                changed
            })
            .collect();
        let still = changed.iter().take_while(|changed| !**changed).count();
        assert!(changed.len() - still <= MOST as usize, "no picture from step {before} to {last}");
        assert!(still < changed.len(), "a picture of nothing new after step {last}");
        if still > 0 {
            rests.push(still);
        }
        before = *last;
        if SHOTS.contains(&picture) {
            assert_same_picture(shots.next().expect("a shot of this picture"), &mut show, *last);
        }
        if let Some(report) = reports.get(last) {
            assert_eq!(report.digest, measure::digest(&show.cloth), "after step {last}");
        }
    }
    assert_eq!(shots.len(), 1, "there are as many pictures as shots of them, and one at rest");
    assert_same_picture(shots.next().expect("a shot at rest"), &mut show, before);
    println!("the largest strain is {:.2} %; at rest for {rests:?} steps", 100.0 * largest);
    assert!(largest <= STRAINS[0], "{largest}");
    assert!(rests.iter().sum::<usize>() > 5, "it rests on the table, and the hand wakes it: {rests:?}");

    // the kerchief stays at rest in spite of the sensor's noise
    let mut asked = 0;
    while readings.len() > 0 {
        if show.is_attentive() {
            show.feel(turned(readings.next().expect("a reading")));
            asked += 1;
        }
        assert!(!show.step(), "the board rests, the host does not");
    }
    assert!(asked > 5, "the sensor is asked {asked} times in a second of rest");
    let [bytes, awake] = run.idle.expect("the kerchief comes to rest");
    println!("awake for {awake} cycles in a second of rest");
    assert_eq!(bytes, 0, "bytes to the display at rest");
    assert!(awake <= FREQUENCY / 100, "awake for {awake} cycles in a second of rest");

    let held: Vec<_> = reports.range(300..540).map(|(_, report)| report).collect();
    let mean = |of: &dyn Fn(&Report) -> u32| held.iter().map(|report| of(report)).sum::<u32>() / held.len() as u32;
    let parts = [0, 1, 2, 3].map(|part| mean(&|report| report.cycles[part]));
    let rate = mean(&|report| report.rate);
    println!("in the hand: {parts:?} cycles to simulate, sort, fill, wait for the transfer; {rate} pictures a second");
    assert!(held.iter().all(|report| report.rate >= RATE_IN_HAND), "{held:?}");
    figures::check("tilt", &Figures { parts, rate });
}

#[test]
fn the_sensor_says_what_the_hand_does() {
    let gesture = gesture();
    let run = shown();
    let mut largest = 0.0_f64;
    for (then, axes) in &run.readings {
        for (axis, expected) in axes.iter().zip(felt(&gesture, *then)) {
            let found = f64::from(*axis) / f64::from(WEIGHT);
            assert!((found - expected).abs() <= NOISE, "{found} and {expected} after {then} s");
            largest = largest.max(found.abs());
        }
    }
    assert!(largest > 2.0, "nobody shakes it: {largest}");
}

#[test]
fn a_board_without_a_sensor_says_so_and_hangs_its_kerchief_down() {
    const STEPS: u32 = 30;
    let run = play(&Plan { until: Some(STEPS), sensor: false, ..Plan::default() });
    assert_eq!(run.log, ["warn: no QMI8658 answers: gravity stays the display's"]);
    assert_eq!(run.readings, []);
    let mut show = Show::new();
    let last = *run.steps.last().expect("a picture");
    assert!((0..last).all(|_| show.step()));
    assert_same_picture(run.shots.last().expect("a shot"), &mut show, last);
    let [pegs, hung] = [&Show::new(), &show].map(|show| measure::bounds(&show.cloth)[0].z);
    assert!(hung < pegs, "it does not hang below its pegs");
}

#[test]
fn shaking_hardly_stretches_the_kerchief() {
    for weights in SHAKES {
        // along each axis, with a different period each
        let wave = |step: u32, period: f64| (weights * f64::from(WEIGHT) * (f64::from(step) / period).sin()) as i32;
        let mut show = Show::new();
        let (mut largest, mut nearest, mut farthest) = (0.0_f64, 0.0_f64, 0.0_f64);
        for step in 0..SHAKEN * RATE {
            show.feel([wave(step, 2.9), wave(step, 3.7), wave(step, 5.3) + WEIGHT]);
            assert!(show.step(), "it rests");
            largest = largest.max(show.strain().to_f64());
            let [near, far] = measure::bounds(&show.cloth).map(|corner| corner.y.to_f64());
            (nearest, farthest) = (nearest.min(near), farthest.max(far));
        }
        println!("the largest strain in {SHAKEN} s by {weights} weights is {:.2} %", 100.0 * largest);
        assert!(largest <= STRAINS[1], "{largest} by {weights} weights");
        // the kerchief must fly, by more than two cells to both sides of its pegs
        assert!(nearest < -2.0 && farthest > 2.0, "{nearest} to {farthest} by {weights} weights");
    }
}

#[test]
fn the_sensor_cannot_say_too_much() {
    let mut show = Show::new();
    for force in [i16::MIN, i16::MAX] {
        show.feel([i32::from(force); 3]);
        assert!(show.step());
    }
    assert!(measure::is_finite(&show.cloth));
}

fn assert_same_picture(shot: &[u16], show: &mut Show, step: u32) {
    let mut expected = SimulatorDisplay::<Rgb565>::new(SCREEN);
    show.draw_back(&mut expected).unwrap();
    show.draw(&mut expected).unwrap();
    for (place, pixel) in (0..).zip(shot) {
        let at = Point::new(place % SIDE as i32, place / SIDE as i32);
        assert_eq!(*pixel, RawU16::from(expected.get_pixel(at)).into_inner(), "step {step} at {at}");
    }
}
