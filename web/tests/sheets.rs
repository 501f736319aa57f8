//! The page's operations on sheets, on a host.

use embedded_graphics::geometry::Size;
use kerchief::render::Orbit;
use kerchief::{Node, Q24, Scalar};
use playground::eye;
use playground::frame::Frame;
use playground::likeness::Fate;
use playground::play::{self, Moving};
use playground::settings::{FRAME, SIZE, Settings, Solver, Start};

const SCREEN: Size = Size::new(320, 240);

fn sheet<S: Scalar>(settings: &Settings) -> Box<dyn Moving> {
    let settings = Settings { side: 8, ..*settings };
    play::start::<S, 8, 8>(&settings).unwrap_or_else(|refusal| panic!("{refusal:?} is refused"))
}

fn run(sheet: &mut dyn Moving, frames: u32) -> Fate {
    (0..frames).fold(Fate::Moving, |_, _| sheet.frame())
}

/// The stiffness at which ω·h of a substep is `product`.
fn stiffness(settings: &Settings, product: f64) -> f64 {
    let step = FRAME / f64::from(settings.substeps);
    (product / (sheet::<f64>(settings).shown().frequency() * step)).powi(2)
}

#[test]
fn leapfrog_is_stable_up_to_the_frequency_that_the_page_names() {
    let settings =
        Settings { solver: Solver::Leapfrog, start: Start::Curtain, drag: 0.0, substeps: 16, ..Settings::DEFAULT };
    for (product, expected) in [(1.9, true), (2.1, false)] {
        let settings = Settings { stiffness: stiffness(&settings, product), ..settings };
        assert_eq!(run(&mut *sheet::<f64>(&settings), 300) == Fate::Moving, expected, "ω·h = {product}");
    }
}

#[test]
fn an_exploded_sheet_stays_as_it_was_in_the_substep_before() {
    let settings = Settings { solver: Solver::Leapfrog, substeps: 16, ..Settings::DEFAULT };
    let mut sheet = sheet::<f32>(&Settings { stiffness: stiffness(&settings, 2.7), ..settings });
    let mut digest = sheet.digest();
    while sheet.frame() == Fate::Moving {
        digest = sheet.digest();
    }
    assert_eq!(sheet.digest(), digest, "of the last frame");
    let last = sheet.shown().places().to_vec();
    assert!(last.iter().flatten().all(|x| x.abs() < 20.0 * SIZE));
    assert!(sheet.shown().strain().largest > 0.5, "it shows that it explodes");
    assert_ne!(sheet.frame(), Fate::Moving);
    assert_eq!((sheet.digest(), sheet.shown().places()), (digest, &*last));
}

#[test]
fn a_sheet_that_leaves_the_range_of_fixed_point_is_noticed() {
    let settings = Settings { start: Start::Ball, roll: 60.0, tilt: 30.0, drag: 0.0, ..Settings::DEFAULT };
    assert_eq!(run(&mut *sheet::<Q24>(&settings), 600), Fate::OutOfRange);
    assert_eq!(run(&mut *sheet::<f32>(&settings), 600), Fate::Moving);
}

#[test]
fn a_hand_drags_and_a_pin_holds() {
    let mut sheet = sheet::<Q24>(&Settings::DEFAULT);
    run(&mut *sheet, 60);
    let node = Node::new(4, 7);
    let place = |sheet: &dyn Moving| sheet.shown().places()[7 * 8 + 4];
    let [x, y, z] = place(&*sheet);
    sheet.grab(node);
    sheet.drag([x, y - 0.2, z + 0.1]);
    run(&mut *sheet, 30);
    assert!(place(&*sheet)[1] < y - 0.05, "{:?} {y}", place(&*sheet));
    sheet.release();
    sheet.hold(node, true);
    let held = place(&*sheet);
    run(&mut *sheet, 30);
    assert!(sheet.is_held(node) && place(&*sheet) == held);
    sheet.hold(node, false);
    run(&mut *sheet, 30);
    assert!(!sheet.is_held(node) && place(&*sheet) != held);
}

#[test]
fn a_pin_is_carried_to_its_place_and_stays_there() {
    let mut sheet = sheet::<Q24>(&Settings::DEFAULT);
    run(&mut *sheet, 30);
    let [x, y, z] = sheet.shown().places()[0];
    let target = [x - 0.1, y + 0.05, z + 0.02];
    let apart = |sheet: &dyn Moving| {
        let place = sheet.shown().places()[0];
        (0..3).map(|axis| (place[axis] - target[axis]).abs()).fold(0.0, f64::max)
    };
    sheet.grab(Node::new(0, 0));
    sheet.drag(target);
    run(&mut *sheet, 2);
    assert!(apart(&*sheet) > 0.03, "not all at once");
    sheet.release();
    let halfway = apart(&*sheet);
    run(&mut *sheet, 10);
    assert_eq!(apart(&*sheet), halfway);
    sheet.grab(Node::new(0, 0));
    sheet.drag(target);
    run(&mut *sheet, 20);
    assert!(apart(&*sheet) < 1e-6);
}

#[test]
fn a_particle_is_picked_where_it_is_seen() {
    let mut sheet = sheet::<f32>(&Settings { start: Start::Curtain, ..Settings::DEFAULT });
    run(&mut *sheet, 10);
    for node in [Node::new(0, 0), Node::new(3, 4), Node::new(7, 7)] {
        let pixel = sheet.shown().pixel(&eye::START, SCREEN, node).expect("on the screen");
        assert_eq!(sheet.shown().pick(&eye::START, SCREEN, pixel), Some(node));
        let place = sheet.shown().places()[node.row * 8 + node.column];
        let under = sheet.shown().under(&eye::START, SCREEN, pixel, place);
        let apart = (0..3).map(|axis| (under[axis] - place[axis]).abs()).fold(0.0, f64::max);
        assert!(apart < 0.005, "{place:?} {under:?}");
    }
}

#[test]
fn both_sheets_have_their_colours_and_every_eye_its_picture() {
    let sheet = sheet::<f32>(&Settings { ball: true, ..Settings::DEFAULT });
    let hash = |eye: &Orbit, right: bool| {
        let mut frame = Frame::default();
        frame.resize(SCREEN.width, SCREEN.height);
        sheet.shown().draw(eye, right, &mut frame);
        frame.hash()
    };
    let mut turned = eye::START;
    turned.turn(88.0, 0.0);
    let pictures = [hash(&eye::START, false), hash(&eye::START, true), hash(&turned, false)];
    assert!(pictures[0] != pictures[1] && pictures[0] != pictures[2], "{pictures:?}");
    assert_eq!(hash(&eye::START, false), pictures[0]);
}

#[test]
fn what_changes_while_a_sheet_moves_changes_it() {
    let changes: [fn(&mut Settings); 5] = [
        |settings| settings.wind = 5.0,
        |settings| settings.drag = 2.0,
        |settings| settings.damping = 2e-3,
        |settings| settings.tilt = 20.0,
        |settings| settings.ball = true,
    ];
    let digest = |change: fn(&mut Settings)| {
        let mut settings = Settings::DEFAULT;
        let mut sheet = sheet::<f32>(&settings);
        run(&mut *sheet, 5);
        change(&mut settings);
        assert!(sheet.change(&settings).is_ok());
        run(&mut *sheet, 60);
        sheet.digest()
    };
    let usual = digest(|_| {});
    for (index, change) in changes.into_iter().enumerate() {
        assert_ne!(digest(change), usual, "change {index}");
    }
}
