//! The flag on a small OLED, with the `ssd1306` driver.

use emulator::board::ssd1306::{FIRMWARE, run};
use emulator::photograph::photograph;
use emulator::root;

/// `cargo emulate ssd1306 --steps 40 --png docs/ssd1306.png` writes the expected picture.
const PICTURES: u32 = 40;
/// Upper bound of the time: twenty pictures a second, and 150 ms for the start.
const MILLISECONDS: f64 = 50.0 * PICTURES as f64 + 150.0;

#[test]
fn the_small_oled_shows_its_picture() {
    let run = run(&FIRMWARE.build().unwrap()[FIRMWARE.targets[0]], PICTURES, |_| {}).unwrap();
    assert_eq!(run.errors, [""; 0]);
    assert!(run.on, "the display is off");
    assert!(run.milliseconds < MILLISECONDS, "{} ms for {PICTURES} pictures", run.milliseconds);
    let expected = image::open(root().join("docs/ssd1306.png")).unwrap().to_rgb8();
    assert!(photograph(&run.picture(), 5, 1) == expected, "docs/ssd1306.png is another picture");
}
