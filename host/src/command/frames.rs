//! The frames of an animation: numbered files, which an interrupted run goes on with.

use super::failure::{Blame, Failure};
use anyhow::{Context, anyhow};
use parallax::output::Batch;
use serde_json::{Map, Value};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A range of frames, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    pub first: u32,
    pub last: u32,
}

impl FromStr for Frames {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let ends = text.split_once("..").and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
        match ends {
            Some((first, last)) if first <= last => Ok(Self { first, last }),
            _ => Err("expected the first and the last frame, for example 0..99".into()),
        }
    }
}

/// What the files of a frame are called.
pub fn name(scene: &str, frame: u32) -> String {
    format!("{scene}_{frame:06}")
}

/// The file that is complete when a frame is: it gets its name last.
pub fn picture(folder: &Path, scene: &str, frame: u32) -> PathBuf {
    folder.join(name(scene, frame)).with_extension("exr")
}

/// Makes sure that `folder` has no frames of this scene that were rendered otherwise, and notes how these are: in
/// `NAME_frames.json`.
///
/// # Errors
/// When it has: which setting differs.
pub fn claim(folder: &Path, scene: &str, settings: &Map<String, Value>) -> Result<(), Failure> {
    let file = format!("{scene}_frames.json");
    let path = folder.join(&file);
    let text = match std::fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return note(folder, &file, settings),
        Err(error) => return Err(error).with_context(|| format!("cannot read {}", path.display())).work(),
    };
    let there: Map<String, Value> =
        serde_json::from_str(&text).with_context(|| format!("{} is damaged", path.display())).usage()?;
    match settings.iter().find(|(key, value)| there.get(*key) != Some(value)) {
        None => Ok(()),
        Some((key, value)) => {
            let before = there.get(key).unwrap_or(&Value::Null);
            Err(anyhow!(
                "{} has frames with another `{key}` ({before} instead of {value}): choose another --out or remove them",
                folder.display()
            ))
            .usage()
        }
    }
}

fn note(folder: &Path, file: &str, settings: &Map<String, Value>) -> Result<(), Failure> {
    let mut batch = Batch::new(folder).work()?;
    batch.write_text(file, &serde_json::to_string_pretty(settings).work()?).work()?;
    batch.commit().work()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_have_both_ends() {
        assert_eq!("3..7".parse(), Ok(Frames { first: 3, last: 7 }));
        assert_eq!("0..0".parse(), Ok(Frames { first: 0, last: 0 }));
        for wrong in ["", "3", "7..3", "..3", "3..", "-1..3", "a..b", "1..2..3"] {
            assert!(wrong.parse::<Frames>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_folder_belongs_to_one_way_of_rendering() {
        let folder = tempfile::tempdir().unwrap();
        let settings = |value: u32| Map::from_iter([("width".to_string(), Value::from(value))]);
        assert!(claim(folder.path(), "a", &settings(8)).is_ok());
        assert!(claim(folder.path(), "a", &settings(8)).is_ok(), "going on");
        assert!(claim(folder.path(), "b", &settings(9)).is_ok(), "another scene");
        match claim(folder.path(), "a", &settings(9)) {
            Err(Failure::Usage(error)) => {
                assert!(error.to_string().contains("another `width` (8 instead of 9)"), "{error}");
            }
            _ => panic!("another width was accepted"),
        }
        std::fs::write(folder.path().join("c_frames.json"), [0xff, 0xfe]).unwrap();
        assert!(
            matches!(claim(folder.path(), "c", &settings(8)), Err(Failure::Work(_))),
            "not text, and not absent"
        );
    }
}
