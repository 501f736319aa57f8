//! The examples for boards, in emulators that others wrote: what a board shows is what a host draws, pixel for pixel, and what it prints is what a host computes.

mod feather;
mod figures;
mod microbit;
mod oled;
mod pico;
mod report;

#[path = "../../examples/pico/breeze.rs"]
mod breeze;
#[path = "../../examples/emulate/feather.rs"]
mod feather_board;
#[path = "../../examples/emulate/firmware.rs"]
mod firmware;
#[path = "../../examples/emulate/gdb.rs"]
mod gdb;
#[path = "../../examples/microbit/leds.rs"]
mod leds;
#[path = "../../examples/emulate/microbit.rs"]
mod microbit_board;
#[path = "../../examples/microbit/show.rs"]
mod microbit_show;
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
#[path = "../../examples/feather/race.rs"]
mod race;
