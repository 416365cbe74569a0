//! From a scene to the images of both eyes: the frame as an ordered list of passes, on whichever backend.
//!
//! A [`Scene`](crate::scene::Scene), perhaps changed by [`Overrides`], becomes [`SceneData`] (scaled, with
//! its acceleration structure, packed), which is uploaded once as [`SceneBuffers`]. [`Renderer`] runs the
//! passes band by band and hands out what every stage has made of a band; [`render`] puts the bands together
//! to [`StereoImages`].
//!
//! ```no_run
//! use parallax::backend::{Selection, select};
//! use parallax::build::Quality;
//! use parallax::render::{Method, SceneData, render};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let scene = parallax::scene::load("scenes/default.toml".as_ref())?;
//!     let data = SceneData::new(&scene, Quality::Full)?;
//!     let mut device = select(&Selection::default())?;
//!     let frame = render(&mut device, &data, &Method::Naive.into(), &mut |_, _| {})?;
//!     println!("{} rays", frame.rays.all());
//!     Ok(())
//! }
//! ```

pub mod band;
mod buffers;
mod error;
mod frame;
pub mod images;
mod method;
mod overrides;
mod rays;
mod renderer;
pub mod sampling;
pub mod scale;
mod scene_data;
mod shadows;
pub mod stereo;
mod times;

pub use buffers::SceneBuffers;
pub use error::RenderError;
pub use frame::{Frame, render};
pub use images::{StereoImages, ViewImages};
pub use method::{Depth, First, Method, Reflections, Shadows, StereoOptions, Verify, value_name};
pub use overrides::{MAX_LIGHTS, MAX_PIXELS, Overrides};
pub use rays::RayTotals;
pub use renderer::Renderer;
pub use sampling::Samples;
pub use scene_data::SceneData;
pub use times::StageTime;
