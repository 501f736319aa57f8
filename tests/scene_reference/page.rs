//! Parses the tables of the page.

/// The row of a key on the page.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) key: String,
    pub(crate) range: String,
    pub(crate) default: String,
}

/// A heading and its rows. `tables` are the names in the heading, or `""` if it has none.
#[derive(Debug)]
pub(crate) struct Section {
    pub(crate) tables: Vec<String>,
    pub(crate) rows: Vec<Row>,
}

/// The page's sections that have rows.
pub(crate) fn sections(page: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for line in page.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            let names = quoted(heading, '`');
            let tables = names.iter().filter(|name| name.starts_with('[')).cloned().collect();
            sections.push(Section { tables, rows: Vec::new() });
        }
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        if let ["", key, _unit, range, default, _meaning, ""] = cells[..]
            && key.starts_with('`')
        {
            let row = Row { key: key.trim_matches('`').into(), range: range.into(), default: default.into() };
            sections.last_mut().expect("a table stands below a heading").rows.push(row);
        }
    }
    sections.retain(|section| !section.rows.is_empty());
    for section in &mut sections {
        if section.tables.is_empty() {
            section.tables.push(String::new());
        }
    }
    sections
}

/// The rows of a table such as `[cloth]` or `[[sphere]]`, from every section that names it.
pub(crate) fn rows(sections: &[Section], table: &str) -> Vec<Row> {
    let of_table = sections.iter().filter(|section| section.tables.iter().any(|name| name == table));
    of_table.flat_map(|section| section.rows.clone()).collect()
}

/// Every table that the page names, each once.
pub(crate) fn tables(sections: &[Section]) -> Vec<String> {
    let mut tables: Vec<String> = sections.iter().flat_map(|section| section.tables.clone()).collect();
    tables.sort();
    tables.dedup();
    tables
}

/// The parts of a text between pairs of `mark`.
pub(crate) fn quoted(text: &str, mark: char) -> Vec<String> {
    text.split(mark).skip(1).step_by(2).map(str::to_owned).collect()
}
