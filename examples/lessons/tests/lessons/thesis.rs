//! The table of the thesis' equations and listings is complete: the documentation of each row's items names the row's number, and so does its lesson.

use std::fs;

use crate::pages::links;
use crate::program::{read, root};

/// Numbers in the thesis of the equations, figures, listings and sections that the library implements.
const NUMBERS: [&str; 14] = [
    "3.3",
    "equations 4.1–4.3",
    "equation 4.4",
    "equations 4.7–4.13",
    "equation 4.10",
    "figure 4.1",
    "listing 5.1",
    "listing 5.2",
    "listing 5.3",
    "listing 5.4",
    "listing 5.5",
    "section 5.4.2",
    "section 6.1",
    "section 6.2",
];

struct Row {
    number: String,
    /// Names of items and the files that define them.
    items: Vec<(String, String)>,
    lesson: String,
}

/// The rows of the table, with paths relative to the repository's folder.
fn table() -> Vec<Row> {
    let page = read("docs/guide/thesis.md");
    let rows = page.lines().filter(|line| line.starts_with("| ") && line.contains("../lessons/"));
    let file = |link: &str| link.replace("../../", "").replace("../", "docs/");
    let row = |line: &str| {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let names = cells[3].split('`').skip(1).step_by(2).map(str::to_owned);
        Row {
            number: cells[1].to_owned(),
            items: names.zip(links(cells[3]).iter().map(|link| file(link))).collect(),
            lesson: file(&links(cells[4])[0]),
        }
    };
    rows.map(row).collect()
}

/// The documentation above the definition of an item.
fn documentation(item: &str, file: &str) -> String {
    let source = read(file);
    let lines: Vec<_> = source.lines().map(str::trim).collect();
    let starts = ["pub struct ", "pub fn ", ""].map(|keyword| format!("{keyword}{item}"));
    let defines = |line: &&str| {
        starts
            .iter()
            .any(|start| line.strip_prefix(start).is_some_and(|rest| rest.starts_with([',', '<', ';', ' ', '('])))
    };
    let place = lines.iter().position(defines).unwrap_or_else(|| panic!("{file} has no {item}"));
    let above = lines[..place].iter().rev().take_while(|line| line.starts_with("///") || line.starts_with("#["));
    above.copied().collect()
}

#[test]
fn every_number_has_a_row() {
    let found: Vec<_> = table().into_iter().map(|row| row.number).collect();
    assert_eq!(found, NUMBERS);
}

#[test]
fn items_and_lessons_name_their_numbers() {
    for Row { number, items, lesson } in table() {
        assert!(!items.is_empty(), "{number} has no item");
        for (item, file) in items {
            let documentation = documentation(&item, &file);
            assert!(
                documentation.contains("thesis") && documentation.contains(&number),
                "{item} does not name {number}"
            );
        }
        assert!(read(&lesson).contains(&number), "{lesson} does not name {number}");
    }
}

#[test]
fn what_the_library_names_is_in_the_table() {
    let mut folders = vec![root().join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()) {
            if entry.is_dir() {
                folders.push(entry);
                continue;
            }
            for number in read(&entry).lines().flat_map(named) {
                let is_known = NUMBERS.iter().any(|known| known.split(' ').any(|word| word == number));
                assert!(is_known, "{}: {number} of the thesis is not in the table", entry.display());
            }
        }
    }
}

/// The numbers of the thesis in a line of documentation.
fn named(line: &str) -> Vec<String> {
    let named = line.split_once("(thesis, ").map_or("", |(_, rest)| rest.split(')').next().unwrap_or(rest));
    let words = named.split([' ', ',', ';']);
    words
        .filter(|word| word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.'))
        .map(str::to_owned)
        .collect()
}
