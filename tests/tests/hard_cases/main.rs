//! Hard cases that stay numerically stable. Each test names the guard in the code that it holds, runs on both backends with the same
//! bits, and compares with f64 or brute force. `tests/guards.toml` lists the guards; `tests/guards.sh` takes each out and sees its tests fail.
//!
//! Cases that other files hold: shared edges and vertices, offsets and scales of closed meshes (`hits`), random rays and boxes (`rays`),
//! t clamped to the own box and small spheres far away (`oracle`), division, square root and elementary functions (`math`), shadow acne
//! by hand-made lights and the closed furnace of spheres (`shading`), ties at half pixels (`stereo_reprojection`), e = 0 and huge e
//! (`stereo_methods`), what one eye sees (`stereo_unseen`, `stereo_counts`), frame edges (`stereo_tables`).

mod backends;
mod boxes;
mod guards;
mod long_runs;
mod quadrics;
mod refraction;
mod secondary_rays;
mod stereo;
mod triangles;
