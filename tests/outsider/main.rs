//! What is not in the crate can be added from outside: a force, a family of links, a collider, a solver, a measure. Each acts in a
//! scene beside the crate's own, and a law says that it acts as it should. And a pointer drags what it shows.

mod collider;
mod force;
mod link;
mod measure;
mod pointer;
mod solver;
