//! goldray: by a grid or where the error is, exact or in `f32`.

use rayon::{ThreadPool, ThreadPoolBuilder};
use tracer::{Samples, Scene, SceneParts, render};

use super::{Engine, OURS, Setting, Shot, Stage};
use crate::measure::thread_seconds;

/// Samples a pixel of the grid.
const GRIDS: [u32; 9] = [1, 4, 9, 16, 36, 64, 144, 256, 1024];
/// Errors asked for.
const ERRORS: [f64; 10] = [0.3, 0.1, 0.03, 0.01, 5e-3, 2e-3, 1e-3, 3e-4, 1e-4, 3e-5];

/// One way of goldray's.
pub(crate) struct Goldray {
    name: &'static str,
    is_adaptive: bool,
    is_fast: bool,
    /// Of one thread.
    pool: ThreadPool,
}

impl Goldray {
    /// The way of this name, one of [`OURS`].
    pub(crate) fn find(name: &str) -> Result<Self, String> {
        let name = OURS
            .into_iter()
            .find(|known| *known == name)
            .ok_or_else(|| format!("expected one of {OURS:?}, found \"{name}\""))?;
        let pool = ThreadPoolBuilder::new().num_threads(1).build();
        Ok(Self {
            name,
            is_adaptive: name.contains("adaptive"),
            is_fast: name.contains("fast"),
            pool: pool.map_err(|why| format!("no thread to render on: {why}"))?,
        })
    }
}

impl Engine for Goldray {
    fn name(&self) -> &'static str {
        self.name
    }

    fn version(&self) -> String {
        env!("CARGO_PKG_VERSION").into()
    }

    fn ladders(&self) -> Vec<Vec<Setting>> {
        vec![if self.is_adaptive {
            ERRORS.into_iter().map(Setting::Error).collect()
        } else {
            GRIDS.into_iter().map(Setting::Grid).collect()
        }]
    }

    /// Without a mesh the fast way is the exact one.
    fn is_redundant(&self, stage: &Stage) -> bool {
        self.is_fast && !stage.source.has_mesh()
    }

    fn shoot(&mut self, stage: &Stage, setting: Setting) -> Result<Shot, String> {
        let scene = if self.is_fast { &stage.read.fast } else { &stage.read.accurate };
        let scene = set(scene, setting)?;
        Ok(self.pool.install(|| {
            let start = thread_seconds();
            let picture = render(&scene);
            Shot { seconds: thread_seconds() - start, picture }
        }))
    }
}

/// The scene with this setting.
fn set(scene: &Scene, setting: Setting) -> Result<Scene, String> {
    let set = match setting {
        Setting::Error(error) => scene.with_error(error),
        Setting::Grid(samples) => Samples::grid(samples)
            .and_then(|samples| Scene::new(SceneParts { samples, ..scene.parts().clone() })),
        other => return Err(format!("goldray has no setting \"{other}\"")),
    };
    set.map_err(|why| why.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::scenes;

    #[test]
    fn both_ways_render_and_others_settings_are_refused() {
        let stage = Stage::new(scenes::all().remove(0), Some((32, 24))).unwrap();
        for name in OURS {
            let mut engine = Goldray::find(name).unwrap();
            let setting = engine.ladders()[0][0];
            let shot = engine.shoot(&stage, setting).unwrap();
            assert_eq!(shot.picture.size(), stage.size());
            assert!(shot.seconds > 0.0);
            assert_eq!(engine.is_redundant(&stage), name.ends_with("fast"));
            let why = engine.shoot(&stage, Setting::Mitsuba("independent", 1)).err().unwrap();
            assert_eq!(why, "goldray has no setting \"independent 1\"");
        }
        assert!(Goldray::find("goldray-best").err().unwrap().contains("found \"goldray-best\""));
    }
}
