//! A sheet meets itself: what it must never do, and what it does in scenes that fold, close, twist and drop it.

mod laws;
mod scenes;
mod stage;
