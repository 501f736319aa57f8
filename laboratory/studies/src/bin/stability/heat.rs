//! Heat maps in SVG: a panel for each solver and number type, with logarithmic colours and limits as lines.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::experiment::Outcome;
use laboratory::page;

const FONT: &str = "sans-serif";
/// Width and height of a panel without its labels, pixels.
const PANEL: (i32, i32) = (230, 150);
/// Space for labels to the left, above, between and below, pixels.
const LEFT: i32 = 70;
const TOP: i32 = 64;
const GAP: (i32, i32) = (26, 46);
const BOTTOM: i32 = 34;
const REFUSED: RGBColor = RGBColor(225, 225, 225);
const HATCH: RGBColor = RGBColor(150, 150, 150);
/// Number of shades of a scale.
const SHADES: f64 = 25.0;
/// Width of the legend, pixels.
const LEGEND: i32 = 120;

/// A logarithmic colour scale, from light to dark.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    pub(crate) words: &'static str,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// An outcome, and the value of it that the cell shows: strain or energy.
type Cell = (Outcome, fn(f64, f64) -> f64);

/// One map.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    pub(crate) title: String,
    /// Row by row, from the lowest.
    pub(crate) cells: Vec<Cell>,
    /// The limit in each column, on the vertical axis.
    pub(crate) limit: Vec<Option<f64>>,
}

/// Maps over the same axes.
#[derive(Clone, Debug)]
pub(crate) struct Sheet<'a> {
    pub(crate) title: String,
    pub(crate) across: (&'static str, &'a [f64]),
    pub(crate) up: (&'static str, &'a [f64]),
    pub(crate) scale: Scale,
    /// Panels side by side.
    pub(crate) columns: usize,
    pub(crate) panels: Vec<Panel>,
}

/// A panel's place.
#[derive(Clone, Copy, Debug)]
struct Frame {
    left: i32,
    bottom: i32,
}

impl Scale {
    fn colour(&self, value: f64) -> RGBColor {
        let part = (value.max(self.low) / self.low).ln() / (self.high / self.low).ln();
        // Few shades, so that equal neighbours can be drawn as one rectangle.
        ramp((SHADES * part.clamp(0.0, 1.0)).round() / SHADES)
    }
}

/// A colour between light yellow (0) and dark violet (1), over orange and red, steadily darker.
fn ramp(part: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 6] = [
        [255.0, 250.0, 220.0],
        [254.0, 217.0, 118.0],
        [253.0, 141.0, 60.0],
        [227.0, 26.0, 28.0],
        [150.0, 0.0, 80.0],
        [70.0, 0.0, 90.0],
    ];
    let place = part * (STOPS.len() - 1) as f64;
    let first = (place as usize).min(STOPS.len() - 2);
    let mix =
        |k: usize| (STOPS[first][k] + (place - first as f64) * (STOPS[first + 1][k] - STOPS[first][k])).round() as u8;
    RGBColor(mix(0), mix(1), mix(2))
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

impl Sheet<'_> {
    /// Writes the maps.
    pub(crate) fn write(&self, directory: &Path, name: &str) -> Result<(), String> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| format!("{name}: {error}"))?;
        page::write(directory, name, svg.trim_end().as_bytes())
    }

    fn draw(&self, svg: &mut String) -> Drawn {
        let rows = self.panels.len().div_ceil(self.columns) as i32;
        let columns = self.columns as i32;
        let width = LEFT + columns * (PANEL.0 + GAP.0) + LEGEND;
        let height = TOP + rows * (PANEL.1 + GAP.1) + BOTTOM;
        let area = SVGBackend::with_string(svg, (width as u32, height as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        let middle = (LEFT + columns * (PANEL.0 + GAP.0) / 2, 18);
        text(&area, &self.title, middle, 20, HPos::Center)?;
        for (index, panel) in self.panels.iter().enumerate() {
            let (row, column) = ((index / self.columns) as i32, (index % self.columns) as i32);
            let frame =
                Frame { left: LEFT + column * (PANEL.0 + GAP.0), bottom: TOP + row * (PANEL.1 + GAP.1) + PANEL.1 };
            self.panel(&area, panel, frame, column == 0)?;
        }
        text(&area, self.across.0, (middle.0, height - 14), 16, HPos::Center)?;
        text(&area, self.up.0, (6, TOP - 30), 16, HPos::Left)?;
        self.legend(&area, width - LEGEND + 14)?;
        area.present()?;
        Ok(())
    }

    fn panel(&self, area: &Area, panel: &Panel, frame: Frame, first: bool) -> Drawn {
        let Frame { left, bottom } = frame;
        let [columns, rows] = [self.across.1.len(), self.up.1.len()];
        let x = |column: f64| left + (column * f64::from(PANEL.0) / columns as f64).round() as i32;
        let y = |row: f64| bottom - (row * f64::from(PANEL.1) / rows as f64).round() as i32;
        text(area, &panel.title, (left + PANEL.0 / 2, bottom - PANEL.1 - 10), 15, HPos::Center)?;
        for (row, cells) in panel.cells.chunks(columns).enumerate() {
            let mut first = 0;
            while first < columns {
                let fill = self.fill(&cells[first]);
                let count = cells[first..].iter().take_while(|cell| self.fill(cell) == fill).count();
                let corners = [(x(first as f64), y(row as f64 + 1.0)), (x((first + count) as f64), y(row as f64))];
                area.draw(&Rectangle::new(corners, fill.unwrap_or(REFUSED).filled()))?;
                if fill.is_none() {
                    let stroke = vec![(corners[0].0, corners[1].1), (corners[1].0, corners[0].1)];
                    area.draw(&PathElement::new(stroke, HATCH))?;
                }
                first += count;
            }
        }
        area.draw(&Rectangle::new([(left, bottom - PANEL.1), (left + PANEL.0, bottom)], BLACK.stroke_width(1)))?;
        let inside = |row: f64| row.clamp(0.0, rows as f64);
        let line: Vec<_> = panel
            .limit
            .iter()
            .enumerate()
            .filter_map(|(column, limit)| {
                let row = place(self.up.1, (*limit)?) + 0.5;
                Some((x(column as f64 + 0.5), y(inside(row))))
            })
            .collect();
        if line.len() > 1 {
            area.draw(&PathElement::new(line.clone(), WHITE.stroke_width(5)))?;
            area.draw(&PathElement::new(line, RGBColor(0, 114, 178).stroke_width(3)))?;
        }
        for (column, value) in marked(self.across.1) {
            text(area, &number(value), (x(column as f64 + 0.5), bottom + 10), 13, HPos::Center)?;
        }
        if first {
            for (row, value) in marked(self.up.1) {
                text(area, &number(value), (left - 6, y(row as f64 + 0.5)), 13, HPos::Right)?;
            }
        }
        Ok(())
    }

    /// The colour of a cell; `None` if the run was refused or not computed, or if its value is undefined.
    fn fill(&self, (outcome, of): &Cell) -> Option<RGBColor> {
        match outcome {
            Outcome::Held { strain, energy } => {
                let value = of(*strain, *energy);
                value.is_finite().then(|| self.scale.colour(value))
            }
            Outcome::Gone => Some(BLACK),
            Outcome::NotHeld | Outcome::NotComputed => None,
        }
    }

    fn legend(&self, area: &Area, left: i32) -> Drawn {
        let decades = (self.scale.high / self.scale.low).log10().round() as i32;
        let top = TOP;
        for step in 0..=(decades * 8) {
            let part = f64::from(step) / f64::from(decades * 8);
            let y = top + 160 - (part * 160.0) as i32;
            area.draw(&Rectangle::new([(left, y), (left + 18, y + 5)], ramp(part).filled()))?;
        }
        for decade in 0..=decades {
            let y = top + 163 - 160 * decade / decades;
            text(area, &number(self.scale.low * 10_f64.powi(decade)), (left + 24, y), 13, HPos::Left)?;
        }
        area.draw(&Rectangle::new([(left, top + 184), (left + 18, top + 198)], BLACK.filled()))?;
        text(area, "gone", (left + 24, top + 191), 13, HPos::Left)?;
        let refused = [(left, top + 206), (left + 18, top + 220)];
        area.draw(&Rectangle::new(refused, REFUSED.filled()))?;
        area.draw(&PathElement::new(vec![(left, top + 220), (left + 18, top + 206)], HATCH))?;
        text(area, "not computed", (left + 24, top + 213), 13, HPos::Left)?;
        area.draw(&PathElement::new(
            vec![(left, top + 235), (left + 18, top + 235)],
            RGBColor(0, 114, 178).stroke_width(3),
        ))?;
        text(area, "limit of theory", (left + 24, top + 235), 13, HPos::Left)
    }
}

/// The position of a value among `values`, as an index with a fraction. Between two values it is interpolated logarithmically.
fn place(values: &[f64], value: f64) -> f64 {
    let next = values.partition_point(|v| *v < value).clamp(1, values.len() - 1);
    let (low, high) = (values[next - 1], values[next]);
    (next - 1) as f64 + (value / low).ln() / (high / low).ln()
}

/// The values with a label: up to seven.
fn marked(values: &[f64]) -> impl Iterator<Item = (usize, f64)> + '_ {
    let step = values.len().div_ceil(7);
    values.iter().copied().enumerate().step_by(step)
}

fn number(value: f64) -> String {
    if (0.01..9999.0).contains(&value) {
        let digits = if value >= 9.95 {
            0
        } else if value >= 0.095 {
            1
        } else {
            2
        };
        let text = format!("{value:.digits$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
    } else {
        format!("{value:.0e}")
    }
}

fn text(area: &Area, words: &str, at: (i32, i32), size: i32, side: HPos) -> Drawn {
    let style = (FONT, size).into_text_style(area).pos(Pos::new(side, VPos::Center));
    area.draw(&Text::new(words.to_string(), at, style))?;
    Ok(())
}
