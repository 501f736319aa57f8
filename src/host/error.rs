//! Errors of scenes, in one line each.

use core::fmt;
use std::string::{String, ToString};

/// An error of a scene: the key and the reason, one line when displayed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    /// Dotted key, such as `stretch.stiffness` or `sphere[0].radius`; `line 7` if the text is not TOML at all.
    pub key: String,
    /// The reason for the error.
    pub reason: String,
}

impl SceneError {
    /// An error of `key`, for `reason`.
    pub fn new(key: impl Into<String>, reason: impl Into<String>) -> Self {
        Self { key: key.into(), reason: reason.into() }
    }

    pub(super) fn from_toml(text: &str, error: &serde_path_to_error::Error<toml::de::Error>) -> Self {
        let path = error.path().to_string();
        let message = error.inner().message().to_string();
        if let Some(unknown) = message.strip_prefix("unknown field ") {
            let known = unknown.split_once(", ").map_or("", |(_, known)| known);
            return Self::new(path, std::format!("unknown key, {known}"));
        }
        if let Some(field) = message.strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`')) {
            let key = if path == "." { field.to_string() } else { std::format!("{path}.{field}") };
            return Self::new(key, "missing");
        }
        if path == "." {
            return Self::from_syntax(text, error.inner());
        }
        Self::new(path, plain(&message))
    }

    pub(super) fn from_syntax(text: &str, error: &toml::de::Error) -> Self {
        let span = error.span().unwrap_or_default();
        let line = text.get(..span.start).unwrap_or_default().matches('\n').count() + 1;
        let reason = match (error.message(), text.get(span)) {
            (message @ "duplicate key", Some(key)) => std::format!("{message} `{key}`"),
            (message, _) => message.to_string(),
        };
        Self::new(std::format!("line {line}"), reason)
    }
}

/// The message with the types of a scene file instead of those of Rust.
fn plain(message: &str) -> String {
    let parts = message.strip_prefix("invalid type: ").and_then(|types| types.rsplit_once(", expected "));
    let Some((found, expected)) = parts else {
        return message.replace("wanted string or table", "expected a string");
    };
    let found = match found {
        "map" => "table",
        "sequence" => "list",
        // the end of an integer beyond 64 bits; a string ends with its quotes
        _ => found.trim_end_matches(" as i128"),
    };
    let expected = match expected {
        "i64" => "a whole number",
        "a sequence" => "a list",
        _ => expected,
    };
    std::format!("invalid type: {found}, expected {expected}")
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", printable(&self.key), printable(&self.reason))
    }
}

impl core::error::Error for SceneError {}

/// The text with control characters, line separators and direction marks escaped: a terminal finds no command in it, and names stay in their line and direction.
pub fn printable(text: &str) -> String {
    let is_hidden = |c: char| {
        // line separators, direction marks and the byte order mark
        c.is_control()
            || matches!(c, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}' | '\u{61c}' | '\u{feff}')
    };
    let mut line = String::with_capacity(text.len());
    for c in text.chars() {
        if is_hidden(c) { line.extend(c.escape_default()) } else { line.push(c) }
    }
    line
}
