//! Extensions from outside the crate: a force, a family of links, a collider, a solver, a measure. Each acts in a
//! scene beside the crate's own, and a law checks its effect. And a pointer drags the particle to which it points.

mod collider;
mod force;
mod link;
mod measure;
mod pointer;
mod solver;
