//! Settings by what a stored study has shown of them: the best picture within a time, or the fastest one within an error.

use super::Settings;
use crate::render::Method;
use serde::Deserialize;

/// What is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wish {
    /// Most milliseconds of the passes of both views.
    pub budget_ms: Option<f64>,
    /// Most mean ꟻLIP against many rays per pixel.
    pub max_error: Option<f64>,
}

/// For what settings are wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// Pixels of a view; times are taken to grow with them.
    pub pixels: u64,
    /// The backend's description.
    pub backend: &'a str,
    /// The profile's name.
    pub profile: &'a str,
}

/// Settings, and what the study lets expect of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// The settings.
    pub settings: Settings,
    /// Milliseconds of the passes of both views.
    pub milliseconds: f64,
    /// Mean ꟻLIP against many rays per pixel.
    pub error: f64,
}

/// Why there are none.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum ChoiceError {
    /// No study.
    #[error("line {line}: not a point of a study: {why}")]
    Line {
        /// Which line, from 1 on.
        line: usize,
        /// What is wrong with it.
        why: String,
    },
    /// Not of this scene.
    #[error("the study has nothing of the scene `{scene}` on {backend}, {profile} profile; it has {known}")]
    Unknown {
        /// Which scene.
        scene: String,
        /// Where it would be rendered.
        backend: String,
        /// With which arithmetic.
        profile: String,
        /// What there is.
        known: String,
    },
    /// The wish cannot be fulfilled.
    #[error(
        "no setting of the study is within that; the fastest takes {milliseconds:.2} ms, the best one has an error of {error:.4}"
    )]
    OutOfReach {
        /// Time of the fastest point.
        milliseconds: f64,
        /// Error of the best one.
        error: f64,
    },
}

/// What of a point matters here.
#[derive(Deserialize)]
struct Stored {
    scene: String,
    width: u32,
    height: u32,
    backend: String,
    profile: String,
    settings: String,
    milliseconds: f64,
    to_truth: Error,
}

#[derive(Deserialize)]
struct Error {
    flip: f64,
}

/// Picks settings from `study`, the JSON lines that `parallax study` writes.
///
/// # Errors
/// When the study has none.
pub fn choose(study: &str, target: &Target<'_>, wish: &Wish) -> Result<Choice, ChoiceError> {
    let stored = parse(study)?;
    let of_target = |point: &&Stored| {
        (&point.scene[..], &point.backend[..], &point.profile[..])
            == (target.scene, target.backend, target.profile)
    };
    let points: Vec<Choice> =
        stored.iter().filter(of_target).filter_map(|point| expected(point, target.pixels)).collect();
    if points.is_empty() {
        return Err(unknown(&stored, target));
    }
    let within = |choice: &&Choice| {
        wish.budget_ms.is_none_or(|most| choice.milliseconds <= most)
            && wish.max_error.is_none_or(|most| choice.error <= most)
    };
    let by_time = |a: &&Choice, b: &&Choice| a.milliseconds.total_cmp(&b.milliseconds);
    let by_error = |a: &&Choice, b: &&Choice| a.error.total_cmp(&b.error).then(by_time(a, b));
    let found = points.iter().filter(within);
    let best = if wish.budget_ms.is_some() { found.min_by(by_error) } else { found.min_by(by_time) };
    best.copied().ok_or_else(|| ChoiceError::OutOfReach {
        milliseconds: points.iter().map(|point| point.milliseconds).fold(f64::INFINITY, f64::min),
        error: points.iter().map(|point| point.error).fold(f64::INFINITY, f64::min),
    })
}

fn parse(study: &str) -> Result<Vec<Stored>, ChoiceError> {
    let lines = study.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    lines
        .map(|(number, line)| {
            serde_json::from_str(line)
                .map_err(|error| ChoiceError::Line { line: number + 1, why: error.to_string() })
        })
        .collect()
}

/// What a point lets expect of a picture with so many pixels; nothing of a point whose settings this version does not know, nor of the
/// method `ideal`, which makes no pair.
fn expected(point: &Stored, pixels: u64) -> Option<Choice> {
    let measured = f64::from(point.width) * f64::from(point.height);
    Some(Choice {
        settings: Settings::parse(&point.settings)
            .filter(|settings| settings.stereo.method != Method::Ideal)?,
        milliseconds: point.milliseconds * pixels as f64 / measured.max(1.0),
        error: point.to_truth.flip,
    })
}

fn unknown(stored: &[Stored], target: &Target<'_>) -> ChoiceError {
    let mut known: Vec<String> = stored
        .iter()
        .map(|point| format!("{} on {}, {}", point.scene, point.backend, point.profile))
        .collect();
    known.sort();
    known.dedup();
    ChoiceError::Unknown {
        scene: target.scene.into(),
        backend: target.backend.into(),
        profile: target.profile.into(),
        known: if known.is_empty() { "nothing".into() } else { known.join("; ") },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line_on(backend: &str, settings: &str, milliseconds: f64, flip: f64) -> String {
        let of = r#""scene":"box","width":10,"height":10,"profile":"strict""#;
        let found = format!(r#""milliseconds":{milliseconds},"to_truth":{{"flip":{flip}}}"#);
        format!(r#"{{{of},"backend":"{backend}","settings":"{settings}",{found}}}"#)
    }

    fn line(settings: &str, milliseconds: f64, flip: f64) -> String {
        line_on("CPU", settings, milliseconds, flip)
    }

    fn study() -> String {
        [
            line("method=naive", 10.0, 0.03),
            line("method=atomic verify=edges", 6.0, 0.04),
            line("samples=4x4", 100.0, 0.01),
            line("bvh=quick", 11.0, 0.03),
            line("method=ideal", 1.0, 0.03),
        ]
        .join("\n")
    }

    const TARGET: Target<'static> = Target { scene: "box", pixels: 100, backend: "CPU", profile: "strict" };

    fn chosen(
        target: &Target<'_>,
        budget_ms: Option<f64>,
        max_error: Option<f64>,
    ) -> Result<String, ChoiceError> {
        choose(&study(), target, &Wish { budget_ms, max_error }).map(|choice| choice.settings.label())
    }

    #[test]
    fn the_best_picture_within_a_time_and_the_fastest_within_an_error() {
        assert_eq!(chosen(&TARGET, Some(7.0), None).unwrap(), "method=atomic verify=edges");
        assert_eq!(chosen(&TARGET, Some(50.0), None).unwrap(), "method=naive");
        assert_eq!(chosen(&TARGET, Some(1000.0), None).unwrap(), "samples=4x4");
        assert_eq!(chosen(&TARGET, None, Some(0.035)).unwrap(), "method=naive");
        assert_eq!(chosen(&TARGET, None, Some(1.0)).unwrap(), "method=atomic verify=edges");
    }

    #[test]
    fn what_another_backend_has_shown_does_not_count() {
        let quick = line_on("GPU", "bvh=quick", 0.1, 0.001);
        let both = format!("{}\n{quick}", study());
        let on = |backend: &'static str| {
            let wish = Wish { budget_ms: Some(7.0), max_error: None };
            choose(&both, &Target { backend, ..TARGET }, &wish).map(|choice| choice.settings.label())
        };
        assert_eq!(on("CPU").unwrap(), "method=atomic verify=edges");
        assert_eq!(on("GPU").unwrap(), "bvh=quick");
        assert!(on("TPU").unwrap_err().to_string().contains("box on CPU, strict; box on GPU, strict"));
    }

    #[test]
    fn times_grow_with_the_picture() {
        let larger = Target { pixels: 400, ..TARGET };
        assert_eq!(chosen(&larger, Some(30.0), None).unwrap(), "method=atomic verify=edges");
        assert_eq!(
            chosen(&larger, Some(20.0), None),
            Err(ChoiceError::OutOfReach { milliseconds: 24.0, error: 0.01 })
        );
    }

    #[test]
    fn what_is_not_there_is_told() {
        let told = |target: &Target<'_>| chosen(target, None, Some(1.0)).unwrap_err().to_string();
        let other = told(&Target { scene: "ball", ..TARGET });
        assert!(other.contains("nothing of the scene `ball` on CPU") && other.contains("box on CPU, strict"));
        assert!(told(&Target { profile: "fast", ..TARGET }).contains("fast profile"));
        let wrong = choose("\n{}", &TARGET, &Wish::default()).unwrap_err().to_string();
        assert!(wrong.starts_with("line 2: not a point of a study"), "{wrong}");
        assert!(choose("", &TARGET, &Wish::default()).unwrap_err().to_string().ends_with("it has nothing"));
    }
}
