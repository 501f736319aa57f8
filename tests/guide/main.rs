//! The pages of the guide: their links in the repository and in the documentation, their lengths, and their lists.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

mod claims;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// The most words of a page.
const MOST_WORDS: usize = 500;

fn read(path: &str) -> String {
    fs::read_to_string(format!("{ROOT}/{path}")).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The pages beside the index that `src/guide.rs` lists for the documentation.
fn pages() -> Vec<String> {
    let source = read("src/guide.rs");
    let list = source.split_once("pages! {").expect("a list of pages").1;
    let names: Vec<_> = list.lines().filter_map(|line| line.strip_prefix("    ")?.split_once(" \"")).collect();
    let names = names.into_iter().filter(|(module, _)| module.chars().all(|c| c.is_ascii_lowercase() || c == '_'));
    names.map(|(module, rest)| (module, rest.split('"').next().unwrap())).map(same).collect()
}

fn same((module, file): (&str, &str)) -> String {
    assert_eq!(module, file.replace('-', "_"));
    file.into()
}

/// The text without fenced code.
fn prose(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

/// The targets of all `[label]: target` lines, by label.
fn definitions(text: &str) -> BTreeMap<String, String> {
    let lines = text.lines().filter_map(|line| line.strip_prefix('[')?.split_once("]: "));
    lines.map(|(label, target)| (label.into(), target.into())).collect()
}

/// The labels that a text uses, as `[text][label]` or `[label]`. They are in lower case, since Markdown ignores case.
fn labels(text: &str) -> BTreeSet<String> {
    let without_spans: String = prose(text).split('`').step_by(2).collect::<Vec<_>>().join("code");
    let lines = without_spans.lines().filter(|line| !(line.starts_with('[') && line.contains("]: ")));
    let mut labels = BTreeSet::new();
    for line in lines {
        for (start, _) in line.match_indices('[') {
            let (label, after) = line[start + 1..].split_once(']').unwrap_or_else(|| panic!("{line}"));
            if !after.starts_with(['[', '(']) {
                labels.insert(label.to_lowercase());
            }
        }
    }
    labels
}

#[test]
fn the_index_has_every_page() {
    let index = read("docs/guide/README.md");
    let rows: Vec<_> = index.lines().filter(|line| line.starts_with("| [")).collect();
    let pages = pages();
    assert!(pages.len() == 11 && rows.len() == pages.len(), "{pages:?}");
    for (row, page) in rows.iter().zip(&pages) {
        assert!(row.contains(&format!("[{page}]")), "the index and the documentation differ in order: {row}, {page}");
    }
    assert!(read("README.md").contains("(docs/guide/README.md)"));
}

#[test]
fn links_lead_somewhere_in_the_repository_and_in_the_documentation() {
    let here = definitions(&read("src/guide/links.md"));
    let pages = pages();
    let index = read("docs/guide/README.md");
    let listed = index.split_once("## In the repository").expect("a list of further pages").1.to_owned();
    let mut used = BTreeSet::new();
    for page in pages.iter().map(String::as_str).chain(["README"]) {
        let text = read(&format!("docs/guide/{page}.md"));
        assert!(!prose(&text).contains("]("), "{page} has an inline link, which the documentation cannot redirect");
        let there = definitions(&text);
        let labels = labels(&text);
        assert_eq!(labels, there.keys().cloned().collect(), "{page}: links and their definitions");
        for (label, target) in there {
            assert!(Path::new(&format!("{ROOT}/docs/guide/{target}")).exists(), "{page}: {target}");
            let stem = target.strip_suffix(".md").unwrap_or_default();
            let expected = match label.as_str() {
                "plot" => "data:image/svg+xml,".into(),
                "self-contact" => "crate::self_contact".into(),
                _ if pages.iter().any(|page| page == stem) => format!("crate::guide::{}", stem.replace('-', "_")),
                _ => {
                    assert!(listed.contains(&format!("[{label}]")), "{label} is not in the index");
                    "crate::guide#in-the-repository".into()
                }
            };
            assert_eq!(here.get(&label), Some(&expected), "{label}");
            used.insert(label);
        }
    }
    assert_eq!(used, here.into_keys().collect(), "definitions for the documentation");
}

#[test]
fn relative_links_of_all_pages_exist() {
    let folders = ["", "docs", "docs/guide", "docs/lessons", "docs/notebook"].map(|folder| format!("{ROOT}/{folder}"));
    let files = folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let pages = files.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|end| end == "md"));
    let mut count = 0;
    for page in pages {
        let text = prose(&fs::read_to_string(&page).unwrap());
        for target in text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target) {
            let file = target.split('#').next().unwrap();
            if !file.is_empty() && !file.contains("://") {
                let path: PathBuf = page.parent().unwrap().join(file);
                assert!(path.exists(), "{}: {target}", page.display());
                count += 1;
            }
        }
    }
    assert!(count > 100, "{count} links");
}

/// The number of words with a letter, outside of code and link definitions.
fn words(text: &str) -> usize {
    let prose = prose(text);
    let lines = prose.lines().filter(|line| !(line.starts_with('[') && line.contains("]: ")));
    lines.flat_map(str::split_whitespace).filter(|word| word.chars().any(char::is_alphabetic)).count()
}

#[test]
fn pages_are_short_and_have_snippets() {
    for page in pages() {
        let text = read(&format!("docs/guide/{page}.md"));
        // the tables of a reference don't count
        let counted = if page == "scene-file" {
            text.lines().filter(|line| !line.starts_with('|')).collect::<Vec<_>>().join("\n")
        } else {
            text.clone()
        };
        let words = words(&counted);
        assert!(words <= MOST_WORDS, "{page}: {words} words");
        assert!(page == "symptoms" || text.contains("```rust"), "{page} has no snippet");
    }
    let readme = read("README.md").split_whitespace().count();
    assert!(readme <= 900, "README: {readme} words");
}

#[test]
fn the_fabrics_are_named() {
    let source = read("src/material.rs");
    let fabrics: Vec<_> = source
        .lines()
        .filter_map(|line| line.strip_prefix("pub const ")?.split_once(": Material = "))
        .map(|(name, _)| format!("`{name}`"))
        .collect();
    assert_eq!(fabrics.len(), 8, "the page says eight");
    let page = read("docs/guide/units.md");
    assert!(fabrics.iter().all(|name| page.contains(name)), "{fabrics:?}");
}
