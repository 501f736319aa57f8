//! The largest sheets on a board with 64 KB of RAM.

use emulator::Firmware;
use emulator::machine::M3;

/// A scene of the firmware `capacity`, with the figures of `docs/fixed-point.md`.
struct Large {
    scene: &'static str,
    /// Bytes of the sheet, the solver's memory, the renderer and the picture.
    variables: u32,
    /// Upper bound of the stack in use, bytes.
    stack: u32,
}

const LARGE: [Large; 2] = [
    Large { scene: "xpbd", variables: 49_220, stack: 2_400 },
    Large { scene: "lines", variables: 45_648, stack: 4_020 },
];

#[test]
fn large_sheets_fit_64_kilobytes_with_their_picture_and_stack() {
    for Large { scene, variables, stack } in LARGE {
        let targets = [M3.target];
        let firmware =
            Firmware { features: "graphics", ..Firmware::measuring("capacity", &targets, [None, Some(scene)]) };
        let printed = M3.run(&firmware.build().unwrap()[M3.target]).unwrap();
        let mut fields = printed.trim_end().split("; ");
        let name = fields.next().expect("a name").to_owned();
        let mut number = || fields.next().and_then(|field| field.parse::<u32>().ok()).expect("a number");
        let [bytes, used, all, lit] = [number(), number(), number(), number()];
        assert_eq!(bytes, variables, "{name}");
        assert!(used <= stack, "{name}: {used} bytes of stack");
        assert!(bytes + used <= all && all <= 1 << 16, "{name}: {bytes} and {used} of {all}");
        // the sheet covers a third of the screen
        assert!((1_000..128 * 64).contains(&lit), "{name}: {lit} pixels are drawn");
    }
}
