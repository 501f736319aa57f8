//! Common parts of the lessons: a number from the command line, distances, times, and a plot.

use std::error::Error;
use std::ops::Range;
use std::time::Instant;
use std::{env, fs};

use plotters::prelude::*;

/// Width and height of a plot, and the width of its legend, pixels.
const SIZE: (u32, u32) = (840, 480);
const LEGEND: i32 = 190;
/// Width and height of the area between the axes, pixels.
const AREA: (f64, f64) = (556.0, 385.0);
const FONT: &str = "sans-serif";

/// Colours that are distinguishable with every colour vision (M. Okabe, K. Ito, *Color universal design*, 2008).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(70, 70, 70),
];

/// The first argument of the program, or `default` if it has none.
///
/// # Panics
/// If the argument is not a number.
pub fn argument(default: f64) -> f64 {
    env::args().nth(1).map_or(default, |word| word.parse().expect("the argument is a number"))
}

/// The largest distance between the particles of two sheets.
pub fn farthest(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let apart = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    a.iter().zip(b).map(apart).fold(0.0, f64::max)
}

/// The shortest duration of twenty runs of `work`, s.
pub fn shortest_time(mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..20).map(time).fold(f64::MAX, f64::min)
}

/// A point at which a curve is interrupted.
pub const GAP: [f64; 3] = [f64::NAN; 3];

/// Curves over two axes.
#[derive(Clone, Debug)]
pub struct Plot {
    title: &'static str,
    axes: [&'static str; 2],
    powers: [bool; 2],
    one_scale: bool,
    curves: Vec<(String, Vec<(f64, f64)>)>,
}

impl Plot {
    /// A plot without curves. `axes` are the names of the horizontal and the vertical axis.
    pub const fn new(title: &'static str, axes: [&'static str; 2]) -> Self {
        Self { title, axes, powers: [false; 2], one_scale: false, curves: Vec::new() }
    }

    /// Chooses logarithmic axes: horizontal, vertical.
    #[must_use]
    pub fn in_powers_of_ten(self, powers: [bool; 2]) -> Self {
        Self { powers, ..self }
    }

    /// Gives both axes the same scale.
    #[must_use]
    pub fn at_one_scale(self) -> Self {
        Self { one_scale: true, ..self }
    }

    /// Adds a curve. It is interrupted at points that are not finite.
    pub fn curve(&mut self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) {
        let [across, up] = self.powers.map(|powers| move |x: f64| if powers { x.log10() } else { x });
        let points = points.into_iter().map(|(x, y)| (across(x), up(y))).collect();
        self.curves.push((name.into(), points));
    }

    /// Writes the plot as `out/lessons/NAME.svg`.
    ///
    /// # Panics
    /// If it cannot be written.
    pub fn write(&self, name: &str) {
        let mut svg = String::new();
        self.draw(&mut svg).expect("the plot can be drawn");
        fs::create_dir_all("out/lessons").expect("a place for the plot");
        fs::write(format!("out/lessons/{name}.svg"), svg).expect("the plot is written");
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
        root.fill(&WHITE)?;
        let (left, right) = root.split_horizontally(SIZE.0 as i32 - LEGEND);
        let (mut across, mut up) = (self.range(|point| point.0), self.range(|point| point.1));
        if self.one_scale {
            let metre = (AREA.0 / (across.end - across.start)).min(AREA.1 / (up.end - up.start));
            (across, up) = (widened(&across, AREA.0 / metre), widened(&up, AREA.1 / metre));
        }
        let mut chart = ChartBuilder::on(&left)
            .caption(self.title, (FONT, 19))
            .margin(12)
            .x_label_area_size(46)
            .y_label_area_size(70)
            .build_cartesian_2d(across, up)?;
        let [label_across, label_up] = self.powers.map(|powers| move |value: &f64| label(*value, powers));
        chart
            .configure_mesh()
            .x_desc(self.axes[0])
            .y_desc(self.axes[1])
            .x_label_formatter(&label_across)
            .y_label_formatter(&label_up)
            .label_style((FONT, 14))
            .axis_desc_style((FONT, 15))
            .light_line_style(TRANSPARENT)
            .draw()?;
        let mut height = 56;
        for ((name, points), colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
            for piece in points.split(|point| !(point.0 + point.1).is_finite()) {
                chart.draw_series(LineSeries::new(piece.iter().copied(), colour.stroke_width(2)))?;
            }
            right.draw(&PathElement::new([(0, height), (22, height)], colour.stroke_width(2)))?;
            right.draw(&Text::new(name.as_str(), (28, height - 6), (FONT, 14)))?;
            height += 22;
        }
        root.present()?;
        Ok(())
    }

    /// The range of one coordinate over all curves, with a small margin at each end.
    fn range(&self, of: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let all = self.curves.iter().flat_map(|(_, points)| points).map(of).filter(|value| value.is_finite());
        let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        let room = 0.04 * (high - low).max(1e-9);
        low - room..high + room
    }
}

/// A range with the same middle and the given length.
fn widened(range: &Range<f64>, length: f64) -> Range<f64> {
    let middle = 0.5 * (range.start + range.end);
    middle - 0.5 * length..middle + 0.5 * length
}

/// The label of a place on an axis: a number without the rounding errors of its last digits, or a power of ten with two digits.
fn label(place: f64, powers: bool) -> String {
    if !powers {
        return format!("{}", (place * 1e6).round() / 1e6 + 0.0);
    }
    match place {
        -2.1..4.0 => format!("{:.*}", (1.0 - place.floor()).max(0.0) as usize, 10_f64.powf(place)),
        _ => format!("{:.0e}", 10_f64.powf(place)),
    }
}
