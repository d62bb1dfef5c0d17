//! `Case`: a fixture as it is written and as it is read, with its golden.

use scene::SceneFile;
use tracer::accel::Build;

use crate::check::Check;
use crate::encode::EncodedImage;
use crate::fixture::Fixture;
use crate::judge::Found;
use crate::run::find_golden;
use crate::store::FolderAssets;
use crate::suite::Suite;

/// What is asked of a fixture beyond today's verdict starts from this.
#[derive(Debug, Clone)]
pub struct Case {
    /// The fixture's name.
    pub name: String,
    /// The text of its file.
    pub text: String,
    /// What the text says.
    pub file: SceneFile<Check>,
    /// What the text means.
    pub fixture: Fixture,
    /// The golden's picture.
    pub golden: EncodedImage,
    assets: FolderAssets,
}

impl Case {
    /// The fixture of this name and its golden.
    ///
    /// # Errors
    /// Everything that is wrong with the fixture, or that there is no golden to
    /// be read, as text for people.
    pub fn open(suite: &Suite, name: &str) -> Result<Self, String> {
        let (label, path) = (Suite::fixture_label(name), suite.fixture_path(name));
        let text = Fixture::text(&label, &path)?;
        let assets = FolderAssets::beside(&path);
        let build = Build::default();
        let fixture = Fixture::read(&label, &text, &assets, build)?;
        let loaded = scene::load::<Check>(&text, &assets, build)
            .map_err(|problems| scene::report(&label, &text, &problems))?;
        let golden = match find_golden(&suite.golden_path(name)) {
            Found::Golden(golden) => golden.picture,
            Found::Nothing => return Err(format!("{label}: there is no golden")),
            Found::Unreadable(why) => return Err(format!("{label}: the golden {why}")),
        };
        Ok(Self { name: name.to_owned(), text, file: loaded.file, fixture, golden, assets })
    }

    /// The same fixture with another scene in it.
    ///
    /// # Errors
    /// Everything that makes no sense in the scene.
    pub fn with_scene(&self, file: &SceneFile<Check>) -> Result<Fixture, String> {
        let scene = scene::compile(file, &self.assets, Build::default());
        let scene = scene.map_err(|messages| messages.join("; "))?;
        Ok(Fixture { scene, ..self.fixture.clone() })
    }

    /// The line of the text with what is at this path, from 1.
    pub fn line_of(&self, path: &[scene::Step]) -> usize {
        scene::line_column(&self.text, scene::span_of(&self.text, path).start).0
    }
}
