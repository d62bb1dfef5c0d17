//! `Fixture`: a scene file with its check, ready to be rendered and judged.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;

use scene::{Assets, Encoding, MAX_SCENE_BYTES};
use serde::{Deserialize, Serialize};
pub use tracer::Skipping;
pub use tracer::accel::Build;
use tracer::{LinearImage, Plan, Scene, Stats, render, render_counted};

use crate::check::{Check, File};
use crate::encode::{Transfer, encode};
use crate::expectation::Rendered;
use crate::golden::Provenance;
use crate::hash::{self, content_hash};
use crate::lfs::pointer_problem;
use crate::store::{self, FolderAssets};

/// A fixture without problems.
#[derive(Debug, Clone)]
pub struct Fixture {
    /// What can be rendered.
    pub scene: Scene,
    /// What its picture is held to.
    pub check: Check,
    /// How its picture is stored.
    pub transfer: Transfer,
    /// The content that decides its picture.
    pub provenance: Provenance,
    /// The files that this fixture was read from.
    pub sources: Sources,
    /// What was written, without its check.
    pub(crate) file: File,
    /// What else related scenes are made of.
    assets: BTreeMap<String, Vec<u8>>,
    build: Build,
    /// The text that it was read from.
    pub text: String,
}

/// Hashes of the very bytes that a fixture was read from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sources {
    /// Of the scene file, its `check` and comments included.
    pub fixture: String,
    /// Of each file that the scene names.
    pub assets: BTreeMap<String, String>,
}

impl Fixture {
    /// The fixture in the file at `path`, called `name` in messages.
    ///
    /// # Errors
    /// Everything that is wrong with it, as text for people.
    pub fn open(name: &str, path: &Path, build: Build) -> Result<Self, String> {
        let text = Self::text(name, path)?;
        Self::read(name, &text, &FolderAssets::beside(path), build)
    }

    /// What is written in the file at `path`, called `name` in messages.
    ///
    /// # Errors
    /// A file that cannot be read or is no text, as text for people.
    pub fn text(name: &str, path: &Path) -> Result<String, String> {
        let bytes = store::read(path, MAX_SCENE_BYTES as u64)
            .map_err(|error| format!("{name}: {}\n", error.what))?
            .ok_or_else(|| format!("{name}: there is no such file\n"))?;
        if let Some(problem) = pointer_problem(&bytes, "fixture") {
            return Err(format!("{name}: {problem}\n"));
        }
        String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            format!("{name}: expected UTF-8 text, found another byte at offset {at}\n")
        })
    }

    /// The fixture of this text.
    ///
    /// # Errors
    /// Everything that is wrong with it, as text for people.
    pub fn read(name: &str, text: &str, assets: &dyn Assets, build: Build) -> Result<Self, String> {
        let assets = Hashing { inner: assets, seen: RefCell::default(), kept: RefCell::default() };
        let scene::Loaded { mut file, scene } = scene::load::<Check>(text, &assets, build)
            .map_err(|problems| scene::report(name, text, &problems))?;
        let transfer = match file.encoding {
            Encoding::Gamma22 => Transfer::Gamma22,
            Encoding::Srgb => Transfer::Srgb,
        };
        let check = file.check.take().unwrap_or_default();
        let seen = assets.seen.into_inner();
        let hash = |(name, hash): &(String, blake3::Hash)| (name.clone(), hash::short(hash));
        let sources =
            Sources { fixture: content_hash(text), assets: seen.iter().map(hash).collect() };
        let provenance = provenance(&file, seen).map_err(|error| format!("{name}: {error}\n"))?;
        let (assets, text) = (assets.kept.into_inner(), text.to_owned());
        Ok(Self { scene, check, transfer, provenance, sources, file, assets, build, text })
    }

    /// Where each object is written, by number.
    pub fn object_places(&self) -> Vec<scene::Place> {
        scene::object_places(&self.text, &self.file)
    }

    /// The picture, before encoding, of what became of this fixture's file.
    ///
    /// # Errors
    /// Why that is no scene.
    pub(crate) fn render_related(&self, file: &File) -> Result<LinearImage, String> {
        self.render_related_by(file, self.build)
    }

    /// The same with this accelerator.
    ///
    /// # Errors
    /// Why that is no scene.
    pub(crate) fn render_related_by(
        &self,
        file: &File,
        build: Build,
    ) -> Result<LinearImage, String> {
        let scene = self.recompiled(file, build);
        Ok(render(&scene.map_err(|why| format!("the related scene is refused: {why}"))?))
    }

    /// What was written, without its check.
    pub fn scene_file(&self) -> scene::SceneFile {
        self.file.clone().without_check()
    }

    /// The files that its scene names, with what they hold.
    pub fn assets(&self) -> &BTreeMap<String, Vec<u8>> {
        &self.assets
    }

    /// The fixture of another file, with this one's check and assets.
    ///
    /// # Errors
    /// Why that is no scene.
    pub(crate) fn with_file(&self, file: File) -> Result<Self, String> {
        let scene = self.recompiled(&file, self.build)?;
        Ok(Self { scene, file, ..self.clone() })
    }

    /// The scene of what became of this fixture's file.
    ///
    /// # Errors
    /// Why that is none.
    pub(crate) fn recompiled(&self, file: &File, build: Build) -> Result<Scene, String> {
        scene::recompile(file, &self.assets, build).map_err(|why| {
            let more = match why.len() {
                0 | 1 => String::new(),
                n => format!("; and {} more", n - 1),
            };
            format!("{}{more}", why.first().map_or("", String::as_str))
        })
    }

    /// The picture before encoding.
    pub fn render_linear(&self) -> LinearImage {
        render(&self.scene)
    }

    /// What is done for the picture, and what is skipped.
    pub fn plan(&self, skipping: Skipping) -> Plan {
        Plan::new(&self.scene, skipping)
    }

    /// The picture before encoding, made by this plan, and what it took.
    pub fn render_counted(&self, plan: &Plan) -> (LinearImage, Stats) {
        render_counted(&self.scene, plan)
    }

    /// The picture.
    ///
    /// # Errors
    /// A picture with a NaN in it is refused.
    pub fn render(&self) -> Result<Rendered, String> {
        self.encoded(self.render_linear())
    }

    /// The picture, made anew from what was written: the accelerators as well.
    ///
    /// # Errors
    /// A picture with a NaN in it is refused.
    pub fn render_again(&self) -> Result<Rendered, String> {
        self.with_file(self.file.clone())?.render()
    }

    /// The linear picture with its 8-bit one.
    ///
    /// # Errors
    /// A picture with a NaN in it is refused.
    pub fn encoded(&self, linear: LinearImage) -> Result<Rendered, String> {
        match encode(&linear, self.transfer) {
            Ok(encoded) => Ok(Rendered { linear, encoded }),
            Err(nan) => Err(nan.to_string()),
        }
    }
}

/// Files by name, each with the hash of its content.
type Seen = Vec<(String, blake3::Hash)>;

fn provenance(file: &File, mut assets: Seen) -> Result<Provenance, serde_json::Error> {
    // The canonical text of the parsed scene, whose check was taken out: no
    // comments, no spaces, fields in the format's order, what is at its default
    // left out.
    let scene = serde_json::to_string(file)?;
    assets.sort_by(|a, b| a.0.cmp(&b.0));
    assets.dedup();
    let mut listing = String::new();
    for (name, hash) in &assets {
        listing.extend([hash.to_hex().as_str(), " ", name, "\n"]);
    }
    let (scene, assets) = (content_hash(scene), content_hash(listing));
    Ok(Provenance { schema: Provenance::SCHEMA, scene, assets })
}

/// Passes files on and notes what they held.
struct Hashing<'a> {
    inner: &'a dyn Assets,
    seen: RefCell<Seen>,
    kept: RefCell<BTreeMap<String, Vec<u8>>>,
}

impl Assets for Hashing<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let bytes = self.inner.read(path)?;
        self.seen.borrow_mut().push((path.to_owned(), blake3::hash(&bytes)));
        self.kept.borrow_mut().insert(path.to_owned(), bytes.clone());
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = r#"(
        version: 1, image: (8, 6),
        camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40),
        objects: [Mesh(file: "a.obj")],
    )"#;

    fn note(text: &str, mesh: &str) -> Provenance {
        let files = BTreeMap::from([("a.obj".to_owned(), mesh.as_bytes().to_vec())]);
        Fixture::read("a", text, &files, Build::Bvh).unwrap().provenance
    }

    const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

    #[test]
    fn only_what_decides_the_picture_is_in_the_hashes() {
        let note_of = |from: &str, to: &str| {
            assert!(SCENE.contains(from), "{from}");
            note(&SCENE.replace(from, to), MESH)
        };
        let original = note(SCENE, MESH);
        assert_eq!(note_of("image:", "// a comment\n   image  :"), original);
        assert_eq!(note_of("fov_deg: 40", "fov_deg: 40.0"), original);
        assert_eq!(note_of("objects:", "shading: Classic, objects:"), original, "a default");
        let checked = "check: (limits: (max_abs: 1, reason: \"why\")), objects:";
        assert_eq!(note_of("objects:", checked), original);
        for (from, to) in
            [("40", "41"), ("(8, 6)", "(6, 8)"), ("objects:", "exposure: 2, objects:")]
        {
            let changed = note_of(from, to);
            assert_ne!(changed.scene, original.scene, "{to}");
            assert_eq!(changed.assets, original.assets, "{to}");
        }
        let two = SCENE.replace("[Mesh", "[Mesh(file: \"b.obj\"), Mesh");
        let of_two = |a: &str, b: &str| {
            let file = |name: &str, text: &str| (name.to_owned(), text.as_bytes().to_vec());
            let files = BTreeMap::from([file("a.obj", a), file("b.obj", b)]);
            Fixture::read("a", &two, &files, Build::Bvh).unwrap().provenance.assets
        };
        let changed = MESH.replace("v 1 0 0", "v 3 0 0");
        let all = [of_two(MESH, MESH), of_two(&changed, MESH), of_two(MESH, &changed)];
        assert!(all[0] != all[1] && all[1] != all[2] && all[0] != all[2], "{all:?}");
        let other_mesh = note(SCENE, &MESH.replace("v 1 0 0", "v 2 0 0"));
        assert_eq!(other_mesh.scene, original.scene);
        assert_ne!(other_mesh.assets, original.assets);
    }
}
