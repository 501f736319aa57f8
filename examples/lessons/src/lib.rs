//! What the lessons share: a number from the command line, distances, times, and a plot.

use std::error::Error;
use std::ops::Range;
use std::time::Instant;
use std::{env, fs};

use plotters::prelude::*;

/// Width and height of a plot, pixels.
const SIZE: (u32, u32) = (760, 480);
const FONT: &str = "sans-serif";

/// Colours that can be told apart by everyone (M. Okabe, K. Ito, *Color universal design*, 2008).
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

/// The shortest of two hundred times that some work takes, s.
pub fn shortest_time(mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..200).map(time).fold(f64::MAX, f64::min)
}

/// Where a curve is interrupted.
pub const GAP: (f64, f64) = (f64::NAN, f64::NAN);

/// Curves over two axes.
#[derive(Clone, Debug)]
pub struct Plot {
    title: &'static str,
    axes: [&'static str; 2],
    powers: bool,
    curves: Vec<(String, Vec<(f64, f64)>)>,
}

impl Plot {
    /// A plot without a curve. The axes are named across and up.
    pub const fn new(title: &'static str, axes: [&'static str; 2]) -> Self {
        Self { title, axes, powers: false, curves: Vec::new() }
    }

    /// Both axes in powers of ten.
    #[must_use]
    pub fn in_powers_of_ten(self) -> Self {
        Self { powers: true, ..self }
    }

    /// Adds a curve. One without a name continues the colour of the last one and is not in the legend.
    pub fn curve(&mut self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) {
        let place = |x: f64| if self.powers { x.log10() } else { x };
        let points = points.into_iter().map(|(x, y)| (place(x), place(y))).collect();
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
        let mut chart = ChartBuilder::on(&root)
            .caption(self.title, (FONT, 19))
            .margin(12)
            .x_label_area_size(46)
            .y_label_area_size(70)
            .build_cartesian_2d(self.range(|point| point.0), self.range(|point| point.1))?;
        let label = |value: &f64| if self.powers { format!("{:.0e}", 10_f64.powf(*value)) } else { plain(*value) };
        chart
            .configure_mesh()
            .x_desc(self.axes[0])
            .y_desc(self.axes[1])
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .label_style((FONT, 14))
            .axis_desc_style((FONT, 15))
            .light_line_style(TRANSPARENT)
            .draw()?;
        let mut colour = COLOURS.iter().cycle();
        let mut style = BLACK.stroke_width(2);
        for (name, points) in &self.curves {
            if !name.is_empty() {
                style = colour.next().unwrap_or(&BLACK).stroke_width(2);
            }
            for (index, piece) in points.split(|point| !(point.0 + point.1).is_finite()).enumerate() {
                let drawn = chart.draw_series(LineSeries::new(piece.iter().copied(), style))?;
                if index == 0 && !name.is_empty() {
                    drawn.label(name).legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], style));
                }
            }
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE.mix(0.85))
            .border_style(RGBColor(200, 200, 200))
            .label_font((FONT, 14))
            .draw()?;
        root.present()?;
        Ok(())
    }

    /// From the smallest to the largest number of all curves, and a little more.
    fn range(&self, of: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let all = self.curves.iter().flat_map(|(_, points)| points).map(of).filter(|value| value.is_finite());
        let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        let room = 0.04 * (high - low).max(1e-9);
        low - room..high + room
    }
}

/// A number without what adding up has left in its last places.
fn plain(value: f64) -> String {
    format!("{}", (value * 1e6).round() / 1e6 + 0.0)
}
