//! The examples for boards with a display, in emulators that others wrote: what a board shows is what a host draws, pixel for pixel.

mod oled;
mod pico;
mod report;

#[path = "../../examples/pico/breeze.rs"]
mod breeze;
#[path = "../../examples/emulate/firmware.rs"]
mod firmware;
#[path = "../../examples/emulate/gdb.rs"]
mod gdb;
#[path = "../../examples/emulate/oled.rs"]
mod oled_board;
#[path = "../../examples/oled/show.rs"]
mod oled_show;
#[path = "../../examples/emulate/pico.rs"]
mod pico_board;
#[path = "../../examples/pico/show.rs"]
mod pico_show;
#[path = "../../examples/emulate/program.rs"]
mod program;
#[path = "../../examples/emulate/qemu.rs"]
mod qemu;
