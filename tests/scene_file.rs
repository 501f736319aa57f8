//! Scene files: the meaning of a good one, and the error line for a bad one.

use kerchief::host::{
    BUILT_IN, DEFAULT_SCENE, Description, Everything, Pose, SHAPES, SolverKind, Weave, WindModel, built_in,
};
use kerchief::{Q24, Scalar, Stillness};

/// A good scene with every key, which tests spoil.
const GOOD: &str = r##"
name = "good"
[cloth]
columns = 24
rows = 16
width = 2.3
height = 1.5
mass = 0.5
hem = 2.0
pose = "lay"
origin = [-1.0, 2.0, 3.0]
pins = [[0, 0], [23, 15], [0, 0]]
[stretch]
stiffness = 100.0
damping = 0.25
[shear]
compliance = 0.1
[bend]
stiffness = 1.0
[tether]
slack = 0.0
[environment]
gravity = [0.0, 0.0, -9.81]
drag = 0.5
wind = { velocity = [5, 0, -3], model = "aerodynamic", density = 1.3, drag_coefficient = 1.5 }
[[sphere]]
centre = [1.0, 2.0, 3.0]
radius = 0.5
margin = 0.1
friction = 0.2
velocity = [0.0, 1.0, 0.0]
[[sphere]]
centre = [0.0, 0.0, 0.0]
radius = 2
[[plane]]
point = [0.0, 0.0, -1.0]
normal = [0.0, 3.0, 4.0]
margin = 0.1
friction = 0.2
[[capsule]]
a = [0.0, 0.0, 0.0]
b = [0.0, 0.0, 1.0]
radius = 0.5
margin = 0.1
friction = 0.2
[solver]
kind = "leapfrog"
step = 0.1
substeps = 8
iterations = 3
sweeps = 5
tolerance = 0.01
strain_limit = 0.1
[self]
thickness = 0.09
friction = 0.4
[rest]
speed = 0.002
time = 2
[run]
frames = 20
[picture]
azimuth = -400.0
elevation = 20
low = [-1.0, -1.0, 0.0]
high = [1.0, 1.0, 2.0]
pattern = "checks"
bands = 5
colours = ["#102030", "#Ff00a0"]
"##;

fn spoilt(from: &str, to: &str) -> String {
    assert_eq!(GOOD.matches(from).count(), 1, "{from:?} must stand in the good scene once");
    GOOD.replacen(from, to, 1)
}

/// Asserts that `text` is refused for `key`, in one line that contains `reason`.
fn refused(text: &str, key: &str, reason: &str) {
    let error = Description::parse(text).expect_err(text);
    let line = error.to_string();
    assert_eq!(error.key, key, "{line}");
    assert!(line.contains(reason), "{line:?} does not say {reason:?}");
    assert!(!line.contains('\n') && !line.contains('\r'), "{line:?}");
}

#[test]
fn a_scene_means_what_it_says() {
    let scene = Description::parse(GOOD).unwrap();
    let sheet = &scene.sheet;
    assert_eq!((sheet.columns, sheet.rows, sheet.width, sheet.height), (24, 16, 2.3, 1.5));
    assert_eq!((sheet.pose, sheet.origin), (Pose::Lay, [-1.0, 2.0, 3.0]));
    assert_eq!(sheet.pins, [[0, 0], [23, 15]], "a pin named twice is one pin");
    let masses = [(0, 0), (23, 0), (0, 1), (1, 15), (1, 1)].map(|(column, row)| sheet.mass_at(column, row));
    assert_eq!(masses, [1.0, 1.0, 1.0, 1.0, 0.5]);
    let (stretch, shear) = (scene.stretch.unwrap(), scene.shear.unwrap());
    assert_eq!((stretch.stiffness, stretch.damping), (100.0, 0.25));
    assert_eq!((shear.stiffness, shear.damping), (10.0, 0.0));
    assert_eq!(scene.tether_slack, Some(0.0));
    assert_eq!((scene.gravity, scene.drag.unwrap().rate), ([0.0, 0.0, -9.81], 0.5));
    let wind = scene.wind.unwrap();
    assert_eq!(wind.velocity, [5.0, 0.0, -3.0]);
    assert_eq!(wind.model, WindModel::Aerodynamic { density: 1.3, drag_coefficient: 1.5 });
    assert_eq!(scene.spheres.len(), 2);
    assert_eq!((scene.spheres[0].radius, scene.spheres[0].velocity), (0.5, [0.0, 1.0, 0.0]));
    assert_eq!((scene.spheres[1].surface.margin, scene.spheres[1].surface.friction), (0.0, 0.0));
    let normal = scene.planes[0].normal;
    assert!((normal[1] - 0.6).abs() < 1e-15 && (normal[2] - 0.8).abs() < 1e-15, "{normal:?}");
    assert_eq!(scene.capsules[0].b, [0.0, 0.0, 1.0]);
    assert_eq!((scene.solver.kind, scene.solver.substeps, scene.solver.iterations), (SolverKind::Leapfrog, 8, 3));
    assert_eq!(scene.solver.sweeps, Some(5));
    assert_eq!(
        (scene.solver.step, scene.solver.tolerance, scene.solver.strain_limit, scene.frames),
        (0.1, 0.01, Some(0.1), 20)
    );
    let own = scene.self_contact.unwrap();
    assert_eq!((own.thickness, own.friction), (Some(0.09), 0.4));
    let acceleration = Stillness::DEFAULT.acceleration;
    assert_eq!(scene.rest, Some(Stillness { speed: 0.002, acceleration, time: 2.0 }));
    let picture = &scene.picture;
    assert_eq!((picture.azimuth, picture.elevation, picture.bands), (-40.0, 20.0, 5));
    assert_eq!(picture.frame, Some([[-1.0, -1.0, 0.0], [1.0, 1.0, 2.0]]));
    assert_eq!((picture.pattern, picture.colours), (Weave::Checks, [[16, 32, 48], [255, 0, 160]]));
}

#[test]
fn what_is_left_out_is_off() {
    let text = "[cloth]\ncolumns = 4\nrows = 4\nwidth = 1\nheight = 1\nmass = 1\n";
    let scene = Description::parse(text).unwrap();
    assert!(scene.stretch.is_none() && scene.shear.is_none() && scene.bend.is_none());
    assert!(scene.tether_slack.is_none() && scene.drag.is_none() && scene.wind.is_none());
    assert!(scene.spheres.is_empty() && scene.planes.is_empty() && scene.capsules.is_empty());
    assert!(scene.sheet.pins.is_empty() && scene.rest.is_none() && scene.self_contact.is_none());
    assert_eq!([scene.sheet.mass_at(0, 0), scene.sheet.mass_at(1, 1)], [1.0, 1.0]);
    assert_eq!((scene.gravity, scene.sheet.pose), ([0.0; 3], Pose::Lay));
    let solver = scene.solver;
    assert_eq!((solver.iterations, solver.sweeps, solver.tolerance, solver.strain_limit), (1, None, 0.02, None));
}

#[test]
fn density_spreads_by_the_area_around_each_particle() {
    let scene = Description::parse(&spoilt("mass = 0.5\nhem = 2.0", "density = 0.2")).unwrap();
    let mass = |column, row| scene.sheet.mass_at(column, row);
    let total: f64 = (0..16).flat_map(|row| (0..24).map(move |column| (column, row))).map(|(c, r)| mass(c, r)).sum();
    assert!((total - 0.2 * 2.3 * 1.5).abs() < 1e-12, "the sheet weighs density times area, is {total}");
    let cell = 0.2 * (2.3 / 23.0) * (1.5 / 15.0);
    for (column, row, share) in [(0, 0, 0.25), (1, 0, 0.5), (0, 1, 0.5), (1, 1, 1.0), (23, 15, 0.25)] {
        assert!((mass(column, row) - share * cell).abs() < 1e-15, "particle ({column}, {row})");
    }
}

#[test]
fn verlet_damping_keeps_its_share_over_one_step() {
    let scene = Description::parse(&spoilt("drag = 0.5", "verlet_damping = 0.1")).unwrap();
    let kept = (-scene.drag.unwrap().rate * scene.solver.step).exp();
    assert!((kept - 0.9).abs() < 1e-15);
    let none = Description::parse(&spoilt("drag = 0.5", "verlet_damping = 0")).unwrap();
    assert_eq!(none.drag, None);
}

#[test]
fn pins_have_names() {
    let pins = |name: &str| {
        let scene = spoilt("pins = [[0, 0], [23, 15], [0, 0]]", &format!("pins = \"{name}\""));
        Description::parse(&scene).unwrap().sheet.pins
    };
    assert_eq!(pins("top"), (0..24).map(|column| [column, 0]).collect::<Vec<_>>());
    assert_eq!(pins("left"), (0..16).map(|row| [0, row]).collect::<Vec<_>>());
    assert_eq!(pins("corners"), [[0, 0], [23, 0], [0, 15], [23, 15]]);
    assert_eq!(pins("top-corners"), [[0, 0], [23, 0]]);
}

#[test]
fn a_sheet_of_one_column_is_a_chain() {
    let text = "[cloth]\ncolumns = 1\nrows = 32\nheight = 3.1\nmass = 0.1\npose = \"hang\"\npins = \"top-corners\"\n";
    let sheet = Description::parse(text).unwrap().sheet;
    assert_eq!((sheet.columns, sheet.rows, sheet.width), (1, 32, 0.0));
    assert_eq!(sheet.pins, [[0, 0]], "its two top corners are one particle");
}

#[test]
fn every_shape_is_accepted() {
    for &(columns, rows) in SHAPES {
        let text = format!("[cloth]\ncolumns = {columns}\nrows = {rows}\nwidth = 1\nheight = 1\nmass = 1\n");
        let sheet = Description::parse(&text).unwrap().sheet;
        assert_eq!((sheet.columns, sheet.rows), (columns, rows));
    }
}

#[test]
fn built_in_scenes_are_good_and_bear_their_names() {
    for scene in BUILT_IN {
        let description = Description::parse(scene.text).unwrap_or_else(|error| panic!("{}: {error}", scene.name));
        assert_eq!(description.name, scene.name);
    }
    assert!(built_in(DEFAULT_SCENE).is_some());
    assert!(built_in("no-such-scene").is_none());
}

#[test]
fn the_thesis_scenes_share_their_sheet() {
    for name in ["gravity", "sphere", "wind", "no-shear"] {
        let scene = Description::parse(built_in(name).unwrap().text).unwrap();
        let stiffness = |family: Option<kerchief::host::Spring>| family.map(|spring| spring.stiffness);
        assert_eq!(stiffness(scene.stretch), Some(94270.0), "{name}");
        assert_eq!(stiffness(scene.shear), (name != "no-shear").then_some(9427.0), "{name}");
        assert_eq!(stiffness(scene.bend), Some(942.7), "{name}");
        assert_eq!((scene.sheet.columns, scene.sheet.rows), (32, 32), "{name}");
        assert_eq!((scene.sheet.width, scene.sheet.height, scene.sheet.pose), (10.0, 10.0, Pose::Lay), "{name}");
        assert_eq!(scene.sheet.origin, [-5.0, -5.0, 0.0], "{name}");
        assert_eq!([scene.sheet.mass_at(0, 0), scene.sheet.mass_at(1, 1)], [1.0, 1.0], "{name}");
        assert_eq!(scene.solver.step, 0.1, "{name}");
        assert!((scene.drag.unwrap().rate - 1.053_605).abs() < 1e-6, "{name}");
        assert_eq!(scene.frames, if name == "no-shear" { 50 } else { 100 }, "{name}");
        assert_eq!(scene.spheres.len(), usize::from(matches!(name, "sphere" | "no-shear")), "{name}");
        assert_eq!(scene.wind.is_some(), name == "wind", "{name}");
    }
}

/// The text to replace, its replacement, the key in the error, and words of its reason.
type Bad = (&'static str, &'static str, &'static str, &'static str);

fn all_refused(cases: &[Bad]) {
    for (from, to, key, reason) in cases {
        refused(&spoilt(from, to), key, reason);
    }
}

#[test]
fn unknown_keys() {
    all_refused(&[
        ("name = \"good\"", "nmae = \"good\"", "nmae", "unknown key, expected one of `name`, `cloth`"),
        ("[bend]", "[bends]", "bends", "unknown key"),
        ("columns = 24", "columns = 24\ndepth = 2", "cloth.depth", "unknown key, expected one of `columns`"),
        ("damping = 0.25", "dampening = 0.25", "stretch.dampening", "unknown key"),
        ("slack = 0.0", "slak = 0.0", "tether.slak", "unknown key, expected `slack`"),
        ("\ndrag = 0.5", "\nviscosity = 0.5", "environment.viscosity", "unknown key"),
        ("density = 1.3", "rho = 1.3", "environment.wind.rho", "unknown key"),
        ("velocity = [0.0, 1.0, 0.0]", "speed = 1.0", "sphere[0].speed", "unknown key"),
        ("radius = 2\n", "radius = 2\nmass = 1\n", "sphere[1].mass", "unknown key"),
        ("normal = [0.0, 3.0, 4.0]", "normals = [0.0, 3.0, 4.0]", "plane[0].normals", "unknown key"),
        ("b = [0.0, 0.0, 1.0]", "c = [0.0, 0.0, 1.0]", "capsule[0].c", "unknown key"),
        ("substeps = 8", "sub_steps = 8", "solver.sub_steps", "unknown key"),
        ("friction = 0.4", "slip = 0.4", "self.slip", "unknown key, expected `thickness` or `friction`"),
        ("time = 2\n", "seconds = 2\n", "rest.seconds", "unknown key, expected one of `speed`"),
        ("frames = 20", "seconds = 20", "run.seconds", "unknown key, expected `frames`"),
        ("frames = 20", "\"a\\nb\" = 20", "run.a\nb", "run.a\\nb: unknown key"),
    ]);
}

#[test]
fn wrong_types() {
    all_refused(&[
        ("name = \"good\"", "name = 5", "name", "expected a string"),
        ("columns = 24", "columns = 24.0", "cloth.columns", "expected a whole number"),
        ("rows = 16", "rows = \"16\"", "cloth.rows", "expected a whole number"),
        ("width = 2.3", "width = \"2.3 m\"", "cloth.width", "invalid type: string \"2.3 m\", expected a number"),
        ("mass = 0.5", "mass = true", "cloth.mass", "expected a number"),
        ("height = 1.5", "height = 1979-05-27", "cloth.height", "expected a number"),
        ("origin = [-1.0, 2.0, 3.0]", "origin = 3.0", "cloth.origin", "expected three numbers [x, y, z]"),
        ("origin = [-1.0, 2.0, 3.0]", "origin = [-1.0, 2.0]", "cloth.origin", "invalid length 2, expected three"),
        ("gravity = [0.0, 0.0, -9.81]", "gravity = [0, 0, 0, -9.81]", "environment.gravity", "invalid length 4"),
        ("gravity = [0.0, 0.0, -9.81]", "gravity = [0, 0, \"g\"]", "environment.gravity[2]", "expected a number"),
        ("pins = [[0, 0], [23, 15], [0, 0]]", "pins = 3", "cloth.pins", "expected a list of [column, row] or one of"),
        ("[23, 15]", "[23, 1.5]", "cloth.pins[1][1]", "invalid type: floating point `1.5`, expected a whole number"),
        ("[23, 15]", "3", "cloth.pins[1]", "invalid type: integer `3`, expected a list"),
        ("name = \"good\"", "name = [5]", "name", "invalid type: list, expected a string"),
        ("name = \"good\"", "name = { a = 5 }", "name", "invalid type: table, expected a string"),
        (
            "rows = 16",
            "rows = 18446744073709551616",
            "cloth.rows",
            "invalid type: integer `18446744073709551616`, expected a whole number",
        ),
        ("stiffness = 100.0", "stiffness = [100.0]", "stretch.stiffness", "expected a number"),
        ("substeps = 8", "substeps = [8]", "solver.substeps", "expected a whole number"),
        ("kind = \"leapfrog\"", "kind = 4", "solver.kind", "expected a string"),
        ("velocity = [5, 0, -3], ", "velocity = \"west\", ", "environment.wind.velocity", "expected three numbers"),
    ]);
    refused("cloth = 4\n", "cloth", "invalid type: integer `4`, expected a table");
    refused("stretch = [100.0, 1.0]\n", "stretch", "expected a table");
    refused(
        "[cloth]\ncolumns = 4\nrows = 4\nwidth = 1\nheight = 1\nmass = 1\n[sphere]\nradius = 1\n",
        "sphere",
        "invalid type: table, expected a list",
    );
}

#[test]
fn numbers_out_of_range() {
    all_refused(&[
        ("width = 2.3", "width = 0.0", "cloth.width", "must be above zero, is 0"),
        ("width = 2.3", "width = nan", "cloth.width", "must be finite, is NaN"),
        ("height = 1.5", "height = -1.5", "cloth.height", "must be above zero, is -1.5"),
        ("height = 1.5", "height = inf", "cloth.height", "must be finite, is inf"),
        ("mass = 0.5", "mass = -0.5", "cloth.mass", "must be above zero, is -0.5"),
        ("mass = 0.5", "mass = 0", "cloth.mass", "must be above zero, is 0"),
        ("mass = 0.5", "density = -1.0", "cloth.density", "must be above zero"),
        ("mass = 0.5", "mass = 1e308", "cloth.mass", "gives a particle the mass inf kg"),
        ("mass = 0.5", "density = 5e-324", "cloth.density", "gives a particle the mass 0 kg"),
        ("hem = 2.0", "hem = 0.0", "cloth.hem", "must be above zero"),
        ("hem = 2.0", "hem = -inf", "cloth.hem", "must be finite, is -inf"),
        ("origin = [-1.0, 2.0, 3.0]", "origin = [-1.0, inf, 3.0]", "cloth.origin[1]", "must be finite"),
        ("stiffness = 100.0", "stiffness = -100.0", "stretch.stiffness", "must be zero or above, is -100"),
        ("compliance = 0.1", "compliance = -0.1", "shear.compliance", "must be above zero"),
        ("compliance = 0.1", "compliance = 0", "shear.compliance", "must be above zero"),
        ("compliance = 0.1", "compliance = 1e-320", "shear.compliance", "too small"),
        ("damping = 0.25", "damping = -0.25", "stretch.damping", "must be zero or above"),
        ("slack = 0.0", "slack = -0.1", "tether.slack", "must be zero or above"),
        ("gravity = [0.0, 0.0, -9.81]", "gravity = [0, 0, -inf]", "environment.gravity[2]", "must be finite"),
        ("\ndrag = 0.5", "\ndrag = -0.5", "environment.drag", "must be zero or above"),
        ("\ndrag = 0.5", "\nverlet_damping = 1.0", "environment.verlet_damping", "at least 0 and below 1, is 1"),
        ("\ndrag = 0.5", "\nverlet_damping = -0.1", "environment.verlet_damping", "at least 0 and below 1"),
        ("density = 1.3", "density = 0", "environment.wind.density", "must be above zero"),
        ("drag_coefficient = 1.5", "drag_coefficient = -1", "environment.wind.drag_coefficient", "zero or above"),
        ("velocity = [5, 0, -3]", "velocity = [5, nan, -3]", "environment.wind.velocity[1]", "must be finite"),
        ("radius = 2\n", "radius = 0\n", "sphere[1].radius", "must be above zero"),
        ("radius = 2\n", "radius = -2\n", "sphere[1].radius", "must be above zero"),
        ("radius = 2\n", "radius = 2\nmargin = -0.1\n", "sphere[1].margin", "must be zero or above"),
        ("radius = 2\n", "radius = 2\nfriction = -0.1\n", "sphere[1].friction", "must be zero or above"),
        ("normal = [0.0, 3.0, 4.0]", "normal = [0, 0.0, 0]", "plane[0].normal", "must not be the zero vector"),
        ("b = [0.0, 0.0, 1.0]", "b = [0.0, 0.0, 0.0]", "capsule[0].b", "must differ from a"),
        ("step = 0.1", "step = 0.0", "solver.step", "must be above zero"),
        ("step = 0.1", "step = -0.1", "solver.step", "must be above zero"),
        ("substeps = 8", "substeps = 0", "solver.substeps", "from 1 to 1048576, is 0"),
        ("substeps = 8", "substeps = -8", "solver.substeps", "is -8"),
        ("iterations = 3", "iterations = 0", "solver.iterations", "is 0"),
        ("sweeps = 5", "sweeps = 0", "solver.sweeps", "is 0"),
        ("tolerance = 0.01", "tolerance = 0.0", "solver.tolerance", "must be above zero"),
        ("thickness = 0.09", "thickness = 0.0", "self.thickness", "must be above zero"),
        ("friction = 0.4", "friction = -0.4", "self.friction", "must be zero or above"),
        ("speed = 0.002", "speed = 0", "rest.speed", "must be above zero"),
        ("time = 2\n", "time = -2\n", "rest.time", "must be above zero"),
        ("strain_limit = 0.1", "strain_limit = -0.1", "solver.strain_limit", "must be above zero"),
        ("frames = 20", "frames = 0", "run.frames", "is 0"),
        ("frames = 20", "frames = 99999999999", "run.frames", "is 99999999999"),
        ("columns = 24", "columns = 0", "cloth.columns", "is 0"),
        ("rows = 16", "rows = -16", "cloth.rows", "is -16"),
    ]);
    let instant = spoilt("\ndrag = 0.5", "\nverlet_damping = 0.5").replace("step = 0.1", "step = 1e-320");
    refused(&instant, "environment.verlet_damping", "not finite");
}

#[test]
fn keys_that_exclude_or_need_each_other() {
    all_refused(&[
        ("mass = 0.5", "mass = 0.5\ndensity = 0.1", "cloth.density", "give mass or density, not both"),
        ("mass = 0.5", "", "cloth.mass", "missing; give mass"),
        (
            "stiffness = 100.0",
            "stiffness = 1\ncompliance = 1",
            "stretch.compliance",
            "stiffness or compliance, not both",
        ),
        ("stiffness = 100.0", "", "stretch.stiffness", "missing; give stiffness (N/m) or compliance"),
        ("\ndrag = 0.5", "\ndrag = 0\nverlet_damping = 0", "environment.verlet_damping", "drag or verlet_damping, not"),
        (
            "model = \"aerodynamic\"",
            "model = \"facet\"",
            "environment.wind.density",
            "only with model = \"aerodynamic\"",
        ),
        (", model = \"aerodynamic\"", "", "environment.wind.model", "missing"),
        ("width = 2.3", "", "cloth.width", "missing"),
        ("height = 1.5", "", "cloth.height", "missing"),
        ("columns = 24", "", "cloth.columns", "missing"),
        ("point = [0.0, 0.0, -1.0]", "", "plane[0].point", "missing"),
        ("centre = [1.0, 2.0, 3.0]", "", "sphere[0].centre", "missing"),
    ]);
    refused("name = \"nothing\"\n", "cloth", "missing");
    refused("", "cloth", "missing");
    refused("[cloth]\ncolumns = 1\nrows = 32\nheight = 1\ndensity = 1\n", "cloth.density", "no area");
}

#[test]
fn names_and_places_that_do_not_exist() {
    all_refused(&[
        ("pose = \"lay\"", "pose = \"stand\"", "cloth.pose", "unknown variant `stand`, expected `lay` or `hang`"),
        ("kind = \"leapfrog\"", "kind = \"magic\"", "solver.kind", "unknown variant `magic`, expected one of `verlet`"),
        ("model = \"aerodynamic\"", "model = \"calm\"", "environment.wind.model", "unknown variant `calm`"),
        ("pins = [[0, 0], [23, 15], [0, 0]]", "pins = \"middle\"", "cloth.pins", "invalid value: string \"middle\""),
        ("[23, 15]", "[24, 15]", "cloth.pins[1]", "[24, 15] is outside the grid of 24x16"),
        ("[23, 15]", "[0, 16]", "cloth.pins[1]", "[0, 16] is outside the grid"),
        ("[23, 15]", "[-1, 0]", "cloth.pins[1]", "[-1, 0] is outside the grid"),
        ("[23, 15]", "[1]", "cloth.pins[1]", "must be [column, row], is [1]"),
        ("[23, 15]", "[1, 2, 3]", "cloth.pins[1]", "must be [column, row], is [1, 2, 3]"),
        ("columns = 24", "columns = 23", "cloth.columns", "no grid of 23x16 (columns x rows), only 1x32, 4x4"),
        ("rows = 16", "rows = 17", "cloth.rows", "no grid of 24x17"),
        ("\"checks\"", "\"tartan\"", "picture.pattern", "unknown variant `tartan`"),
        ("elevation = 20", "elevation = 91", "picture.elevation", "must be from -90 to 90, is 91"),
        ("low = [-1.0, -1.0, 0.0]", "", "picture.low", "missing; high is given"),
        ("high = [1.0, 1.0, 2.0]", "", "picture.high", "missing; low is given"),
        ("high = [1.0, 1.0, 2.0]", "high = [1.0, -2.0, 2.0]", "picture.high", "must not be below low"),
        ("high = [1.0, 1.0, 2.0]", "high = [-1, -1, 0]", "picture.high", "must differ from low"),
        ("\"#102030\"", "\"102030\"", "picture.colours[0]", "expected a colour \"#rrggbb\""),
        ("\"#102030\"", "\"#10203\"", "picture.colours[0]", "expected a colour"),
        ("\"#102030\"", "\"#+10203\"", "picture.colours[0]", "expected a colour"),
        ("\"#102030\"", "[16, 32, 48]", "picture.colours[0]", "expected a colour"),
        ("\"#102030\", ", "", "picture.colours", "must be two colours, are 1"),
        ("\"#102030\", ", "\"#102030\", \"#102030\", ", "picture.colours", "must be two colours, are 3"),
    ]);
}

/// Serde by itself would accept a table with the name as its key.
#[test]
fn names_that_are_tables() {
    all_refused(&[
        ("kind = \"leapfrog\"", "kind = {lines = {}}", "solver.kind", "invalid type: table, expected a string"),
        ("pose = \"lay\"", "pose = {lay = {}}", "cloth.pose", "invalid type: table, expected a string"),
        ("model = \"aerodynamic\"", "model = {facet = 1}", "environment.wind.model", "invalid type: table"),
        ("\"checks\"", "{checks = {}}", "picture.pattern", "invalid type: table, expected a string"),
        ("kind = \"leapfrog\"", "kind = 3", "solver.kind", "invalid type: integer `3`, expected a string"),
    ]);
}

/// A chain moves to the same bits with any width.
#[test]
fn a_chain_without_a_width_runs() {
    fn digest<S: Scalar + Send>(width: &str) -> u32 {
        let scene = format!(
            "[cloth]\ncolumns = 1\nrows = 32\n{width}\nheight = 1\nmass = 1e-3\npose = \"hang\"\npins = \"top\"\n\
             [stretch]\nstiffness = 100\n[environment]\ngravity = [1, 0, -9.81]\n"
        );
        let scene = Description::parse(&scene).unwrap();
        let mut chain = scene.simulation_on::<Everything, S, 1, 32>().unwrap();
        (0..20).for_each(|_| chain.frame());
        assert!(chain.is_finite() && chain.strains().stretch.unwrap().largest < 0.1, "{width:?} in {}", S::NAME);
        chain.digest()
    }
    for width in ["width = 0.0", "width = -1.0", "width = 1e300"] {
        assert_eq!(digest::<f32>(width), digest::<f32>(""), "{width}");
        assert_eq!(digest::<Q24>(width), digest::<Q24>(""), "{width}");
    }
}

/// The width of a chain is ignored, but must be finite; that of a sheet must be positive.
#[test]
fn a_chain_ignores_its_width() {
    let chain = "[cloth]\ncolumns = 1\nrows = 32\nwidth = W\nheight = 1\nmass = 1\n";
    for width in ["0.0", "-1.0", "3.0"] {
        let scene = Description::parse(&chain.replace('W', width)).unwrap();
        assert_eq!(scene.sheet.width, 0.0, "{width}");
    }
    refused(&chain.replace('W', "nan"), "cloth.width", "must be finite");
    refused(&spoilt("width = 2.3", "width = -1"), "cloth.width", "must be above zero, is -1");
}

/// In memory each value takes some hundred times as many bytes as in the file.
#[test]
fn files_of_too_many_values() {
    let pins = format!("pins = [{}[23, 15]]", "[0, 0], ".repeat(200_000));
    refused(&spoilt("pins = [[0, 0], [23, 15], [0, 0]]", &pins), "line 12", "more than 262144 values");
}

#[test]
fn text_that_is_not_toml() {
    refused("name = \"x\"\n[cloth\ncolumns = 4\n", "line 2", "unclosed table");
    refused("[cloth]\ncolumns = 4\ncolumns = 4\n", "line 3", "duplicate key `columns`");
    refused("[cloth]\ncolumns = 4\n\n[cloth]\nrows = 4\n", "line 4", "duplicate key `cloth`");
    refused("[environment]\nwind.model = \"facet\"\nwind = 4\n", "line 3", "duplicate key `wind`");
    refused("wind = { model = 1, model = 2 }\n", "line 1", "duplicate key `model`");
    refused("[cloth]\nrows =\n", "line 2", "must be quoted");
    refused("# a comment\n\nrows 4\n", "line 3", "expected");
    refused("{\"json\": true}", "line 1", "expected");
}

/// A scene with nearly every part, for a small grid that a test can compile.
const SMALL: &str = r#"
[cloth]
columns = 4
rows = 4
width = 1.25
height = 1.5
density = 0.75
hem = 2.5
origin = [-0.5, 0.25, 0.375]
pins = [[0, 0]]
[stretch]
stiffness = 100.5
damping = 0.125
[shear]
compliance = 0.0625
[bend]
stiffness = 1.75
damping = 0.0625
[tether]
slack = 0.5
[environment]
gravity = [0.5, 0.25, -9.75]
drag = 0.5
wind = { velocity = [5.5, 0.25, -3.5], model = "aerodynamic", density = 1.25, drag_coefficient = 1.5 }
[[sphere]]
centre = [1.5, 2.5, 3.5]
radius = 0.5
margin = 0.125
friction = 0.25
velocity = [0.5, 1.25, 0.5]
[[plane]]
point = [0.5, 0.25, -1.5]
normal = [0.5, 3.5, 4.5]
margin = 0.125
friction = 0.25
[[capsule]]
a = [0.5, 0.25, -2.5]
b = [0.5, 0.25, -3.5]
radius = 0.5
margin = 0.125
friction = 0.25
[solver]
step = 0.0625
tolerance = 0.015625
strain_limit = 0.125
[rest]
speed = 0.0078125
acceleration = 0.0078125
time = 2.5
"#;

/// With any number in a file, the scene is refused in one line or moves.
#[test]
fn no_number_in_a_file_is_a_panic() {
    fn check<S: Scalar + Send>(text: &str) -> bool {
        let Ok(scene) = Description::parse(text) else { return false };
        let Ok(mut simulation) = scene.simulation_on::<Everything, S, 4, 4>() else { return false };
        simulation.frame();
        let _ = simulation.explosion();
        true
    }
    let mut played = 0;
    for (start, _) in SMALL.match_indices('.') {
        let digits = |c: char| c.is_ascii_digit();
        let from = SMALL[..start].trim_end_matches(digits).len();
        let length = 1 + SMALL[start + 1..].find(|c| !digits(c)).unwrap();
        for number in [
            "1e308", "1.7e308", "1e300", "1e154", "1e39", "1e20", "1e9", "128", "127.5", "62.99", "1e-9", "1e-39",
            "1e-308", "5e-324",
        ] {
            let text = format!("{}{number}{}", &SMALL[..from], &SMALL[start + length..]);
            let accepted = [check::<f32>(&text), check::<f64>(&text), check::<Q24>(&text)];
            played += accepted.into_iter().filter(|accepted| *accepted).count();
        }
    }
    assert!(check::<f32>(SMALL) && check::<f64>(SMALL) && check::<Q24>(SMALL));
    assert!(played > 100, "{played} scenes were played");
}

/// A cell of the good scene is 0.1 m wide and as high.
#[test]
fn a_sheet_that_meets_itself_is_about_a_cell_thick() {
    let start = |text: &str| {
        let scene = Description::parse(text).unwrap();
        scene.simulation_on::<Everything, Q24, 24, 16>().map(|simulation| simulation.self_contacts())
    };
    for thickness in ["thickness = 0.075", "thickness = 0.1", ""] {
        assert_eq!(start(&spoilt("thickness = 0.09", thickness)).unwrap(), Some(0));
    }
    assert_eq!(start(&spoilt("[self]\nthickness = 0.09\nfriction = 0.4\n", "")).unwrap(), None);
    for thickness in ["thickness = 0.07", "thickness = 0.11", "thickness = 1e300"] {
        let line = start(&spoilt("thickness = 0.09", thickness)).unwrap_err().to_string();
        let bounds = "self.thickness: must be 0.075 to 0.1, 0.75 to 1 of a cell's longer side, is ";
        assert!(line.starts_with(bounds), "{line}");
    }
    let line = start(&spoilt("friction = 0.4", "friction = 1e9")).unwrap_err().to_string();
    assert!(line.starts_with("self.friction: "), "{line}");
}
