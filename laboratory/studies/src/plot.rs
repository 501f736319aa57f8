//! Plots in SVG: curves on logarithmic or linear axes, with the legend beside them.

use std::ops::Range;
use std::path::Path;

use kerchief::host::{ScalarKind, SolverKind};
use plotters::coord::ranged1d::ValueFormatter;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::front::front;
use super::page;

/// Width and height of a plot, and the width of its legend, pixels.
const SIZE: (u32, u32) = (900, 560);
const LEGEND: i32 = 210;
const FONT: &str = "sans-serif";

/// Colours that colour-blind readers can distinguish, too (M. Okabe, K. Ito, *Color universal design*, 2008), without the yellow, which is too light for lines.
pub const COLOURS: [RGBColor; 7] = [
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(70, 70, 70),
];

/// The mark of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    None,
    Disc,
    Ring,
    Triangle,
    Cross,
}

/// A number type's mark in every plot.
pub const fn marker(scalar: ScalarKind) -> Marker {
    match scalar {
        ScalarKind::F32 => Marker::Disc,
        ScalarKind::F64 => Marker::Ring,
        ScalarKind::Q24 => Marker::Triangle,
        ScalarKind::Q13 => Marker::Cross,
    }
}

/// A solver's colour in every plot.
pub const fn colour(solver: SolverKind) -> RGBColor {
    match solver {
        SolverKind::Lines => COLOURS[1],
        SolverKind::Leapfrog => COLOURS[6],
        SolverKind::Xpbd => COLOURS[4],
        SolverKind::BackwardEuler => COLOURS[2],
        SolverKind::Verlet => COLOURS[0],
        SolverKind::ForwardEuler => COLOURS[3],
    }
}

/// A curve.
#[derive(Clone, Debug)]
pub struct Curve {
    pub name: String,
    pub colour: RGBColor,
    pub marker: Marker,
    /// Width of the line, pixels; 0 draws points only.
    pub width: u32,
    pub points: Vec<(f64, f64)>,
}

/// An axis.
#[derive(Clone, Copy, Debug)]
pub struct Axis<'a> {
    pub words: &'a str,
    /// Whether the axis is logarithmic.
    pub log: bool,
    /// Values outside these bounds are not drawn.
    pub bounds: (f64, f64),
}

/// A plot: its curves, the first one behind all others, and further lines of the legend.
#[derive(Clone, Debug)]
pub struct Plot<'a> {
    pub title: &'a str,
    pub axes: [Axis<'a>; 2],
    pub curves: Vec<Curve>,
    pub notes: Vec<String>,
}

impl Curve {
    /// The Pareto front of all points `(cost, error)`, broad and grey.
    pub fn front(points: &[(f64, f64)]) -> Self {
        let colour = RGBColor(205, 205, 205);
        Self { name: "Pareto front".to_string(), colour, marker: Marker::None, width: 9, points: best(points) }
    }

    /// The Pareto front of one solver in one number type.
    pub fn of(solver: SolverKind, scalar: ScalarKind, points: &[(f64, f64)]) -> Self {
        let name = format!("{} {}", solver.name(), scalar.name());
        Self { name, colour: colour(solver), marker: marker(scalar), width: 1, points: best(points) }
    }
}

fn best(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    front(points).into_iter().map(|index| points[index]).collect()
}

impl Axis<'_> {
    /// The coordinate of a value on a linear axis; its logarithm for a logarithmic axis, so that one kind of axis draws both.
    fn place(&self, value: f64) -> Option<f64> {
        let inside = value >= self.bounds.0 && value <= self.bounds.1;
        inside.then(|| if self.log { value.log10() } else { value })
    }

    /// The range of the drawn values with a small margin.
    fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        if low > high {
            return 0.0..1.0;
        }
        let room = if high > low { 0.04 * (high - low) } else { 0.5 };
        low - room..high + room
    }

    fn label(&self, place: f64) -> String {
        if self.log { power(place) } else { format!("{place}") }
    }
}

/// A round number near 10^`exponent`.
fn power(exponent: f64) -> String {
    let value = 10_f64.powf(exponent);
    match exponent.round() as i32 {
        6.. => format!("{} M", (value / 1e6).round()),
        3..6 => format!("{} k", (value / 1e3).round()),
        _ if exponent >= 0.0 => format!("{}", value.round()),
        _ if exponent > -1.0 => format!("{value:.1}"),
        _ => format!("{value:.0e}"),
    }
}

/// A linear axis with the labels of an [`Axis`].
struct Ticks<'a> {
    axis: Axis<'a>,
    range: RangedCoordf64,
}

impl Ticks<'_> {
    fn over(axis: Axis<'_>, range: Range<f64>) -> Ticks<'_> {
        Ticks { axis, range: range.into() }
    }
}

impl Ranged for Ticks<'_> {
    type FormatOption = plotters::coord::ranged1d::NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.range.map(value, limit)
    }

    fn key_points<H: plotters::coord::ranged1d::KeyPointHint>(&self, hint: H) -> Vec<f64> {
        if !self.axis.log {
            return self.range.key_points(hint);
        }
        let Range { start, end } = self.range.range();
        let whole =
            |step: i32| (start.ceil() as i32..=end.floor() as i32).filter(move |k| k % step == 0).map(f64::from);
        let powers: Vec<f64> = whole(1).collect();
        match powers.len() {
            // Ticks at 1, 2 and 5 if there are few powers of ten.
            0..=2 => {
                let fine = (start.floor() as i32..=end.ceil() as i32)
                    .flat_map(|k| [1.0_f64, 2.0, 5.0].map(|digit| f64::from(k) + digit.log10()));
                fine.filter(|place| *place >= start && *place <= end).collect()
            }
            3..=8 => powers,
            _ => whole(2).collect(),
        }
    }

    fn range(&self) -> Range<f64> {
        self.range.range()
    }
}

impl ValueFormatter<f64> for Ticks<'_> {
    fn format_ext(&self, value: &f64) -> String {
        self.axis.label(*value)
    }
}

impl Plot<'_> {
    /// Writes the plot.
    pub fn write(&self, directory: &Path, name: &str) -> Result<(), String> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| format!("{name}: {error}"))?;
        page::write(directory, name, svg.trim_end().as_bytes())
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn std::error::Error>> {
        let [x, y] = self.axes;
        let placed: Vec<Vec<Vec<(f64, f64)>>> = self.curves.iter().map(|curve| self.pieces(curve)).collect();
        let all = || placed.iter().flatten().flatten();
        let (across, up) = (Axis::range(all().map(|p| p.0)), Axis::range(all().map(|p| p.1)));

        let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
        root.fill(&WHITE)?;
        let (left, right) = root.split_horizontally(SIZE.0 as i32 - LEGEND);
        let mut chart = ChartBuilder::on(&left)
            .caption(self.title, (FONT, 20))
            .margin(12)
            .x_label_area_size(48)
            .y_label_area_size(74)
            .build_cartesian_2d(Ticks::over(x, across), Ticks::over(y, up))?;
        chart
            .configure_mesh()
            .x_desc(x.words)
            .y_desc(y.words)
            .label_style((FONT, 15))
            .axis_desc_style((FONT, 16))
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225))
            .draw()?;
        for (curve, pieces) in self.curves.iter().zip(&placed) {
            for piece in pieces.iter().filter(|_| curve.width > 0) {
                chart.draw_series(LineSeries::new(piece.iter().copied(), curve.colour.stroke_width(curve.width)))?;
            }
            let markers = pieces.iter().flatten().filter_map(|&point| curve.marker.at(point, curve.colour));
            chart.draw_series(markers)?;
        }
        self.legend(&right)?;
        root.present()?;
        Ok(())
    }

    /// The points of a curve on the axes, in pieces: the curve is interrupted where it is out of bounds.
    fn pieces(&self, curve: &Curve) -> Vec<Vec<(f64, f64)>> {
        let [x, y] = self.axes;
        let mut pieces = vec![Vec::new()];
        for &(a, b) in &curve.points {
            match (x.place(a).zip(y.place(b)), pieces.last_mut()) {
                (Some(place), Some(piece)) => piece.push(place),
                _ => pieces.push(Vec::new()),
            }
        }
        pieces
    }

    fn legend<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, plotters::coord::Shift>,
    ) -> Result<(), Box<dyn std::error::Error>>
    where
        B::ErrorType: 'static,
    {
        let words = (FONT, 15).into_text_style(area).pos(Pos::new(HPos::Left, VPos::Center));
        let named = self.curves.iter().filter(|curve| !curve.name.is_empty());
        let mut height = 40;
        for curve in named {
            if curve.width > 0 {
                let line = vec![(4, height), (34, height)];
                area.draw(&PathElement::new(line, curve.colour.stroke_width(curve.width)))?;
            }
            if let Some(marker) = curve.marker.at((19, height), curve.colour) {
                area.draw(&marker)?;
            }
            area.draw(&Text::new(curve.name.clone(), (42, height), words.clone()))?;
            height += 20;
        }
        height += 8;
        for note in &self.notes {
            area.draw(&Text::new(note.clone(), (4, height), words.clone()))?;
            height += 19;
        }
        Ok(())
    }
}

impl Marker {
    fn at<C: Clone + 'static, B: DrawingBackend>(
        self,
        place: C,
        colour: RGBColor,
    ) -> Option<DynElement<'static, B, C>> {
        match self {
            Self::None => None,
            Self::Disc => Some(Circle::new(place, 4, colour.filled()).into_dyn()),
            Self::Ring => Some(Circle::new(place, 5, colour.stroke_width(2)).into_dyn()),
            Self::Triangle => Some(TriangleMarker::new(place, 6, colour.filled()).into_dyn()),
            Self::Cross => Some(Cross::new(place, 5, colour.stroke_width(2)).into_dyn()),
        }
    }
}
