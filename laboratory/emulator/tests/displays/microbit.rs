//! The flag on the micro:bit's LEDs: the board and a host compute the same motion and the same brightness.

use emulator::board::microbit::{FIRMWARE, levels, start};
use kerchief::measure;
use microbit::leds::BRIGHTEST;
use microbit::show::Show;

/// Upper bound of the stack in use, bytes.
const STACK: u32 = 8 << 10;

#[test]
fn the_microbit_shows_what_a_host_computes() {
    let mut board = start(&FIRMWARE.build().unwrap()[FIRMWARE.targets[0]]).unwrap();
    let mut show = Show::new();
    let mut log = Vec::new();
    let mut seen = [false; BRIGHTEST as usize + 1];
    for step in 1..=120 {
        assert_eq!(board.picture().unwrap(), step, "a picture for every step");
        show.step();
        let levels = levels(&mut board).unwrap();
        assert_eq!(levels, show.picture(), "step {step}");
        levels.into_iter().flatten().for_each(|level| seen[level as usize] = true);
        if step % 60 == 0 {
            log.push(format!("info: step {step}, digest {:08x}, late 0", measure::digest(&show.cloth)));
        }
    }
    assert_eq!(board.log().unwrap(), log, "no step takes longer than a 60th of a second");
    assert_eq!(seen, [true; BRIGHTEST as usize + 1], "levels that shone");
    let [used, size] = board.stack().unwrap();
    println!("{used} of {size} bytes of stack");
    assert!(used <= STACK, "{used} of {size} bytes of stack");
    assert_eq!(board.errors().unwrap(), "");
}
