//! The functions that the page calls.
//!
//! Sheet 0 is the left one, sheet 1 the right one. Particles are numbered row by row. A function with a result larger than one number returns its address in the
//! module's memory.

#![allow(unsafe_code, reason = "a function that the page finds by its name; the name is this module's alone")]

use std::cell::RefCell;

use embedded_graphics::geometry::{Point, Size};

use crate::world::World;

thread_local! {
    static WORLD: RefCell<World> = const { RefCell::new(World::new()) };
}

fn world<T>(act: impl FnOnce(&mut World) -> T) -> T {
    WORLD.with_borrow_mut(act)
}

macro_rules! exports {
    ($($(#[$doc:meta])* fn $name:ident($world:ident $(, $argument:ident: $kind:ty)*) $(-> $result:ty)? $body:block)*) => {$(
        $(#[$doc])*
        #[unsafe(no_mangle)]
        extern "C" fn $name($($argument: $kind),*) $(-> $result)? {
            world(|$world| $body)
        }
    )*};
}

exports! {
    /// Sets a parameter for the next `start` or `change`: see `Settings::set`.
    fn set(world, parameter: u32, value: f64) { world.settings.set(parameter, value) }

    /// Starts a sheet. Returns 0, or the `Refusal` that names the constant that the number type does not represent.
    fn start(world, sheet: usize) -> u32 { world.start(sheet) }

    /// Changes a sheet while it moves. Returns 0, or a `Refusal` as `start` does.
    fn change(world, sheet: usize) -> u32 { world.change(sheet) }

    /// Moves a sheet by a frame and returns its `Fate`.
    fn frame(world, sheet: usize) -> u32 { world.sheet(sheet).frame() as u32 }

    /// The `Fate` of a sheet.
    fn fate(world, sheet: usize) -> u32 { world.fate(sheet) as u32 }

    /// Pins a particle at its position, or releases it.
    fn hold(world, sheet: usize, index: usize, held: u32) {
        let node = world.node(sheet, index);
        world.sheet(sheet).hold(node, held != 0);
    }

    /// Whether a particle is pinned.
    fn is_held(world, sheet: usize, index: usize) -> u32 {
        let node = world.node(sheet, index);
        u32::from(world.sheet(sheet).is_held(node))
    }

    /// Grabs a particle.
    fn grab(world, sheet: usize, index: usize) {
        let node = world.node(sheet, index);
        world.sheet(sheet).grab(node);
    }

    /// Drags the grabbed particle to a point, m.
    fn drag(world, sheet: usize, x: f64, y: f64, z: f64) { world.sheet(sheet).drag([x, y, z]) }

    /// Releases the grabbed particle.
    fn release(world, sheet: usize) { world.sheet(sheet).release() }

    /// The digest of a sheet.
    fn digest(world, sheet: usize) -> u32 { world.sheet(sheet).digest() }

    /// The largest strain of a link.
    fn strain(world, sheet: usize) -> f64 { world.sheet(sheet).shown().strain().largest }

    /// The sheet's energy, J.
    fn energy(world, sheet: usize) -> f64 { world.sheet(sheet).shown().energy() }

    /// The sheet's highest angular frequency, 1/s.
    fn frequency(world, sheet: usize) -> f64 { world.sheet(sheet).shown().frequency() }

    /// The address of all positions: three 64-bit floats a particle, m.
    fn places(world, sheet: usize) -> usize { world.sheet(sheet).shown().places().as_ptr().addr() }

    /// Turns the scene by the displacement of a pointer, pixels.
    fn turn(world, right: f64, down: f64) { world.eye.drag(right, down) }

    /// Divides the distance of the eye by `factor`.
    fn zoom(world, factor: f64) { world.eye.zoom(factor) }

    /// The address of the eye's position: azimuth, elevation (degrees), distance (m).
    fn eye(world) -> usize {
        world.place = [world.eye.azimuth, world.eye.elevation, world.eye.distance];
        world.place.as_ptr().addr()
    }

    /// Draws a sheet and returns the address of the pixels, four bytes each.
    fn draw(world, sheet: usize, width: u32, height: u32) -> usize {
        world.draw(sheet, width, height);
        world.frame.bytes().as_ptr().addr()
    }

    /// The hash of the last picture.
    fn hash(world) -> u32 { world.frame.hash() }

    /// The particle under a pixel, or −1.
    fn pick(world, sheet: usize, width: u32, height: u32, x: i32, y: i32) -> i32 {
        world.pick(sheet, Size::new(width, height), Point::new(x, y))
    }

    /// The address of the point (three 64-bit floats, m) under a pixel, at the depth of the point (`px`, `py`, `pz`).
    fn under(world, sheet: usize, width: u32, height: u32, x: i32, y: i32, px: f64, py: f64, pz: f64) -> usize {
        world.place = [px, py, pz];
        world.drag_under(sheet, Size::new(width, height), Point::new(x, y));
        world.place.as_ptr().addr()
    }

    /// The pixel at which a particle is seen: its column in the upper half, its row in the lower; −1 if there is none.
    fn pixel(world, sheet: usize, width: u32, height: u32, index: usize) -> i32 {
        world.pixel(sheet, Size::new(width, height), index)
    }
}
