//! The pages that show the figures.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use cases::bench::{LINES, SIDE, SWEEPS};

use crate::figures::{Figure, PROCESSORS};
use crate::measure::strains;

const PAGE: &str = "docs/instructions.md";
const GUIDE: &str = "docs/guide/boards.md";
const FIXED_POINT: &str = "docs/fixed-point.md";
/// The line before the table of `GUIDE` and the first one of `FIXED_POINT`.
const FIGURES: &str = "<!-- figures of boards -->\n";
/// The line before the second table of `FIXED_POINT`.
const COSTS: &str = "<!-- costs on boards -->\n";
/// The line after a table.
const END: &str = "<!-- end of figures -->\n";

const PARTICLES: u64 = (SIDE * SIDE) as u64;
const STRETCH_LINKS: u64 = (2 * SIDE * (SIDE - 1)) as u64;
const BEND_LINKS: u64 = (2 * SIDE * (SIDE - 2)) as u64;
/// Two in every cell. The number of triangles is the same.
const DIAGONALS: u64 = (2 * (SIDE - 1) * (SIDE - 1)) as u64;

/// A kernel: its row's name, a scene with it, a scene without it, and its runs in a substep.
const KERNELS: [(&str, &str, Option<&str>, u64); 14] = [
    ("stretch link, XPBD sweep", "stretch", Some("bare"), STRETCH_LINKS),
    ("stretch link, Verlet sweep", "verlet, stretch", Some("verlet, bare"), STRETCH_LINKS),
    ("shear link, XPBD sweep", "shear", Some("bare"), DIAGONALS),
    ("bend link, XPBD sweep", "bend", Some("bare"), BEND_LINKS),
    ("damper of a link", "damped stretch", Some("stretch"), STRETCH_LINKS),
    ("limit of a link, not reached", "limited stretch", Some("stretch"), STRETCH_LINKS),
    ("tether of a particle, slack", "tethers", Some("bare"), 2 * PARTICLES),
    ("integration of a particle", "bare", None, PARTICLES),
    ("drag of a particle", "drag", Some("bare"), PARTICLES),
    ("facet wind on a triangle", "facet wind", Some("bare"), DIAGONALS),
    ("aerodynamic wind on a triangle", "aerodynamic wind", Some("bare"), DIAGONALS),
    ("panel wind on a cell", "panel wind", Some("bare"), DIAGONALS / 2),
    ("sphere, no contact, a particle", "sphere", Some("bare"), PARTICLES),
    ("capsule, no contact, a particle", "capsule", Some("bare"), PARTICLES),
];

/// A frame: its scene and its row's name.
const FRAMES: [(&str, &str); 8] = [
    ("xpbd", "XPBD, 8 substeps of stretch and shear"),
    ("xpbd, at rest", "the same, at rest (`Resting`)"),
    ("verlet", "position Verlet, 8 sweeps of stretch and shear"),
    ("lines", "line solver, stretch and shear, strain under 1 %"),
    ("lines, meeting itself", "the same, looking whether the sheet meets itself (`SelfContact`)"),
    ("damped lines", "the line solver with dampers in all links"),
    ("leapfrog", "leapfrog, 32 substeps of stretch and shear"),
    ("backward Euler", "backward Euler, a Newton step of stretch and shear"),
];

/// A part of a scene: its row's name, a scene with it and a scene without it.
const PARTS: [(&str, &str, &str); 16] = [
    ("nothing: `()` in every place", "unnamed", "bare"),
    ("stretch", "stretch", "bare"),
    ("shear", "shear", "bare"),
    ("bend", "bend", "bare"),
    ("damping of stretch", "damped stretch", "stretch"),
    ("limit of stretch", "limited stretch", "stretch"),
    ("tethers to two pins", "tethers", "bare"),
    ("drag", "drag", "bare"),
    ("facet wind", "facet wind", "bare"),
    ("aerodynamic wind", "aerodynamic wind", "bare"),
    ("panel wind", "panel wind", "bare"),
    ("sphere", "sphere", "bare"),
    ("plane", "plane", "bare"),
    ("capsule", "capsule", "bare"),
    ("self-contact", "lines, meeting itself", "lines"),
    ("rest, in motion", "xpbd, resting", "xpbd"),
];

/// Goals for a figure on each processor, and the figures that are compared with them.
struct Goal {
    what: &'static str,
    /// The goal, and a more ambitious aim in parentheses. Without a goal no figure is shown.
    goals: [&'static str; 3],
    /// The name, the number type and the figure of each row.
    reached: &'static [(&'static str, &'static str, Reached)],
}

/// A figure in a number type on each processor.
type Reached = fn(&Figures, &str) -> [f64; 3];

const VERLET_LINK: Reached = |figures, number| figures.run(number, KERNELS[1]);
const XPBD_LINK: Reached = |figures, number| figures.run(number, KERNELS[0]);
const VERLET: Reached = |figures, number| figures.millions(number, "verlet");
const XPBD: Reached = |figures, number| figures.millions(number, "xpbd");
const LINE_SOLVER: Reached = |figures, number| figures.millions(number, "lines");

const GOALS: [Goal; 4] = [
    Goal {
        what: "one link of a sweep, `Q13`",
        goals: ["75 (60)", "45 (32)", "40 (30)"],
        reached: &[("Verlet", "q13", VERLET_LINK), ("XPBD", "q13", XPBD_LINK)],
    },
    Goal {
        what: "one link of a sweep, `f32`",
        goals: ["", "", "30 (25)"],
        reached: &[("Verlet", "f32", VERLET_LINK), ("XPBD", "f32", XPBD_LINK)],
    },
    Goal {
        what: "frame of Verlet, 8 sweeps of stretch and shear, million",
        goals: ["0.65", "0.33", "0.29"],
        reached: &[
            ("`Q13`", "q13", VERLET),
            ("`Q24`", "q24", VERLET),
            ("XPBD in 8 substeps instead, `Q13`", "q13", XPBD),
        ],
    },
    Goal {
        what: "frame of the line solver, strain below 1 %, million",
        goals: ["0.5", "0.25", "0.14"],
        reached: &[("`Q13`", "q13", LINE_SOLVER), ("`f32`", "f32", LINE_SOLVER)],
    },
];

/// Frames whose costs have goals: the row's name, the scene, and for each of [`COUNTED_ON`] the first true count, the goal and a more ambitious aim, in thousands of
/// instructions.
const COSTLY_FRAMES: [(&str, &str, [[u32; 3]; 3]); 2] = [
    ("line solver, strain below 1 %", "lines", [[658, 400, 330], [356, 230, 180], [196, 120, 100]]),
    ("XPBD, 8 substeps of stretch and shear", "xpbd", [[1070, 650, 535], [660, 400, 330], [851, 500, 420]]),
];
/// The name, the number type and the index of the processor.
const COUNTED_ON: [(&str, &str, usize); 3] = [("`Q13`, M0", "q13", 0), ("M3", "q13", 1), ("`f32`, M4F", "f32", 2)];

fn path(page: &str) -> PathBuf {
    emulator::root().join(page)
}

pub(crate) fn write(figures: &[Figure]) {
    fs::write(path(PAGE), page(figures)).expect("docs/instructions.md can be written");
    fs::write(path(GUIDE), guide(figures)).expect("the guide can be written");
    fs::write(path(FIXED_POINT), fixed_point(figures)).expect("docs/fixed-point.md can be written");
}

/// Compares the pages with the committed figures.
pub(crate) fn check(figures: &[Figure]) {
    for (path, expected) in [(PAGE, page(figures)), (GUIDE, guide(figures)), (FIXED_POINT, fixed_point(figures))] {
        let found = fs::read_to_string(self::path(path)).expect("a page can be read");
        assert!(found == expected, "{path} doesn't show docs/instructions.csv");
    }
}

struct Figures<'a>(&'a [Figure]);

impl<'a> Figures<'a> {
    fn numbers(&self) -> Vec<&'a str> {
        let mut numbers: Vec<_> = self.0.iter().map(|figure| figure.number.as_str()).collect();
        numbers.dedup();
        numbers
    }

    fn get(&self, number: &str, scene: &str) -> &'a Figure {
        let found = self.0.iter().find(|figure| (figure.number.as_str(), figure.scene.as_str()) == (number, scene));
        found.unwrap_or_else(|| panic!("no figure of {scene} in {number}"))
    }

    /// Instructions of a frame that a scene takes in addition to another scene, for each processor.
    fn more(&self, number: &str, scene: &str, than: Option<&str>) -> [i64; 3] {
        let with = self.get(number, scene).instructions();
        let without = than.map_or([0; 3], |than| self.get(number, than).instructions());
        std::array::from_fn(|processor| with[processor] as i64 - without[processor] as i64)
    }

    /// Instructions of one run of a kernel, for each processor.
    fn run(&self, number: &str, (_, scene, than, runs): (&str, &str, Option<&str>, u64)) -> [f64; 3] {
        // Verlet's scenes have one substep with as many sweeps as XPBD's have substeps
        let runs = runs * u64::from(SWEEPS);
        self.more(number, scene, than).map(|more| more as f64 / runs as f64)
    }

    /// Like [`Self::run`], formatted.
    fn kernel(&self, number: &str, kernel: (&str, &str, Option<&str>, u64)) -> [String; 3] {
        self.run(number, kernel).map(|instructions| format!("{instructions:.0}"))
    }

    /// Millions of instructions of a frame, for each processor.
    fn millions(&self, number: &str, scene: &str) -> [f64; 3] {
        self.get(number, scene).instructions().map(|count| count as f64 / 1e6)
    }
}

fn page(figures: &[Figure]) -> String {
    let figures = Figures(figures);
    let mut text = format!(
        "# Costs on a board\n\n\
         Executed instructions, including loads and stores, averaged over a sheet of {SIDE} × {SIDE} particles that hangs from two corners. `SysTick` counts them in \
         QEMU, where every instruction takes a nanosecond and a tick takes 80. Rust {}.0 compiles the programs with the profile `release` of `laboratory/firmware`. The compiler \
         doesn't know the numbers of a scene. [`instructions.csv`](instructions.csv) has the counts themselves.\n\n\
         A second counter, independent of that clock, counts the same frames: a plugin of QEMU, [`counter`](../laboratory/counter/src/lib.rs), adds up the instructions of \
         every block that runs. In every scene and number type both must agree within 1 % or within a tick.\n\n\
         `cargo test -p emulator --test boards -- --include-ignored` measures all figures. It fails if one is off by more than 3 %, and a count of instructions by more than \
         a tick. With `UPDATE_INSTRUCTIONS=1` it writes this page.\n",
        env!("CARGO_PKG_RUST_VERSION")
    );
    text += "\n## Kernels\n\nInstructions of one run of each kernel.\n\n";
    text += &head(&["", "number"], &PROCESSORS);
    for kernel in KERNELS {
        for number in figures.numbers() {
            text += &row(&[kernel.0, number], &figures.kernel(number, kernel));
        }
    }
    text += "\n## Frames\n\nThousands of instructions of a frame.\n\n";
    text += &head(&["", "number"], &PROCESSORS);
    for (scene, name) in FRAMES {
        for number in figures.numbers() {
            text += &row(&[name, number], &thousands(figures.get(number, scene)));
        }
    }
    let strains = strains();
    assert!(strains.values().all(|strain| *strain <= 0.01), "the line solver's strain: {strains:?}");
    let strains: Vec<_> =
        strains.iter().map(|(number, strain)| format!("{:.2} % in {number}", 100.0 * strain)).collect();
    let _ = write!(
        text,
        "\nThe line solver takes {} for a frame of a sixtieth of a second. It sweeps at least {}, until no row is strained by more than \
         {} %. Its counts are means of the first second, in which the largest strain of a stretch link at the end of a frame is {}.\n",
        if LINES.1 == 1 { "one substep".to_owned() } else { format!("{} substeps", LINES.1) },
        if LINES.0.sweeps == 1 { "once".to_owned() } else { format!("{} times", LINES.0.sweeps) },
        100.0 * LINES.0.tolerance,
        strains.join(", ")
    );
    text += "\n## Costs of the parts of a scene\n\nAdditional bytes of flash (Cortex-M0), and additional thousands of instructions of a frame of 8 substeps. Parts that \
             a scene doesn't name cost nothing. (Negative flash: without the part a loop is short, and the compiler spends flash \
             on unrolling it.)\n\n";
    text += &head(&["named", "number"], &["flash", PROCESSORS[0], PROCESSORS[1], PROCESSORS[2]]);
    for (name, scene, than) in PARTS {
        for number in figures.numbers() {
            let flash = figures.get(number, scene).flash as i64 - figures.get(number, than).flash as i64;
            let more = figures.more(number, scene, Some(than));
            let [m0, m3, m4f] = more.map(|more| format!("{:.1}", (more as f64 / 100.0).round() / 10.0 + 0.0));
            text += &row(&[name, number], &[flash.to_string(), m0, m3, m4f]);
        }
    }
    text += "\n## Memory\n\nBytes of RAM a particle, without the stack, and bytes of flash (Cortex-M0) of a program that moves the sheet and does nothing \
             else.\n\n";
    text += &head(&["stretch and shear, by", "number"], &["cloth", "solver's memory", "flash"]);
    for (scene, name) in [("xpbd", "XPBD"), ("verlet", "position Verlet"), ("lines", "line solver")] {
        for number in figures.numbers() {
            let figure = figures.get(number, scene);
            let bytes = [figure.cloth, figure.memory].map(|bytes| format!("{:.0}", bytes as f64 / PARTICLES as f64));
            let [cloth, memory] = bytes;
            text += &row(&[name, number], &[cloth, memory, figure.flash.to_string()]);
        }
    }
    text += "\n## Routines that a step calls\n\nFor every scene of this page, a test follows the calls of a step in fixed point through the linked program for the Cortex-M0. \
             As far as they can be followed, no step reaches a routine for divisions or 64-bit products, or a panic. The program links no routine for floats and no allocator.\n";
    text
}

/// The page with `text` between the line `mark` and the next [`END`].
fn replaced(page: &str, mark: &str, text: &str) -> String {
    let (before, rest) = page.split_once(mark).expect("a page has a place for figures");
    let (_, after) = rest.split_once(END).expect("the place for figures ends");
    [before, mark, text, END, after].concat()
}

fn read(page: &str) -> String {
    fs::read_to_string(path(page)).expect("a page can be read")
}

/// The table of costs on boards: thousands of instructions, and KiB.
fn costs(figures: &Figures) -> String {
    let mut table = head(&[""], &["at first", "goal (aim)", "now"]);
    for (name, scene, counts) in COSTLY_FRAMES {
        for ((column, number, processor), [first, goal, aim]) in COUNTED_ON.into_iter().zip(counts) {
            let what = if processor == 0 { format!("{name}, {column}") } else { format!("… {column}") };
            let now = thousands(figures.get(number, scene))[processor].clone();
            table += &row(&[&what], &[first.to_string(), format!("{goal} ({aim})"), now]);
        }
    }
    let flash = format!("{:.0}", figures.get("q13", "lines").flash as f64 / 1024.0);
    table + &row(&["line solver's flash on the M0, `Q13`, KiB"], &["44 to 48".to_owned(), "30 (24)".to_owned(), flash])
}

/// The page about fixed point with its tables of goals. Figures that reach their goal are bold.
fn fixed_point(figures: &[Figure]) -> String {
    let figures = Figures(figures);
    let mut table = head(&["", ""], &PROCESSORS);
    for Goal { what, goals, reached } in &GOALS {
        let word = if goals.iter().any(|goal| goal.contains('(')) { "goal (aim)" } else { "goal" };
        table += &row(&[what, word], &goals.map(str::to_owned));
        for (name, number, reached) in *reached {
            let counts = reached(&figures, number);
            let cells = std::array::from_fn::<_, 3, _>(|processor| {
                let Some(goal) = goals[processor].split(' ').next().and_then(|goal| goal.parse::<f64>().ok()) else {
                    return String::new();
                };
                let count = counts[processor];
                let text = if goal < 1.0 { format!("{count:.2}") } else { format!("{count:.0}") };
                if count <= goal { format!("**{text}**") } else { text }
            });
            table += &row(&["", &format!("reached, {name}")], &cells);
        }
    }
    let bytes = |scene| {
        let figure = figures.get("q13", scene);
        (figure.cloth + figure.memory) / PARTICLES
    };
    let blank = [String::new(), String::new()];
    let ram = [
        ("RAM a particle, Verlet and XPBD; line solver, bytes", "goal", "24; 56".to_owned()),
        ("", "reached", format!("{}; {}", bytes("xpbd"), bytes("lines"))),
    ];
    for (what, word, bytes) in ram {
        table += &row(&[what, word], &[&[bytes][..], &blank].concat());
    }
    replaced(&replaced(&read(FIXED_POINT), FIGURES, &table), COSTS, &costs(&figures))
}

/// The guide to boards with its table.
fn guide(figures: &[Figure]) -> String {
    let figures = Figures(figures);
    let mut table = head(&["16 × 16 particles", "number"], &PROCESSORS);
    for number in figures.numbers() {
        table += &row(&["instructions of a link (XPBD)", number], &figures.kernel(number, KERNELS[0]));
    }
    for (scene, name) in [FRAMES[0], FRAMES[1], FRAMES[3]] {
        for number in figures.numbers() {
            table += &row(&[&format!("thousands for a frame: {name}"), number], &thousands(figures.get(number, scene)));
        }
    }
    let memory = |scene: &str| {
        let all: Vec<_> = figures.numbers().into_iter().map(|number| figures.get(number, scene)).collect();
        let [least, most] = [all.iter().map(|f| f.flash).min(), all.iter().map(|f| f.flash).max()];
        let [least, most] = [least, most].map(|bytes| bytes.unwrap_or_default() as f64 / 1024.0);
        let ram = all.iter().map(|f| f.cloth + f.memory).max().unwrap_or_default();
        format!("{least:.0} to {most:.0} KB of flash and {:.1} KB of RAM", ram as f64 / 1024.0)
    };
    let [xpbd, lines] = ["xpbd", "lines"].map(memory);
    let _ =
        writeln!(table, "\nA program that moves such a sheet takes {xpbd} with XPBD, {lines} with the line solver.");
    replaced(&read(GUIDE), FIGURES, &table)
}

fn thousands(figure: &Figure) -> [String; 3] {
    // a frame at rest takes few
    figure.instructions().map(|count| format!("{:.*}", if count < 10_000 { 2 } else { 0 }, count as f64 / 1e3))
}

fn head(left: &[&str], right: &[&str]) -> String {
    let rule = "---|".repeat(left.len()) + &"---:|".repeat(right.len());
    format!("| {} | {} |\n|{rule}\n", left.join(" | "), right.join(" | "))
}

fn row(left: &[&str], right: &[String]) -> String {
    format!("| {} | {} |\n", left.join(" | "), right.join(" | "))
}
