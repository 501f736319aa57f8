//! Partial updates: only the changed part of a picture is sent to the display.
//!
//! A sheet moves in a part of the screen. [`Dirty`] records the bounding box of everything drawn. There are two ways to use it:
//!
//! * Without a framebuffer, a [`Dirty`] display [erases](Dirty::erase) the box of the last picture before the next is drawn. This costs
//!   two rectangles, and the picture flickers.
//! * With a framebuffer, a [`Canvas`] sends the box around the last and the new picture in one transfer. Nothing flickers.
//!
//! ```
//! use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
//! use embedded_graphics::pixelcolor::{Rgb565, raw::{LittleEndian, RawU16}};
//! use embedded_graphics::{mock_display::MockDisplay, prelude::*};
//! use kerchief::{Cloth, Q24, Units, render::{Camera, Canvas, View, Wireframe}};
//!
//! const UNITS: Units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
//! const SCREEN: Size = Size::new(64, 64);
//! const VIEW: View = View::new(0.0, 20.0).fit(UNITS.point([0.0; 3]), UNITS.point([0.3, 0.0, 0.3]), SCREEN);
//! type Buffer = Framebuffer<Rgb565, RawU16, LittleEndian, 64, 64, { buffer_size::<Rgb565>(64, 64) }>;
//!
//! let cloth = Cloth::<Q24, 4, 4>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
//! let camera = Camera::new(&VIEW, SCREEN);
//! let mut canvas = Canvas::new(Buffer::new());
//! # let mut display = MockDisplay::new();
//! // for each frame
//! canvas.erase(Rgb565::BLACK)?;
//! Wireframe::new(&cloth, &camera).draw(&mut canvas)?;
//! canvas.flush(&mut display)?;
//! # Ok::<(), core::convert::Infallible>(())
//! ```

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::{Clipped, DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::primitives::{PointsIter, Rectangle};

/// A target that records the bounding box of everything drawn on it since it was last erased.
///
/// Memory: a box (16 bytes) in addition to the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dirty<D> {
    target: D,
    drawn: Extent,
}

impl<D: DrawTarget> Dirty<D> {
    /// A target on which nothing has been drawn.
    pub const fn new(target: D) -> Self {
        Self { target, drawn: Extent::EMPTY }
    }

    /// The bounding box of everything drawn since the target was last erased.
    pub fn drawn(&self) -> Rectangle {
        self.drawn.within(&self.target)
    }

    /// Fills the [drawn](Self::drawn) box with one colour, and nothing else.
    ///
    /// # Errors
    /// Errors of the target.
    pub fn erase(&mut self, color: D::Color) -> Result<(), D::Error> {
        let drawn = self.forget();
        if drawn.is_zero_sized() { Ok(()) } else { self.target.fill_solid(&drawn, color) }
    }

    /// Draws a backdrop over the [drawn](Self::drawn) box, and nowhere else.
    ///
    /// # Errors
    /// Errors of `restore`.
    pub fn restore<E>(&mut self, restore: impl FnOnce(&mut Clipped<'_, D>) -> Result<(), E>) -> Result<(), E> {
        let drawn = self.forget();
        if drawn.is_zero_sized() { Ok(()) } else { restore(&mut self.target.clipped(&drawn)) }
    }

    /// The target.
    pub fn target(&self) -> &D {
        &self.target
    }

    /// The target, by value.
    pub fn into_inner(self) -> D {
        self.target
    }

    fn forget(&mut self) -> Rectangle {
        let drawn = self.drawn();
        self.drawn = Extent::EMPTY;
        drawn
    }
}

/// A bounding box that grows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Extent {
    /// The first column and row.
    low: Point,
    /// The column and row after the last.
    high: Point,
}

impl Extent {
    /// No place of a display is further away; differences of places up to there fit 32 bits.
    const EMPTY: Self = Self { low: Point::new_equal(1 << 30), high: Point::new_equal(-(1 << 30)) };

    #[inline]
    fn add(&mut self, area: &Rectangle) {
        let (low, high) = (area.top_left, area.top_left + area.size);
        // most areas lie in the box already: tested in one comparison, since a face's rows are short
        let [left, above] = [low.x.wrapping_sub(self.low.x), low.y.wrapping_sub(self.low.y)];
        let [right, below] = [self.high.x.wrapping_sub(high.x), self.high.y.wrapping_sub(high.y)];
        if left | above | right | below < 0 && !area.is_zero_sized() {
            self.low = self.low.component_min(low);
            self.high = self.high.component_max(high);
        }
    }

    fn join(&mut self, other: &Self) {
        self.low = self.low.component_min(other.low);
        self.high = self.high.component_max(other.high);
    }

    /// The part of the box on a target.
    fn within(&self, target: &impl Dimensions) -> Rectangle {
        if self.low.x >= self.high.x {
            return Rectangle::zero();
        }
        let target = target.bounding_box();
        let low = self.low.component_max(target.top_left);
        let high = self.high.component_min(target.top_left + target.size);
        let [width, height] = [high.x - low.x, high.y - low.y].map(|side| u32::try_from(side).unwrap_or(0));
        Rectangle::new(low, Size::new(width, height))
    }
}

/// The box around two boxes, either of which may be empty.
pub(super) fn union(a: &Rectangle, b: &Rectangle) -> Rectangle {
    match (a.bottom_right(), b.bottom_right()) {
        (Some(end_a), Some(end_b)) => {
            Rectangle::with_corners(a.top_left.component_min(b.top_left), end_a.component_max(end_b))
        }
        (None, _) => *b,
        (_, None) => *a,
    }
}

impl<D: DrawTarget> Dimensions for Dirty<D> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<D: DrawTarget> DrawTarget for Dirty<D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        let (mut low, mut high) = (Point::new_equal(i32::MAX), Point::new_equal(i32::MIN));
        let seen = pixels.into_iter().inspect(|&Pixel(at, _)| {
            low = low.component_min(at);
            high = high.component_max(at);
        });
        let result = self.target.draw_iter(seen);
        if low.x <= high.x {
            self.drawn.add(&Rectangle::with_corners(low, high));
        }
        result
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), D::Error> {
        self.drawn.add(area);
        self.target.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), D::Error> {
        self.drawn.add(area);
        self.target.fill_solid(area, color)
    }

    fn clear(&mut self, color: D::Color) -> Result<(), D::Error> {
        self.drawn.add(&self.target.bounding_box());
        self.target.clear(color)
    }
}

/// A framebuffer that sends only the changed box to a display of the same size.
///
/// Boxes are clipped to the buffer when they are sent. A picture beside the buffer sends nothing; one partly beside it may send more than necessary.
///
/// Memory: the framebuffer and three boxes (48 bytes).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canvas<F> {
    /// The framebuffer, with the box drawn since the last transfer.
    buffer: Dirty<F>,
    /// The box drawn since the last erasing and already sent.
    sent: Extent,
    /// The box erased since the last transfer.
    erased: Extent,
}

impl<F: DrawTarget + GetPixel<Color = <F as DrawTarget>::Color>> Canvas<F> {
    /// A canvas on a framebuffer, for a display that shows the same as the buffer.
    pub const fn new(buffer: F) -> Self {
        Self { buffer: Dirty::new(buffer), sent: Extent::EMPTY, erased: Extent::EMPTY }
    }

    /// Fills the box of the last picture with one colour.
    ///
    /// # Errors
    /// Errors of the buffer.
    pub fn erase(&mut self, color: <F as DrawTarget>::Color) -> Result<(), F::Error> {
        self.prepare();
        self.buffer.erase(color)
    }

    /// Draws a backdrop over the box of the last picture, and nowhere else.
    ///
    /// # Errors
    /// Errors of `restore`.
    pub fn restore<E>(&mut self, restore: impl FnOnce(&mut Clipped<'_, F>) -> Result<(), E>) -> Result<(), E> {
        self.prepare();
        self.buffer.restore(restore)
    }

    /// Adds everything drawn since the last erasing, sent or not, to the erased box.
    fn prepare(&mut self) {
        self.buffer.drawn.join(&core::mem::replace(&mut self.sent, Extent::EMPTY));
        self.erased.add(&self.buffer.drawn());
    }

    /// Sends the box around everything erased or drawn since the last call, in one transfer. An empty box is not sent.
    ///
    /// # Errors
    /// Errors of the display. The next call then sends the same box again.
    pub fn flush<D: DrawTarget<Color = <F as DrawTarget>::Color>>(&mut self, display: &mut D) -> Result<(), D::Error> {
        self.send(|buffer, changed| {
            display.fill_contiguous(changed, changed.points().filter_map(|at| buffer.pixel(at)))
        })
    }

    /// As [`flush`](Self::flush), but passes the buffer and the box to `send`: for a driver that takes rows of the buffer as they are.
    ///
    /// # Errors
    /// Errors of `send`. The next call then sends the same box again.
    pub fn send<E>(&mut self, send: impl FnOnce(&F, &Rectangle) -> Result<(), E>) -> Result<(), E> {
        let mut changed = self.erased;
        changed.add(&self.buffer.drawn());
        let changed = changed.within(&self.buffer);
        if !changed.is_zero_sized() {
            send(self.buffer.target(), &changed)?;
        }
        self.erased = Extent::EMPTY;
        self.sent.add(&self.buffer.forget());
        Ok(())
    }

    /// The framebuffer.
    pub fn buffer(&self) -> &F {
        self.buffer.target()
    }
}

impl<F: DrawTarget> Dimensions for Canvas<F> {
    fn bounding_box(&self) -> Rectangle {
        self.buffer.bounding_box()
    }
}

impl<F: DrawTarget> DrawTarget for Canvas<F> {
    type Color = F::Color;
    type Error = F::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<F::Color>>>(&mut self, pixels: I) -> Result<(), F::Error> {
        self.buffer.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = F::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), F::Error> {
        self.buffer.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: F::Color) -> Result<(), F::Error> {
        self.buffer.fill_solid(area, color)
    }

    fn clear(&mut self, color: F::Color) -> Result<(), F::Error> {
        self.buffer.clear(color)
    }
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use embedded_graphics::Drawable;
    use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{BinaryColor, raw::LittleEndian, raw::RawU1};
    use embedded_graphics::primitives::{Line, Primitive, PrimitiveStyle};

    use super::*;

    type Buffer = Framebuffer<BinaryColor, RawU1, LittleEndian, 16, 8, { buffer_size::<BinaryColor>(16, 8) }>;
    const ON: PrimitiveStyle<BinaryColor> = PrimitiveStyle::with_stroke(BinaryColor::On, 1);

    fn line(from: (i32, i32), to: (i32, i32)) -> impl Drawable<Color = BinaryColor, Output = ()> {
        Line::new(Point::new(from.0, from.1), Point::new(to.0, to.1)).into_styled(ON)
    }

    /// The pixels that a new display receives. A pixel that isn't sent stays blank.
    fn sent(canvas: &mut Canvas<Buffer>) -> MockDisplay<BinaryColor> {
        let mut display = MockDisplay::new();
        canvas.flush(&mut display).unwrap();
        display
    }

    #[test]
    fn only_the_box_of_what_changed_is_sent() {
        let mut canvas = Canvas::new(Buffer::new());
        line((2, 1), (4, 3)).draw(&mut canvas).unwrap();
        sent(&mut canvas).assert_pattern(&["     ", "  #..", "  .#.", "  ..#"]);
        // The boxes of the second and the first picture together
        canvas.erase(BinaryColor::Off).unwrap();
        line((3, 4), (7, 4)).draw(&mut canvas).unwrap();
        sent(&mut canvas).assert_pattern(&["        ", "  ......", "  ......", "  ......", "  .#####"]);
        // The boxes of the third and the second picture, without the first one's
        canvas.erase(BinaryColor::Off).unwrap();
        line((6, 4), (6, 5)).draw(&mut canvas).unwrap();
        sent(&mut canvas).assert_pattern(&["        ", "        ", "        ", "        ", "   ...#.", "   ...#."]);
    }

    #[test]
    fn nothing_is_too_far_away_to_be_drawn() {
        for at in [i32::MIN, -(1 << 30), 1 << 30, i32::MAX - 1] {
            for area in [Point::new(at, 2), Point::new(3, at)] {
                let mut screen = Dirty::new(Buffer::new());
                screen.fill_solid(&Rectangle::new(area, Size::new(1, 1)), BinaryColor::On).unwrap();
                assert!(screen.drawn().is_zero_sized(), "{area}");
            }
        }
    }

    #[test]
    fn nothing_is_sent_where_nothing_changed() {
        let mut canvas = Canvas::new(Buffer::new());
        assert_eq!(sent(&mut canvas).affected_area(), Rectangle::zero());
        line((2, 1), (4, 3)).draw(&mut canvas).unwrap();
        sent(&mut canvas);
        assert_eq!(sent(&mut canvas).affected_area(), Rectangle::zero());
        line((20, 30), (40, 50)).draw(&mut canvas).unwrap();
        assert_eq!(sent(&mut canvas).affected_area(), Rectangle::zero(), "drawn beside the canvas");
        line((3, 2), (3, 2)).draw(&mut canvas).unwrap();
        sent(&mut canvas).assert_pattern(&["    ", "    ", "   #"]);
        canvas.erase(BinaryColor::Off).unwrap();
        assert_eq!(sent(&mut canvas).affected_area(), Rectangle::new(Point::new(2, 1), Size::new(3, 3)));
    }

    #[test]
    fn a_canvas_and_its_display_show_the_same_after_many_pictures() {
        let mut canvas = Canvas::new(Buffer::new());
        let mut display = Buffer::new();
        for k in 0..100 {
            canvas.erase(BinaryColor::Off).unwrap();
            line((k * 7 % 19 - 2, k * 5 % 9), (k * 3 % 17, k * 11 % 12 - 2)).draw(&mut canvas).unwrap();
            canvas.flush(&mut display).unwrap();
            assert_eq!(canvas.buffer().data(), display.data(), "picture {k}");
        }
    }

    #[test]
    fn a_backdrop_is_restored_where_something_was_drawn() {
        let mut display = MockDisplay::<BinaryColor>::new();
        display.set_allow_overdraw(true);
        let mut screen = Dirty::new(display);
        line((2, 1), (4, 2)).draw(&mut screen).unwrap();
        screen.restore(|area| line((0, 2), (15, 2)).draw(area)).unwrap();
        assert_eq!(screen.drawn(), Rectangle::zero());
        screen.restore(|_| -> Result<(), Infallible> { unreachable!("nothing was drawn since") }).unwrap();
        screen.into_inner().assert_pattern(&["     ", "  ## ", "  ###"]);
    }

    #[test]
    fn a_display_without_a_buffer_is_erased_where_something_was_drawn() {
        let mut display = MockDisplay::<BinaryColor>::new();
        display.set_allow_overdraw(true);
        let mut screen = Dirty::new(display);
        line((2, 1), (4, 2)).draw(&mut screen).unwrap();
        assert_eq!(screen.drawn(), Rectangle::new(Point::new(2, 1), Size::new(3, 2)));
        screen.erase(BinaryColor::Off).unwrap();
        line((1, 0), (1, 1)).draw(&mut screen).unwrap();
        assert_eq!(screen.drawn(), Rectangle::new(Point::new(1, 0), Size::new(1, 2)));
        screen.into_inner().assert_pattern(&[" #   ", " #...", "  ..."]);
    }
}
