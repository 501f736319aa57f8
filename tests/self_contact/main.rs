//! Self-contact: its laws, and the intersections that remain in scenes that fold, close, twist and drop a sheet.

mod laws;
mod scenes;
mod stage;
