//! Reads the logs of boards.

use std::collections::BTreeMap;

/// A line of the log.
#[derive(Debug)]
pub(crate) struct Report {
    pub(crate) digest: u32,
    pub(crate) pictures: u32,
    /// Pictures in a second.
    pub(crate) rate: u32,
    pub(crate) dropped: u32,
    /// Cycles of a picture: simulate, sort, fill, transfer.
    pub(crate) cycles: [u32; 4],
}

/// The lines of a log, by step.
pub(crate) fn reports(log: &[String]) -> BTreeMap<u32, Report> {
    log.iter().map(|line| parse(line).unwrap_or_else(|| panic!("the log says {line:?}"))).collect()
}

fn parse(line: &str) -> Option<(u32, Report)> {
    let words = line.strip_prefix("info: ")?.split(", ").collect::<Vec<_>>();
    let value = |name: &str| words.iter().find_map(|word| word.strip_prefix(name)?.strip_prefix(' '));
    let number = |name| value(name)?.parse().ok();
    let cycles = value("cycles")?.split(' ').map(|cycles| cycles.parse().ok()).collect::<Option<Vec<_>>>()?;
    let report = Report {
        digest: u32::from_str_radix(value("digest")?, 16).ok()?,
        pictures: number("pictures")?,
        rate: number("rate")?,
        dropped: number("dropped")?,
        cycles: cycles.try_into().ok()?,
    };
    Some((number("step")?, report))
}
