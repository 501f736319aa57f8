//! Pages say what programs print, programs are short, and what they print is physics.

mod claims;
mod pages;
mod program;
mod thesis;
