//! Pointer events on the stage.

use embedded_graphics::geometry::Point;
use kerchief::host::Grip;

use super::super::caption::PICTURE;
use super::super::pointer::{Button, Held, Pointer, Pressed, factor};
use super::Stage;

impl Stage<'_> {
    /// Handles a pointer event.
    pub fn point(&mut self, pointer: Pointer) {
        match pointer {
            Pointer::Pressed(button, at) if self.pressed.is_none() && PICTURE.contains(at) => {
                let at = at - PICTURE.top_left;
                let held = if button == Button::Left { self.grab(at) } else { None };
                self.pressed = Some(Pressed { button, at, held });
            }
            Pointer::Moved(at) => self.moved(at - PICTURE.top_left),
            Pointer::Released(button) if self.pressed.is_some_and(|pressed| pressed.button == button) => {
                self.simulation.release();
                self.pressed = None;
            }
            Pointer::Wheel(notches) => {
                self.orbit.zoom(factor(notches));
                self.painter.look(&self.orbit);
            }
            Pointer::Pressed(..) | Pointer::Released(_) => {}
        }
    }

    /// Grabs the particle at a pixel of the picture.
    fn grab(&mut self, at: Point) -> Option<Held> {
        if !self.simulation.is_finite() {
            return None;
        }
        let still = self.simulation.still();
        let node = self.painter.pick(&still, at)?;
        let held = Held { node, place: still.positions[node.row * self.scene.sheet.columns + node.column] };
        self.hold(held).then_some(held)
    }

    /// Grabs and drags a particle. Returns whether the simulation accepts the hand.
    fn hold(&mut self, Held { node, place }: Held) -> bool {
        match self.simulation.grab(node.column, node.row, &Grip::of(&self.scene)) {
            Ok(()) => {
                self.simulation.drag(place);
                self.complaint.clear();
                true
            }
            Err(error) => {
                self.complaint = error.to_string();
                false
            }
        }
    }

    fn moved(&mut self, at: Point) {
        let Some(pressed) = &mut self.pressed else { return };
        let way = at - pressed.at;
        pressed.at = at;
        if let Some(held) = &mut pressed.held {
            held.place = self.painter.under(at, held.place);
            self.simulation.drag(held.place);
        } else {
            self.orbit.drag(f64::from(way.x), f64::from(way.y));
            self.painter.look(&self.orbit);
        }
    }

    /// Grabs the dragged particle again, in a simulation that has replaced another.
    pub(super) fn hold_on(&mut self) {
        let Some(held) = self.pressed.and_then(|pressed| pressed.held) else { return };
        if !self.hold(held) {
            self.pressed = None;
        }
    }
}
