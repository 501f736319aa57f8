//! Tests of the stage without a screen: events are its input, a picture and a caption its output.

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::PointsIter;
use embedded_graphics_simulator::SimulatorDisplay;
use instances::simulation;
use kerchief::Node;

use super::super::caption::{Caption, KEYS, SIZE, WIDEST};
use super::super::pointer::{Button, Pointer};
use super::drawing::HAND;
use super::*;

/// A sheet that hangs from two corners.
const SCENE: &str = r#"
[cloth]
columns = 8
rows = 8
width = 0.7
height = 0.7
density = 0.2
pose = "hang"
origin = [-0.35, 0.0, 1.0]
pins = [[0, 0], [7, 0]]
[stretch]
stiffness = 200.0
[shear]
stiffness = 20.0
[environment]
gravity = [0.0, 0.0, -9.81]
drag = 1.0
[solver]
kind = "xpbd"
step = 0.02
substeps = 8
"#;

const NODE: Node = Node::new(4, 6);

fn scene() -> Description {
    Description::parse(SCENE).unwrap()
}

fn stage(scene: &Description) -> Stage<'_> {
    let mut stage = Stage::new(scene, ScalarKind::F32, simulation).unwrap();
    play(&mut stage, 20);
    stage
}

fn play(stage: &mut Stage<'_>, frames: u32) {
    (0..frames).for_each(|_| stage.advance());
}

fn place(stage: &Stage<'_>, node: Node) -> [f64; 3] {
    stage.simulation.still().positions[node.row * stage.scene.sheet.columns + node.column]
}

/// The pixel of the window at which a particle is seen.
fn pixel(stage: &Stage<'_>, node: Node) -> Point {
    stage.painter.pixel(place(stage, node)).unwrap() + PICTURE.top_left
}

fn held(stage: &Stage<'_>) -> Option<Node> {
    stage.pressed.and_then(|pressed| pressed.held).map(|held| held.node)
}

fn click(stage: &mut Stage<'_>, button: Button, at: Point) -> Option<Node> {
    stage.point(Pointer::Pressed(button, at));
    let node = held(stage);
    stage.point(Pointer::Released(button));
    node
}

fn picture(stage: &Stage<'_>) -> SimulatorDisplay<Rgb888> {
    let mut display = SimulatorDisplay::with_default_color(SIZE, Rgb888::BLACK);
    let Ok(()) = stage.draw(Some(59.7), &mut display);
    display
}

#[test]
fn a_particle_follows_the_pointer_and_falls_when_it_is_released() {
    let scene = scene();
    for scalar in [ScalarKind::F32, ScalarKind::Q24] {
        let mut stage = Stage::new(&scene, scalar, simulation).unwrap();
        play(&mut stage, 20);
        let from = place(&stage, NODE);
        let at = pixel(&stage, NODE);
        stage.point(Pointer::Pressed(Button::Left, at));
        assert_eq!(held(&stage), Some(NODE));
        let to = at + Point::new(60, -80);
        for part in 1..=10 {
            stage.point(Pointer::Moved(at + (to - at) * part / 10));
            play(&mut stage, 2);
        }
        play(&mut stage, 50);
        let way = pixel(&stage, NODE) - to;
        assert!(way.x.abs() < 25 && way.y.abs() < 25, "{scalar:?}: {way:?} pixels beside the pointer");
        let most = stage.strain.most;
        assert!(most < 0.15, "{scalar:?}: strained by {most}");
        let dragged = place(&stage, NODE);
        assert!(dragged[2] > from[2] + 0.05, "{from:?} {dragged:?}");
        stage.point(Pointer::Released(Button::Left));
        assert_eq!(held(&stage), None);
        play(&mut stage, 15);
        assert!(place(&stage, NODE)[2] < dragged[2] - 0.03, "{scalar:?}: it falls");
    }
}

/// A dragged particle moves in the plane of the picture, so a pointer that comes back brings it back.
#[test]
fn a_drag_stays_in_the_plane_of_the_picture() {
    let scene = scene();
    let mut stage = stage(&scene);
    let at = pixel(&stage, NODE);
    stage.point(Pointer::Pressed(Button::Left, at));
    stage.point(Pointer::Moved(at));
    let first = stage.pressed.unwrap().held.unwrap().place;
    stage.point(Pointer::Moved(at + Point::new(200, -150)));
    let there = stage.pressed.unwrap().held.unwrap().place;
    stage.point(Pointer::Moved(at));
    let back = stage.pressed.unwrap().held.unwrap().place;
    let apart = |a: [f64; 3], b: [f64; 3]| (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt();
    assert!(apart(first, there) > 0.1 && apart(first, back) < 1e-4, "{first:?} {there:?} {back:?}");
}

#[test]
fn beside_the_sheet_and_by_the_right_button_the_picture_turns() {
    let scene = scene();
    let mut stage = stage(&scene);
    let beside = PICTURE.top_left + Point::new(4, 4);
    for (button, at) in [(Button::Left, beside), (Button::Right, pixel(&stage, NODE))] {
        let before = stage.orbit;
        let (seen, corner) = (picture(&stage), pixel(&stage, Node::new(7, 0)));
        stage.point(Pointer::Pressed(button, at));
        assert_eq!(held(&stage), None, "{button:?}");
        stage.point(Pointer::Moved(at + Point::new(30, 20)));
        stage.point(Pointer::Released(button));
        let turned = [before.azimuth - stage.orbit.azimuth, stage.orbit.elevation - before.elevation];
        assert!((turned[0] - 12.0).abs() < 1e-9 && (turned[1] - 8.0).abs() < 1e-9, "{turned:?}");
        assert!(picture(&stage) != seen && pixel(&stage, Node::new(7, 0)) != corner, "another picture");
        let after = stage.orbit;
        stage.point(Pointer::Moved(at));
        assert_eq!(stage.orbit, after, "no button is pressed");
    }
}

#[test]
fn the_picture_never_flips_and_the_wheel_ends() {
    let scene = scene();
    let mut stage = stage(&scene);
    let first = stage.orbit.distance;
    let across = |stage: &Stage<'_>| f64::from((pixel(stage, Node::new(7, 0)) - pixel(stage, Node::new(0, 0))).x);
    let at = PICTURE.top_left + Point::new(4, 4);
    for (down, elevation) in [(100_000, 88.0), (-100_000, 2.0)] {
        stage.point(Pointer::Pressed(Button::Right, at));
        stage.point(Pointer::Moved(at + Point::new(0, down)));
        stage.point(Pointer::Released(Button::Right));
        assert_eq!(stage.orbit.elevation, elevation);
    }
    let before = across(&stage);
    stage.point(Pointer::Wheel(1.0));
    assert!((stage.orbit.distance / first - (-0.1_f64).exp()).abs() < 1e-12);
    assert!((across(&stage) / before - 0.1_f64.exp()).abs() < 0.03, "{before} {}", across(&stage));
    for (notches, bound) in [(100.0, 0.4), (-100.0, 3.2)] {
        stage.point(Pointer::Wheel(notches));
        assert!((stage.orbit.distance / first - bound).abs() < 1e-12, "{notches}");
    }
}

#[test]
fn particles_are_found_where_they_are_seen_from_everywhere() {
    let scene = scene();
    let mut stage = stage(&scene);
    for (right, down, notches) in [(0, 0, 0.0), (90, 60, 2.0), (-250, 20, -4.0), (10, -500, 0.0)] {
        let at = PICTURE.top_left + Point::new(4, 4);
        stage.point(Pointer::Pressed(Button::Right, at));
        stage.point(Pointer::Moved(at + Point::new(right, down)));
        stage.point(Pointer::Released(Button::Right));
        stage.point(Pointer::Wheel(notches));
        for node in [NODE, Node::new(1, 3), Node::new(0, 0)] {
            let at = pixel(&stage, node);
            assert_eq!(click(&mut stage, Button::Left, at), Some(node), "{:?}", stage.orbit);
        }
    }
}

#[test]
fn a_chain_is_grabbed_too() {
    let chain = SCENE.replace("columns = 8", "columns = 1").replace("rows = 8", "rows = 32");
    let chain = chain
        .replace("density = 0.2", "mass = 0.003")
        .replace("width = 0.7\n", "")
        .replace(", [7, 0]", "")
        .replace("[shear]\nstiffness = 20.0\n", "");
    let scene = Description::parse(&chain).unwrap_or_else(|error| panic!("{error}"));
    let mut stage = stage(&scene);
    let node = Node::new(0, 20);
    let at = pixel(&stage, node) + Point::new(5, 0);
    assert_eq!(click(&mut stage, Button::Left, at), Some(node));
}

#[test]
fn one_button_at_a_time_and_only_in_the_picture() {
    let scene = scene();
    let mut stage = stage(&scene);
    assert_eq!(click(&mut stage, Button::Left, Point::new(300, 10)), None);
    stage.point(Pointer::Pressed(Button::Right, Point::new(300, SIZE.height as i32 - 5)));
    assert_eq!(stage.pressed, None);
    let at = pixel(&stage, NODE);
    stage.point(Pointer::Pressed(Button::Left, at));
    stage.point(Pointer::Pressed(Button::Right, at));
    let before = stage.orbit;
    stage.point(Pointer::Moved(at + Point::new(50, 50)));
    stage.point(Pointer::Released(Button::Right));
    assert_eq!((held(&stage), stage.orbit), (Some(NODE), before));
    // The button is released outside the picture.
    stage.point(Pointer::Moved(Point::new(-5000, 9000)));
    stage.point(Pointer::Released(Button::Left));
    assert_eq!(held(&stage), None);
    play(&mut stage, 50);
    assert!(stage.simulation.is_finite());
}

#[test]
fn another_solver_and_number_type_keep_what_is_in_the_hand() {
    let scene = scene();
    let mut stage = stage(&scene);
    let at = pixel(&stage, NODE);
    stage.point(Pointer::Pressed(Button::Left, at));
    stage.point(Pointer::Moved(at + Point::new(0, -120)));
    stage.key(Key::Solver, false);
    stage.scalar = ScalarKind::F64;
    stage.key(Key::Number, false);
    assert_eq!((stage.scalar, stage.complaint.as_str()), (ScalarKind::Q24, ""));
    let before = place(&stage, NODE);
    play(&mut stage, 40);
    assert!(place(&stage, NODE)[2] > before[2] + 0.03, "still pulled upwards");
}

#[test]
fn a_reset_keeps_the_view_and_empties_the_hand() {
    let scene = scene();
    let mut stage = stage(&scene);
    let start = Stage::new(&scene, ScalarKind::F32, simulation).unwrap().simulation.digest();
    stage.point(Pointer::Wheel(2.0));
    let view = stage.orbit;
    let at = pixel(&stage, NODE);
    stage.point(Pointer::Pressed(Button::Left, at));
    stage.point(Pointer::Moved(at + Point::new(150, -120)));
    play(&mut stage, 20);
    assert!(stage.strain.most > 0.01);
    stage.key(Key::Reset, false);
    assert_eq!((stage.simulation.digest(), stage.orbit, held(&stage)), (start, view, None));
    assert_eq!(stage.strain.most, stage.strain.now, "counted from the start");
}

/// The substeps are so short that fixed point does not represent the compliance of the hand.
#[test]
fn a_hand_that_is_refused_says_why() {
    let short = SCENE.replace("substeps = 8", "substeps = 8192").replace("drag = 1.0\n", "");
    let scene = Description::parse(&short.replace("[shear]\nstiffness = 20.0\n", "")).unwrap();
    let mut stage = Stage::new(&scene, ScalarKind::Q24, simulation).unwrap();
    let at = pixel(&stage, NODE);
    assert_eq!(click(&mut stage, Button::Left, at), None);
    let complaint = stage.caption(None).complaint;
    assert!(complaint.starts_with("hand.compliance: too small for q24"), "{complaint}");
    stage.scalar = ScalarKind::Q13;
    stage.key(Key::Number, false);
    assert_eq!((stage.scalar, click(&mut stage, Button::Left, at)), (ScalarKind::F32, Some(NODE)));
    assert_eq!(stage.caption(None).complaint, "");
}

/// An exploded sheet can only be restarted.
#[test]
fn nothing_is_grabbed_that_has_exploded() {
    let scene = scene();
    let mut stage = stage(&scene);
    let at = pixel(&stage, NODE);
    let mut state = stage.simulation.state();
    state.velocities[9] = [f64::NAN; 3];
    stage.simulation.restore(&state);
    stage.advance();
    assert_eq!(click(&mut stage, Button::Left, at), None);
    let Caption { state, complaint } = stage.caption(None);
    assert_eq!(complaint, "not finite any more: r starts again");
    assert_eq!(state[1], "- pictures a second   stretch strain undefined, undefined at most since the start");
    let _ = picture(&stage);
    stage.key(Key::Reset, false);
    assert_eq!(stage.caption(None).complaint, "");
    let at = pixel(&stage, NODE);
    assert_eq!(click(&mut stage, Button::Left, at), Some(NODE));
}

#[test]
fn the_caption_says_solver_rate_and_strain() {
    let scene = scene();
    let mut stage = Stage::new(&scene, ScalarKind::F32, simulation).unwrap();
    let strain = |stage: &Stage<'_>| stage.simulation.strains().stretch.unwrap().largest;
    let most = (0..20).fold(strain(&stage), |most, _| {
        stage.advance();
        strain(&stage).max(most)
    });
    let now = strain(&stage);
    let Caption { state, complaint } = stage.caption(Some(59.7));
    assert_eq!(state[0], "xpbd in f32, 8 substeps   wind off   tilt +0 +0");
    let [now, most] = [now, most].map(|strain| format!("{:.2} %", 100.0 * strain));
    assert_ne!(now, most, "the sheet has swung");
    assert_eq!(state[1], format!("60 pictures a second   stretch strain {now}, {most} at most since the start"));
    assert_eq!(complaint, "");
    stage.key(Key::Pause, false);
    stage.key(Key::Wind, false);
    stage.key(Key::Up, true);
    assert_eq!(stage.caption(None).state[0], "xpbd in f32, 8 substeps   wind on   tilt +0 +5   paused");
    let before = stage.simulation.digest();
    play(&mut stage, 5);
    assert_eq!(stage.simulation.digest(), before);
    stage.scene.solver.substeps = kerchief::host::MOST;
    stage.scene.solver.kind = SolverKind::BackwardEuler;
    (stage.weather.tilt, stage.strain) = ([-90.0; 2], Watched { now: 1e300, most: 1e300 });
    let state = stage.caption(Some(1e6)).state;
    assert!(state.iter().all(|line| line.len() <= WIDEST), "{state:?}");
}

/// The caption does not cover the picture, and the picture does not cover the caption.
#[test]
fn picture_and_caption_have_their_places() {
    let scene = scene();
    let mut stage = stage(&scene);
    stage.point(Pointer::Wheel(100.0));
    stage.complaint = "x ".repeat(300);
    let whole = picture(&stage);
    let mut alone = SimulatorDisplay::with_default_color(PICTURE.size, Rgb888::BLACK);
    let Ok(()) = stage.painter.draw(&stage.simulation.still(), &mut alone);
    assert_eq!(whole.size(), Size::new(640, 712));
    for at in PICTURE.points() {
        assert_eq!(whole.get_pixel(at), alone.get_pixel(at - PICTURE.top_left), "{at:?}");
    }
    let inked = |rows: std::ops::Range<i32>| {
        let rows = rows.flat_map(|y| (0..SIZE.width as i32).map(move |x| Point::new(x, y)));
        rows.filter(|at| whole.get_pixel(*at).r() < 200).count()
    };
    let below = PICTURE.top_left.y + PICTURE.size.height as i32;
    for line in [4..20, 20..36, 36..52, 52..68, below + 4..below + 20, below + 20..below + 36] {
        assert!(inked(line.clone()) > 100, "a line of text in {line:?}");
    }
    assert_eq!(KEYS.len(), 2);
}

/// A press on a particle marks it.
#[test]
fn the_particle_in_the_hand_is_marked() {
    let scene = scene();
    let mut stage = stage(&scene);
    let at = pixel(&stage, NODE);
    assert_ne!(picture(&stage).get_pixel(at), HAND);
    stage.point(Pointer::Pressed(Button::Left, at));
    assert_eq!(picture(&stage).get_pixel(at), HAND);
}
