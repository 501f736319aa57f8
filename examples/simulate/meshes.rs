//! The sheet as meshes for other programs: Wavefront OBJ.

use std::io::{self, Write};
use std::path::Path;

use console::printable;
use console::staging::{Complete, Staged};
use kerchief::Node;
use kerchief::host::{Description, Still};
use kerchief::mesh;

/// A `frame-NNNNN.obj` for each recorded moment: particles with normals and texture coordinates, and the triangles between them; for a chain, a line.
pub(crate) struct Meshes<'a> {
    scene: &'a Description,
    directory: &'a Path,
    files: Vec<Complete>,
}

impl<'a> Meshes<'a> {
    /// No meshes yet. They will be written to `directory`.
    pub(crate) fn new(scene: &'a Description, directory: &'a Path) -> Self {
        Self { scene, directory, files: Vec::new() }
    }

    /// Writes the moment at the end of a frame.
    pub(crate) fn record(&mut self, frame: u32, still: &Still) -> Result<(), String> {
        let mut file = Staged::create(self.directory, &format!("frame-{frame:05}.obj"))?;
        let written = self.write(&mut file, frame, &still.positions);
        file.named(written)?;
        self.files.push(file.complete()?);
        Ok(())
    }

    /// All files, which are complete but not yet renamed to their final names.
    pub(crate) fn complete(self) -> Vec<Complete> {
        self.files
    }

    fn write(&self, file: &mut impl Write, frame: u32, positions: &[[f64; 3]]) -> io::Result<()> {
        let (columns, rows) = (self.scene.sheet.columns, self.scene.sheet.rows);
        writeln!(file, "# {}, frame {frame}: metres, z up", printable(&self.scene.name))?;
        for [x, y, z] in positions {
            writeln!(file, "v {x} {y} {z}")?;
        }
        // OBJ counts texture coordinates from the lower left corner
        for [across, down] in mesh::texture(columns, rows) {
            writeln!(file, "vt {across} {}", 1.0 - down)?;
        }
        if columns.min(rows) == 1 {
            write!(file, "l")?;
            (1..=positions.len()).try_for_each(|vertex| write!(file, " {vertex}/{vertex}"))?;
            return writeln!(file);
        }
        for (index, here) in positions.iter().enumerate() {
            let edge = |other: Node| {
                let there = positions[other.row * columns + other.column];
                [0, 1, 2].map(|axis| there[axis] - here[axis])
            };
            let [x, y, z] = mesh::normal([columns, rows], Node::new(index % columns, index / columns), edge);
            writeln!(file, "vn {x:.6} {y:.6} {z:.6}")?;
        }
        for corners in mesh::triangles(columns, rows) {
            let [a, b, c] = corners.map(|corner| corner + 1);
            writeln!(file, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}")?;
        }
        Ok(())
    }
}
