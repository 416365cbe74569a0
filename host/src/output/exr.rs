//! EXR by the multi-view convention (OpenEXR documentation, "Storing Multi-View Images in OpenEXR Files").
//!
//! The attribute `multiView` lists the views, `left` first, which makes it the default view: a program that
//! knows nothing of views sees an ordinary picture. Channels are named `layer.view.channel`; those of the
//! default view that are in no layer go without the view's name. So there are `R G B` and `right.R right.G
//! right.B`, all 32 bit floats and linear, and with `aov` also:
//!
//! | channel | type | what |
//! |---|---|---|
//! | `t`, `right.t` | float | way from the eye to the hit in world units; +∞ where nothing is hit |
//! | `disparity`, `right.disparity` | float | disparity in pixels |
//! | `normal.left.X` … `normal.right.Z` | float | shading normal, world space; zero where nothing is hit |
//! | `prim_id`, `right.prim_id` | uint | number of the primitive, 4294967295 where nothing is hit |

use super::{Batch, OutputError};
use crate::render::{StereoImages, ViewImages};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, Text, WritableImage,
};

/// The views, in the order of [`StereoImages::views`].
const EYES: [&str; 2] = ["left", "right"];

/// Writes the file `name`.
pub fn write(batch: &mut Batch, name: &str, images: &StereoImages, aov: bool) -> Result<(), OutputError> {
    let mut channels = Vec::new();
    for (view, eye) in images.views.iter().zip(EYES) {
        colour_channels(view, eye, &mut channels);
        if aov {
            aov_channels(view, eye, &mut channels);
        }
    }
    let attributes = LayerAttributes {
        multi_view_names: Some(EYES.map(Text::from).to_vec()),
        software_name: Some(Text::from("Parallax")),
        ..LayerAttributes::default()
    };
    let size = (images.width as usize, images.height as usize);
    let channels = AnyChannels::sort(channels.into());
    let image = Image::from_layer(Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, channels));
    batch.write(name, |file, path| {
        image.write().to_buffered(file).map_err(|source| OutputError::Exr { path: path.to_owned(), source })
    })
}

fn colour_channels(view: &ViewImages, eye: &str, channels: &mut Vec<AnyChannel<FlatSamples>>) {
    for (axis, name) in ["R", "G", "B"].iter().enumerate() {
        channels.push(AnyChannel::new(&*in_view(eye, name), component(&view.colour, axis)));
    }
}

fn aov_channels(view: &ViewImages, eye: &str, channels: &mut Vec<AnyChannel<FlatSamples>>) {
    for (axis, name) in ["X", "Y", "Z"].iter().enumerate() {
        channels.push(AnyChannel::new(&*format!("normal.{eye}.{name}"), component(&view.normal, axis)));
    }
    let single = [
        ("t", FlatSamples::F32(view.t.clone())),
        ("disparity", FlatSamples::F32(view.disparity.clone())),
        ("prim_id", FlatSamples::U32(view.prim_id.clone())),
    ];
    channels.extend(single.map(|(name, samples)| AnyChannel::new(&*in_view(eye, name), samples)));
}

/// The name of a channel in no layer.
fn in_view(eye: &str, channel: &str) -> String {
    if eye == EYES[0] { channel.to_owned() } else { format!("{eye}.{channel}") }
}

fn component(vectors: &[[f32; 3]], axis: usize) -> FlatSamples {
    FlatSamples::F32(vectors.iter().map(|vector| vector[axis]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::exr::prelude::read_first_flat_layer_from_file;

    fn images() -> StereoImages {
        let view = |eye: u32| ViewImages {
            colour: vec![[eye as f32, 0.25, 7.5], [1e-30, -0.0, 1.0]],
            prim_id: vec![16_777_217 + eye, u32::MAX],
            t: vec![1.5, f32::INFINITY],
            normal: vec![[0.0, 0.6, 0.8], [0.0; 3]],
            disparity: vec![-3.25, 20.0],
        };
        StereoImages { width: 2, height: 1, views: [view(0), view(1)] }
    }

    fn written(aov: bool) -> Layer<AnyChannels<FlatSamples>> {
        let folder = tempfile::tempdir().unwrap();
        let mut batch = Batch::new(folder.path()).unwrap();
        write(&mut batch, "a.exr", &images(), aov).unwrap();
        batch.commit().unwrap();
        read_first_flat_layer_from_file(folder.path().join("a.exr")).unwrap().layer_data
    }

    fn names(layer: &Layer<AnyChannels<FlatSamples>>) -> Vec<String> {
        layer.channel_data.list.iter().map(|channel| channel.name.to_string()).collect()
    }

    #[test]
    fn left_is_the_default_view() {
        let layer = written(false);
        assert_eq!(layer.attributes.multi_view_names, Some(vec![Text::from("left"), Text::from("right")]));
        assert_eq!(names(&layer), ["B", "G", "R", "right.B", "right.G", "right.R"]);
    }

    #[test]
    fn every_bit_survives() {
        let layer = written(true);
        let expected = [
            ["B", "G", "R", "disparity", "normal.left.X", "normal.left.Y", "normal.left.Z"].as_slice(),
            &["normal.right.X", "normal.right.Y", "normal.right.Z", "prim_id", "right.B", "right.G"],
            &["right.R", "right.disparity", "right.prim_id", "right.t", "t"],
        ];
        assert_eq!(names(&layer), expected.concat());
        let samples = |name: &str| {
            let channel = layer.channel_data.list.iter().find(|channel| channel.name.eq(name)).unwrap();
            channel.sample_data.clone()
        };
        let [left, right] = images().views;
        assert_eq!(samples("right.R"), component(&right.colour, 0));
        assert_eq!(samples("normal.left.Y"), component(&left.normal, 1));
        assert_eq!(samples("t"), FlatSamples::F32(left.t));
        assert_eq!(samples("right.disparity"), FlatSamples::F32(right.disparity));
        assert_eq!(samples("right.prim_id"), FlatSamples::U32(right.prim_id));
    }
}
