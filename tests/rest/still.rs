//! A still picture is neither drawn nor sent.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::pixelcolor::{Rgb565, raw::LittleEndian, raw::RawU16};
use embedded_graphics::prelude::*;
use kerchief::render::{Camera, Canvas, View, Wireframe};
use kerchief::{Gravity, Lines, Q24};

use crate::{DOWN, UNITS, curtain, resting};

type Buffer = Framebuffer<Rgb565, RawU16, LittleEndian, 64, 64, { buffer_size::<Rgb565>(64, 64) }>;

/// A display that counts received pixels and transfers.
#[derive(Default)]
struct Counting {
    pixels: u64,
    transfers: u64,
}

impl OriginDimensions for Counting {
    fn size(&self) -> Size {
        Size::new(64, 64)
    }
}

impl DrawTarget for Counting {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.transfers += 1;
        self.pixels += pixels.into_iter().count() as u64;
        Ok(())
    }
}

#[test]
fn a_still_picture_sends_nothing() {
    let (mut scene, mut cloth) = curtain::<Q24, _>(resting(Lines::default()));
    let mut memory = scene.memory();
    let middle = UNITS.point([0.15, 0.0, 0.15]);
    let camera = Camera::new(&View::new(0.0, 0.0).at(middle, UNITS.length(0.5)), Size::new(64, 64));
    let mut canvas = Canvas::new(Buffer::new());
    let mut display = Counting::default();
    // one frame as the programs for boards have it; returns whether it drew
    let mut frame = |scene: &_, display: &mut Counting| {
        let scene: &crate::Described<Q24, _> = scene;
        let before = memory.is_at_rest();
        scene.step_one(&mut cloth, &mut memory);
        let still = before && memory.is_at_rest();
        if !still {
            let Ok(()) = canvas.erase(Rgb565::BLACK);
            let Ok(()) = Wireframe::new(&cloth, &camera).draw(&mut canvas);
        }
        let Ok(()) = canvas.flush(display);
        !still
    };
    let drawn = (0..3600).take_while(|_| frame(&scene, &mut display)).count();
    assert!(drawn > 60 && drawn < 3600, "{drawn} pictures until it rests");
    assert!(
        display.transfers >= drawn as u64 && display.pixels > 100 * drawn as u64,
        "the sheet is not in the picture"
    );
    let mut display = Counting::default();
    for _ in 0..1000 {
        assert!(!frame(&scene, &mut display), "drawn at rest");
    }
    assert_eq!((display.pixels, display.transfers), (0, 0), "sent at rest");
    // and it wakes
    scene.forces.0 = Gravity::new(UNITS.acceleration([3.0, 0.0, DOWN[2]]));
    (0..10).for_each(|_| {
        frame(&scene, &mut display);
    });
    assert!(display.transfers > 5 && display.pixels > 500, "the sheet woke, and is not sent");
}
