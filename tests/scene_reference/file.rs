//! Scene files made of the keys that the page calls required.

use kerchief::host::{Description, SceneError};

use crate::page::{Row, Section, quoted, rows};

/// A value within the range of the `index`-th key of a table. Vectors differ from key to key, with increasing components.
fn sample(row: &Row, index: usize) -> String {
    let names = quoted(&row.range, '"');
    match row.range.as_str() {
        "a grid" => "4".into(),
        "text" => "\"sample\"".into(),
        "0.75 to 1 cell" => "0.3".into(),
        "0 ≤ x < 1" => "0.5".into(),
        "two of `\"#rrggbb\"`" => "[\"#102030\", \"#405060\"]".into(),
        range if range.starts_with("`[x, y, z]`") => format!("[{}, {}, {}]", index + 1, index + 2, index + 3),
        range if range.starts_with("`[[column, row]") => "[[0, 0]]".into(),
        _ if !names.is_empty() => format!("\"{}\"", names[names.len() - 1]),
        range if range.starts_with("whole") => "3".into(),
        _ => "1.5".into(),
    }
}

/// A file with the required keys, in which keys of one table can be given or left out.
#[derive(Clone, Debug)]
pub(crate) struct Scene<'a> {
    page: &'a [Section],
    table: String,
    keys: Vec<(String, String)>,
}

impl<'a> Scene<'a> {
    /// A scene with the required keys of `table`.
    pub(crate) fn with(page: &'a [Section], table: &str) -> Self {
        let mut scene = Self { page, table: table.into(), keys: Vec::new() };
        for (index, row) in rows(page, table).iter().enumerate() {
            let alternative = row.default.strip_prefix("required, or ").map(|other| other.trim_matches('`'));
            let is_given = alternative.is_some_and(|other| scene.keys.iter().any(|(key, _)| key == other));
            if row.default.starts_with("required") && !is_given {
                scene.keys.push((row.key.clone(), sample(row, index)));
            }
        }
        scene
    }

    /// The scene with a key of the table. Without a `value` it gets a sample.
    pub(crate) fn key(mut self, key: &str, value: Option<&str>) -> Self {
        self.keys.retain(|(known, _)| known != key);
        let of_table = rows(self.page, &self.table);
        let found = of_table.iter().enumerate().find(|(_, row)| row.key == key);
        let sample = found.map(|(index, row)| sample(row, index));
        let value = value.map(str::to_owned).or(sample).unwrap_or_else(|| "0".into());
        self.keys.push((key.into(), value));
        self
    }

    /// The scene without a key of the table.
    pub(crate) fn without(mut self, key: &str) -> Self {
        self.keys.retain(|(known, _)| known != key);
        self
    }

    /// The value of a key.
    pub(crate) fn value(&self, key: &str) -> Option<&str> {
        self.keys.iter().find(|(known, _)| known == key).map(|(_, value)| value.as_str())
    }

    /// A scene with the required keys of the table that `key` names within this table.
    pub(crate) fn table_within(&self, key: &str) -> Self {
        Self::with(self.page, &format!("[{}]", self.path(key)))
    }

    fn text(&self) -> String {
        match self.table.as_str() {
            "[cloth]" => self.body(),
            // keys outside of tables come before all tables
            "" => self.body() + &Self::with(self.page, "[cloth]").body(),
            _ => Self::with(self.page, "[cloth]").body() + &self.body(),
        }
    }

    fn body(&self) -> String {
        let keys = self.keys.iter().map(|(key, value)| format!("{key} = {value}\n"));
        format!("{}\n{}", self.table, keys.collect::<String>())
    }

    pub(crate) fn parse(&self) -> Result<Description, SceneError> {
        Description::parse(&self.text())
    }

    /// The name of a key of the table in errors.
    pub(crate) fn path(&self, key: &str) -> String {
        match (self.table.strip_prefix("[["), self.table.trim_matches(['[', ']'])) {
            (Some(_), name) => format!("{name}[0].{key}"),
            (None, "") => key.into(),
            (None, name) => format!("{name}.{key}"),
        }
    }
}
