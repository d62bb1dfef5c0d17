//! The scenes of `bench image`: each one text, which all renderers are given.

mod generate;
mod knot;
mod triangles;

use std::collections::BTreeMap;

use scene::{SceneFile, Unchecked};
use tracer::Scene;
use tracer::accel::Build;

pub(crate) use triangles::Triangles;

/// A scene before it is read.
pub(crate) struct Source {
    /// What it is called by `--scenes`, the table and the plot.
    pub(crate) name: &'static str,
    /// What there is to see, in a few words.
    pub(crate) about: &'static str,
    /// The scene in goldray's own format.
    pub(crate) text: String,
    /// The meshes it names.
    pub(crate) meshes: BTreeMap<String, Triangles>,
    /// Whether its truth is the formula of the one disk that it shows.
    pub(crate) is_disk: bool,
}

/// A scene that was read.
pub(crate) struct Read {
    /// What was written.
    pub(crate) file: SceneFile,
    /// What is rendered, its triangles met exactly.
    pub(crate) accurate: Scene,
    /// The same with triangles met in `f32`.
    pub(crate) fast: Scene,
}

impl Source {
    fn new(name: &'static str, about: &'static str, text: impl Into<String>) -> Self {
        let (text, meshes) = (text.into(), BTreeMap::new());
        Self { name, about, text, meshes, is_disk: false }
    }

    /// The scene, at a size of its own or at this one.
    ///
    /// # Errors
    /// What the scene's text says wrong.
    pub(crate) fn read(&self, size: Option<(u32, u32)>) -> Result<Read, String> {
        let text = match size {
            Some((width, height)) => {
                self.text.replace("image: (640, 480)", &format!("image: ({width}, {height})"))
            }
            None => self.text.clone(),
        };
        let assets: BTreeMap<_, _> =
            self.meshes.iter().map(|(name, mesh)| (name.clone(), mesh.ply())).collect();
        let load = |build| {
            scene::load::<Unchecked>(&text, &assets, build).map_err(|problems| {
                let all: Vec<_> = problems.into_iter().map(|problem| problem.message).collect();
                format!("scene {}: {}", self.name, all.join("; "))
            })
        };
        let accurate = load(Build::Bvh)?;
        let fast = load(Build::Fast)?.scene;
        Ok(Read { file: accurate.file, accurate: accurate.scene, fast })
    }

    /// Whether any of it is made of triangles of a mesh, which alone are met
    /// otherwise in `f32`.
    pub(crate) fn has_mesh(&self) -> bool {
        !self.meshes.is_empty()
    }

    /// A number for the content: other scenes, and other states of the same,
    /// have other ones.
    pub(crate) fn hash(&self, size: (u32, u32)) -> String {
        /// As many letters as tell all scenes apart.
        const LETTERS: usize = 16;
        let mut hasher = blake3::Hasher::new();
        hasher.update(self.text.as_bytes());
        hasher.update(format!("{size:?}").as_bytes());
        for (name, mesh) in &self.meshes {
            hasher.update(name.as_bytes());
            hasher.update(&mesh.ply());
        }
        hasher.finalize().to_hex()[..LETTERS].to_owned()
    }
}

/// All scenes, the simplest first.
pub(crate) fn all() -> Vec<Source> {
    let knot = include_str!("knot.ron");
    let mesh = || BTreeMap::from([("knot.ply".to_owned(), knot::knot())]);
    let flat = knot.replace("FLAT", "true");
    let smooth = knot.replace("FLAT", "false");
    vec![
        Source {
            is_disk: true,
            ..Source::new("disk", "a shining disk, known in closed form", include_str!("disk.ron"))
        },
        Source::new("balls", "7 spheres, 2 lights", include_str!("balls.ron")),
        Source::new("frame", "12 boxes, 5 spheres", include_str!("frame.ron")),
        Source::new("temple", "cylinders, boxes, triangles", include_str!("temple.ron")),
        Source::new("city", "576 boxes", generate::city()),
        Source::new("spheres", "1000 spheres", generate::spheres()),
        Source::new("fence", "160 rods, thinner than a pixel far away", generate::fence()),
        Source {
            meshes: mesh(),
            ..Source::new("knot-flat", "a mesh of 49152 triangles, flat", flat)
        },
        Source {
            meshes: mesh(),
            ..Source::new("knot-smooth", "a mesh of 49152 triangles, smooth", smooth)
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_can_be_read_at_any_size() {
        for source in all() {
            let read = source.read(Some((64, 48))).unwrap();
            assert_eq!(read.accurate.size().width, 64, "{}", source.name);
            assert_eq!(source.read(None).unwrap().accurate.size().width, 640, "{}", source.name);
        }
    }

    #[test]
    fn other_contents_have_other_hashes() {
        let mut hashes: Vec<_> = all().iter().map(|source| source.hash((640, 480))).collect();
        hashes.push(all()[0].hash((64, 48)));
        let count = hashes.len();
        hashes.sort();
        hashes.dedup();
        assert_eq!(hashes.len(), count);
    }

    #[test]
    fn mistakes_are_told_with_the_scene() {
        let source = Source::new("bad", "", "(version: 1)");
        let why = source.read(None).err().unwrap();
        assert!(why.starts_with("scene bad: "), "{why}");
    }
}
