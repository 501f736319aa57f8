//! Each lesson has a program of at most 60 lines, and a page with the program's output and plot.
//!
//! `UPDATE_LESSONS=1 cargo test -p lessons` writes output and plots into the pages, and still fails.

use std::fs;
use std::ops::Range;
use std::thread;

use crate::program::{LESSONS, read, root, run};

/// Start of a line that differs from machine to machine: text after its colon is not compared.
const ITS_OWN: &str = "wall time";

/// A block of a page in which a program is run.
struct Run {
    lesson: String,
    arguments: Vec<String>,
    /// The range of the program's output in the page.
    printed: Range<usize>,
}

fn runs(page: &str) -> Vec<Run> {
    const COMMAND: &str = "```sh\ncargo run --release -p lessons --bin ";
    const OPEN: &str = "```text\n";
    let run = |(start, _): (usize, &str)| {
        let rest = start + COMMAND.len();
        let mut words = page[rest..].lines().next().unwrap_or_default().split_whitespace().map(str::to_owned);
        let lesson = words.next().expect("a lesson");
        let from = rest + page[rest..].find(OPEN).expect("what it prints") + OPEN.len();
        let length = page[from..].find("```").expect("its end");
        Run { lesson, arguments: words.filter(|word| word != "--").collect(), printed: from..from + length }
    };
    page.match_indices(COMMAND).map(run).collect()
}

/// The compared parts of the lines of a text.
fn compared(text: &str) -> Vec<&str> {
    let compared = |line: &'_ str| if line.starts_with(ITS_OWN) { line.find(':').unwrap_or(0) } else { line.len() };
    text.lines().map(|line| line[..compared(line)].trim_end()).collect()
}

#[test]
fn pages_say_what_programs_print() {
    let pages = LESSONS.map(|(lesson, _)| lesson).into_iter().chain(["teachers"]);
    let wrong: Vec<_> = thread::scope(|scope| {
        let checks: Vec<_> = pages.map(|name| scope.spawn(move || differences(name))).collect();
        checks.into_iter().flat_map(|check| check.join().expect("programs run")).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Differences between a page and the output and plots of its programs. With `UPDATE_LESSONS` the page and the plots are rewritten.
fn differences(name: &str) -> Vec<String> {
    let file = format!("docs/lessons/{name}.md");
    let (mut page, mut wrong) = (read(&file), Vec::new());
    let update = std::env::var_os("UPDATE_LESSONS").is_some();
    // from the last one on, so that earlier ranges stay valid
    for Run { lesson, arguments, printed } in runs(&page).into_iter().rev() {
        let (found, plot) = run(&lesson, &arguments.iter().map(String::as_str).collect::<Vec<_>>());
        if compared(&page[printed.clone()]) != compared(&found) {
            wrong.push(format!("{file}, {lesson} {arguments:?}: the program prints\n{found}"));
        }
        page.replace_range(printed, &found);
        let picture = format!("docs/lessons/{lesson}.svg");
        if arguments.is_empty() && fs::read_to_string(root().join(&picture)).ok().as_ref() != Some(&plot) {
            wrong.push(format!("{picture} is not what the program draws"));
            if update {
                fs::write(root().join(&picture), plot).expect("the plot is written");
            }
        }
    }
    if update {
        fs::write(root().join(&file), page).expect("the page is written");
    }
    wrong
}

#[test]
fn lessons_and_their_exercises_are_run() {
    for (lesson, _) in LESSONS {
        let found = runs(&read(format!("docs/lessons/{lesson}.md")));
        assert!(found.iter().all(|run| run.lesson == lesson), "{lesson} runs another one");
        assert!(found.first().is_some_and(|run| run.arguments.is_empty()), "{lesson} runs nothing");
        assert!(found.iter().any(|run| !run.arguments.is_empty()), "the exercise of {lesson} runs nothing");
    }
}

#[test]
fn programs_have_sixty_lines_at_most() {
    for (lesson, _) in LESSONS {
        let lines = read(format!("examples/lessons/src/bin/{lesson}.rs")).lines().count();
        assert!(lines <= 60, "{lesson} has {lines} lines");
    }
}

#[test]
fn pages_have_all_that_a_lesson_needs() {
    let index = read("docs/lessons/README.md");
    for (number, (lesson, _)) in (1..).zip(LESSONS) {
        let page = read(format!("docs/lessons/{lesson}.md"));
        let needed = [
            format!("# {number}. "),
            "thesis".to_owned(),
            "$$".to_owned(),
            format!("({lesson}.svg)"),
            format!("(../../examples/lessons/src/bin/{lesson}.rs)"),
            format!("?lesson={number}"),
            "## Exercise".to_owned(),
            "<details>".to_owned(),
        ];
        for needed in needed {
            assert!(page.contains(&needed), "{lesson}.md lacks {needed}");
        }
        assert!(index.contains(&format!("({lesson}.md)")), "the index lacks {lesson}");
    }
}

#[test]
fn links_lead_somewhere() {
    let folder = root().join("docs/lessons");
    let pages = fs::read_dir(&folder).expect("the lessons").map(|entry| entry.expect("a file").path());
    for path in pages.filter(|path| path.extension().is_some_and(|extension| extension == "md")) {
        for link in links(&read(&path)) {
            assert!(folder.join(&link).exists(), "{}: {link}", path.display());
        }
    }
}

/// The files to which a page links, without anchors.
pub(crate) fn links(page: &str) -> Vec<String> {
    let targets = page.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
    targets.filter(|target| !target.is_empty() && !target.contains("://")).map(str::to_owned).collect()
}
