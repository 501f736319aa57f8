//! Pages show the output of programs, programs are short, and their output agrees with physics.

mod claims;
mod pages;
mod program;
mod thesis;
