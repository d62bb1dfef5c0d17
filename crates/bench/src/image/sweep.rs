//! Which settings of an engine are worth measuring: each is tried once.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use tracer::LinearImage;

use super::curve::Point;
use super::engine::{Engine, Setting, Stage};
use super::picture::rmse;
use crate::files;

/// Counts up when settings are tried otherwise.
const METHOD: u32 = 1;
/// By how much the next step of a ladder may take longer, if there is no step
/// before to tell: most take four times the samples.
const STEEP: f64 = 4.0;
/// A step that lowers the error by less than this part is on a plateau, if it
/// takes longer by this factor: what it adds is not where the error is.
const PLATEAU: f64 = 0.02;
const DEARER: f64 = 1.2;
/// A ladder is left where another one's step is as exact and faster by this factor.
const HOPELESS: f64 = 3.0;

/// One setting's trial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trial {
    pub(crate) setting: Setting,
    pub(crate) point: Point,
}

/// A trial on file, by the setting's name.
#[derive(Debug, Serialize, Deserialize)]
struct Kept {
    setting: String,
    seconds: f64,
    rmse: f64,
}

/// How far trials go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limits {
    /// No trial is begun that is expected to take more seconds.
    pub(crate) longest: f64,
    /// Where the error is this small, no better one is sought.
    pub(crate) rmse: f64,
}

/// Tries the settings of an engine.
///
/// # Errors
/// The first error of a render.
pub(crate) fn sweep(
    engine: &mut dyn Engine,
    stage: &Stage,
    truth: &LinearImage,
    limits: Limits,
) -> Result<Vec<Trial>, String> {
    let mut trials: Vec<Trial> = Vec::new();
    for ladder in engine.ladders() {
        climb(&ladder, limits, &mut trials, |setting| {
            let shot = engine.shoot(stage, setting)?;
            Ok(Point { seconds: shot.seconds, rmse: rmse(&shot.picture, truth) })
        })?;
    }
    Ok(trials)
}

/// Tries the settings of one ladder, up to where it is of no more use.
fn climb(
    ladder: &[Setting],
    limits: Limits,
    trials: &mut Vec<Trial>,
    mut shoot: impl FnMut(Setting) -> Result<Point, String>,
) -> Result<(), String> {
    let others: Vec<_> = trials.iter().map(|trial| trial.point).collect();
    let mut before: Option<Point> = None;
    for &setting in ladder {
        let point = shoot(setting)?;
        trials.push(Trial { setting, point });
        let steeper = before.map_or(STEEP, |before| point.seconds / before.seconds);
        let is_flat = steeper > DEARER
            && before.is_some_and(|before| point.rmse > before.rmse * (1.0 - PLATEAU));
        let too_long = point.seconds * steeper.max(1.0) > limits.longest;
        let is_hopeless = others
            .iter()
            .any(|other| other.rmse <= point.rmse && other.seconds * HOPELESS < point.seconds);
        if point.rmse <= limits.rmse || is_flat || too_long || is_hopeless {
            break;
        }
        before = Some(point);
    }
    Ok(())
}

/// [`sweep`] of a peer, whose trials are kept on file: they stay the same while
/// goldray gets better, and only say what is to be measured.
///
/// # Errors
/// As [`sweep`], and where the file cannot be written.
pub(crate) fn sweep_once(
    engine: &mut dyn Engine,
    stage: &Stage,
    truth: &LinearImage,
    limits: Limits,
    anew: bool,
) -> Result<Vec<Trial>, String> {
    let path = path(engine, stage, limits);
    let kept = files::read_kept(&path).filter(|_| !anew);
    if let Some(trials) = kept.and_then(|bytes| from_bytes(&bytes, engine)) {
        return Ok(trials);
    }
    let trials = sweep(engine, stage, truth, limits)?;
    files::write(&path, &to_bytes(&trials)?)?;
    Ok(trials)
}

fn path(engine: &dyn Engine, stage: &Stage, limits: Limits) -> PathBuf {
    let name = format!("{}-{}", engine.name(), engine.version());
    let Limits { longest, rmse } = limits;
    stage.folder.join(format!("trials-{METHOD}-{name}-{longest}s-{rmse:e}.json"))
}

fn to_bytes(trials: &[Trial]) -> Result<Vec<u8>, String> {
    let kept: Vec<_> = trials
        .iter()
        .map(|Trial { setting, point }| Kept {
            setting: setting.to_string(),
            seconds: point.seconds,
            rmse: point.rmse,
        })
        .collect();
    serde_json::to_vec_pretty(&kept).map_err(|why| why.to_string())
}

/// `None` for what is no list of this engine's trials.
fn from_bytes(bytes: &[u8], engine: &dyn Engine) -> Option<Vec<Trial>> {
    let settings: Vec<_> = engine.ladders().concat();
    let kept: Vec<Kept> = serde_json::from_slice(bytes).ok()?;
    let trial = |Kept { setting, seconds, rmse }| {
        let setting = *settings.iter().find(|known| known.to_string() == setting)?;
        Some(Trial { setting, point: Point { seconds, rmse } })
    };
    kept.into_iter().map(trial).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::engine;

    const LIMITS: Limits = Limits { longest: 100.0, rmse: 1e-3 };

    /// How many steps are taken if they cost and give this.
    fn steps(points: &[(f64, f64)]) -> usize {
        steps_beside(&[], points)
    }

    /// The same after others gave that.
    fn steps_beside(others: &[(f64, f64)], points: &[(f64, f64)]) -> usize {
        let ladder: Vec<_> = (0..points.len() as u32).map(Setting::Grid).collect();
        let known = |&(seconds, rmse): &(f64, f64)| Trial {
            setting: Setting::Error(rmse),
            point: Point { seconds, rmse },
        };
        let mut trials: Vec<_> = others.iter().map(known).collect();
        let shoot = |setting| match setting {
            Setting::Grid(k) => {
                let (seconds, rmse) = points[k as usize];
                Ok(Point { seconds, rmse })
            }
            other => Err(other.to_string()),
        };
        climb(&ladder, LIMITS, &mut trials, shoot).unwrap();
        trials.len() - others.len()
    }

    #[test]
    fn a_ladder_is_climbed_while_it_pays() {
        assert_eq!(steps(&[(1.0, 0.1), (4.0, 0.01), (16.0, 5e-3)]), 3, "all of it");
        assert_eq!(steps(&[(1.0, 0.1), (4.0, 1e-3), (16.0, 5e-4)]), 2, "good enough");
        assert_eq!(steps(&[(1.0, 0.1), (4.0, 0.099), (16.0, 5e-4)]), 2, "a plateau");
        assert_eq!(steps(&[(1.0, 0.1), (1.0, 0.1), (16.0, 5e-3)]), 3, "no more work, and more");
        assert_eq!(steps(&[(1.0, 0.1), (20.0, 0.01), (400.0, 5e-4)]), 2, "too long next");
        assert_eq!(steps(&[(30.0, 0.1), (20.0, 0.01)]), 1, "too long at once");
        let climbed = |other| steps_beside(&[other], &[(1.0, 0.1), (4.0, 0.02), (6.0, 5e-3)]);
        assert_eq!(climbed((1.0, 0.02)), 2, "another is as exact and much faster");
        assert_eq!(climbed((2.0, 0.02)), 3, "another is somewhat faster");
    }

    #[test]
    fn trials_on_file_are_read_back() {
        let (found, _) = engine::find(&["goldray-grid"]);
        let engine = &*found[0];
        let point = Point { seconds: 0.5, rmse: 0.25 };
        let trials = [Trial { setting: Setting::Grid(4), point }];
        let bytes = to_bytes(&trials).unwrap();
        assert_eq!(from_bytes(&bytes, engine).as_deref(), Some(&trials[..]));
        let other = to_bytes(&[Trial { setting: Setting::Grid(5), point }]).unwrap();
        assert_eq!(from_bytes(&other, engine), None, "a setting of old");
        assert_eq!(from_bytes(b"{", engine), None);
    }
}
