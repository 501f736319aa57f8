//! Lines of text above and below the picture, without covering it.

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_7X13};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Text;

/// Size of the window, pixels.
pub const SIZE: Size = Size::new(640, ABOVE + 600 + BELOW);
/// The picture's place in the window.
pub const PICTURE: Rectangle = Rectangle::new(Point::new(0, ABOVE as i32), Size::new(640, 600));
/// Heights of the captions above the picture (four lines) and below it (two lines), pixels.
const ABOVE: u32 = 72;
const BELOW: u32 = 40;

const LINE: i32 = 16;
const INDENT: i32 = 8;
/// Characters in a line.
pub(super) const WIDEST: usize = (SIZE.width as usize - 2 * INDENT as usize) / 7;

const PAPER: Rgb888 = Rgb888::new(250, 249, 246);
const INK: Rgb888 = Rgb888::new(60, 64, 72);
const ALARM: Rgb888 = Rgb888::new(170, 30, 30);

pub(super) const KEYS: [&str; 2] = [
    "p pin  w wind  arrows tilt  s solver  n number  space pause  r reset  q quit",
    "left button drags the sheet  beside it, or right button: turn  wheel zooms",
];

/// The text above the picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Caption {
    pub(super) state: [String; 2],
    pub(super) complaint: String,
}

impl Caption {
    pub(super) fn draw<D: DrawTarget<Color = Rgb888>>(&self, target: &mut D) -> Result<(), D::Error> {
        let below = SIZE.height - BELOW;
        target.fill_solid(&Rectangle::new(Point::zero(), Size::new(SIZE.width, ABOVE)), PAPER)?;
        target.fill_solid(&Rectangle::new(Point::new(0, below as i32), Size::new(SIZE.width, BELOW)), PAPER)?;
        let complaint = wrapped(&self.complaint);
        let above = self.state.iter().map(|line| (&**line, INK)).chain(complaint.iter().map(|line| (&**line, ALARM)));
        for (number, (line, ink)) in (1..).zip(above) {
            write(line, LINE * number, ink, target)?;
        }
        (1..).zip(KEYS).try_for_each(|(number, line)| write(line, below as i32 + LINE * number, INK, target))
    }
}

/// Writes a line of text with its baseline at `base`.
fn write<D: DrawTarget<Color = Rgb888>>(line: &str, base: i32, ink: Rgb888, target: &mut D) -> Result<(), D::Error> {
    Text::new(line, Point::new(INDENT, base), MonoTextStyle::new(&FONT_7X13, ink)).draw(target).map(drop)
}

/// Wraps a text into at most two lines; a longer text ends with dots.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let full = lines.len() == 2;
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= WIDEST => {
                line.push(' ');
                line.push_str(word);
            }
            Some(line) if full => {
                *line = line.chars().take(WIDEST - 4).collect::<String>() + " ...";
                break;
            }
            _ => lines.push(word.chars().take(WIDEST).collect()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_fits_the_window() {
        assert!(KEYS.iter().all(|line| line.len() <= WIDEST));
        let guide = include_str!("../../../../docs/guide/simulate.md");
        assert!(KEYS.iter().all(|line| guide.lines().any(|said| said == *line)), "the guide has the same lines");
        let long = "stretch.stiffness: too small for q24 in this cell size, mass and step: rounding would change it by more than a sixteenth";
        let lines = wrapped(long);
        assert_eq!(lines.join(" "), long);
        assert!(lines.len() == 2 && lines.iter().all(|line| line.len() <= WIDEST), "{lines:?}");
        let lines = wrapped(&long.repeat(3));
        assert!(lines.len() == 2 && lines.iter().all(|line| line.len() <= WIDEST), "{lines:?}");
        assert!(lines[1].ends_with(" ..."));
        assert_eq!(wrapped(&"x".repeat(200)), ["x".repeat(WIDEST)]);
        assert!(wrapped("").is_empty());
    }
}
