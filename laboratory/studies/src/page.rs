//! Pages in Markdown: paragraphs, tables and numbers.

use std::fmt::Write;
use std::path::Path;

use console::staging::Staged;

/// A page to which paragraphs, pictures and tables are added.
#[derive(Clone, Debug, Default)]
pub struct Page(String);

impl Page {
    /// Adds a paragraph or a heading.
    pub fn paragraph(&mut self, text: &str) {
        self.0.push_str(text);
        self.0.push_str("\n\n");
    }

    /// Adds a picture from a file in the page's directory.
    pub fn picture(&mut self, words: &str, file: &str) {
        let _ = write!(self.0, "![{words}]({file})\n\n");
    }

    /// Adds a table; all columns but the first are right-aligned, for numbers.
    pub fn table(&mut self, head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) {
        let line = |cells: &[&str]| format!("| {} |\n", cells.join(" | "));
        self.0.push_str(&line(head));
        let mut rule = vec!["---:"; head.len()];
        rule[0] = "---";
        self.0.push_str(&line(&rule).replace(' ', ""));
        for row in rows {
            let cells: Vec<_> = row.iter().map(String::as_str).collect();
            self.0.push_str(&line(&cells));
        }
        self.0.push('\n');
    }

    /// Writes the page.
    pub fn write(&self, directory: &Path, name: &str) -> Result<(), String> {
        write(directory, name, self.0.trim_end().as_bytes())
    }
}

/// Writes a text file and a line break at its end.
pub fn write(directory: &Path, name: &str, text: &[u8]) -> Result<(), String> {
    use std::io::Write;
    let mut file = Staged::create(directory, name)?;
    let written = file.write_all(text).and_then(|()| file.write_all(b"\n"));
    file.named(written)?;
    file.finish()
}

/// Writes a table of comma-separated values.
pub fn write_csv<R: serde::Serialize>(directory: &Path, name: &str, rows: &[R]) -> Result<(), String> {
    let mut table = csv::Writer::from_writer(Staged::create(directory, name)?);
    let written = rows.iter().try_for_each(|row| table.serialize(row));
    table.get_ref().named(written)?;
    table.into_inner().map_err(|error| error.to_string())?.finish()
}

/// A number with two digits and a power of ten: `1.2e-4`.
pub fn scientific(value: f64) -> String {
    if value.is_finite() { format!("{value:.1e}") } else { "diverged".to_string() }
}

/// A count in thousands: `5.4 k`.
pub fn thousands(count: f64) -> String {
    match count {
        _ if !count.is_finite() => "–".to_string(),
        _ if count < 9_950.0 => format!("{:.1} k", count / 1e3),
        _ => format!("{:.0} k", count / 1e3),
    }
}

/// Writes a picture.
pub fn write_png(directory: &Path, name: &str, picture: &image::RgbImage) -> Result<(), String> {
    let mut file = Staged::create(directory, name)?;
    let written = picture.write_with_encoder(image::codecs::png::PngEncoder::new(&mut file));
    file.named(written)?;
    file.finish()
}
