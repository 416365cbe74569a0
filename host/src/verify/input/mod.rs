//! What cases are made of: meshes, rays at their edges, scenes by hand, hostile numbers, and a reference in f64.

pub mod meshes;
pub mod numbers;
pub mod pairs;
pub mod reference;
pub mod small_scenes;
pub mod stage;
