//! The guide's table of boards with displays.

use std::fs;
use std::sync::Mutex;

/// Largest relative change that is tolerated.
const TOLERANCE: f64 = 0.03;
/// Locks the guide: tests run in parallel.
static FILE: Mutex<()> = Mutex::new(());

/// The cost of a picture.
pub(crate) struct Figures {
    /// Parts of the cost: simulate, sort, fill, transfer.
    pub(crate) parts: [u32; 4],
    /// Pictures in a second.
    pub(crate) rate: u32,
}

/// Compares the row of a board in the guide's table with measured figures, or writes it with `UPDATE_DISPLAYS=1`.
pub(crate) fn check(board: &str, figures: &Figures) {
    let _alone = FILE.lock();
    let guide = emulator::root().join("docs/guide/boards.md");
    let text = fs::read_to_string(&guide).expect("the guide can be read");
    let start = format!("| `{board}`, thousands of ");
    let row = text.lines().find(|line| line.starts_with(&start)).expect("the guide has the board's row");
    let thousands = figures.parts.map(|part| (part + 500) / 1000);
    let sum = (figures.parts.iter().sum::<u32>() + 500) / 1000;
    let found = [&thousands[..], &[sum, figures.rate]].concat();
    if std::env::var_os("UPDATE_DISPLAYS").is_some() {
        let name = row.split('|').nth(1).expect("a row has cells");
        let cells: Vec<_> = found.iter().map(u32::to_string).collect();
        let new = format!("|{name}| {} |", cells.join(" | "));
        fs::write(guide, text.replace(row, &new)).expect("the guide can be written");
        return;
    }
    let shown: Vec<u32> = row.split('|').skip(2).filter_map(|cell| cell.trim().parse().ok()).collect();
    assert_eq!(shown.len(), found.len(), "{row}");
    for (shown, found) in shown.into_iter().zip(found) {
        // thousands and rates are rounded
        let near = (f64::from(shown) - f64::from(found)).abs() <= (TOLERANCE * f64::from(shown)).max(1.0);
        assert!(near, "{board}: the guide shows {shown} where {found} was measured: {row}");
    }
}
