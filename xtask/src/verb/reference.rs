//! `Reference`: another build of this program, which is asked for pictures.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use crate::CannotAsk;
use conform::process::{Bounds, Ended, never, run};
use harness::encode::EncodedImage;
use harness::fixture::Fixture;
use harness::judge::Found;
use harness::run::find_golden;
use harness::store::{self, Scratch};

/// How long it may take for a picture.
const PATIENCE: Duration = Duration::from_mins(1);

/// Another build of this program.
pub(crate) struct Reference {
    program: PathBuf,
    /// Where a scene is put, with its assets.
    folder: Scratch,
}

impl Reference {
    /// This program, to be asked for pictures of what becomes of a fixture.
    ///
    /// # Errors
    /// There is no such file, or the scene's files cannot be put beside it.
    pub(crate) fn new(program: &Path, fixture: &Fixture) -> Result<Self, CannotAsk> {
        if !store::is_file(program) {
            return Err(CannotAsk::file(program, "expected a program, found no such file"));
        }
        let folder = Scratch::new()?;
        for (name, bytes) in fixture.assets() {
            store::write(&folder.path(name), bytes)?;
        }
        Ok(Self { program: std::path::absolute(program)?, folder })
    }

    /// Its picture of a scene.
    ///
    /// # Errors
    /// What it says instead, or that it makes none in time.
    pub(crate) fn render(&self, text: &str) -> Result<EncodedImage, String> {
        // A name that no asset is likely to have.
        let scene = self.folder.path("goldray-minimize.ron");
        let picture = self.folder.path("goldray-minimize.png");
        store::write(&scene, text.as_bytes()).map_err(|error| error.to_string())?;
        // That of the scene before is not to be taken for this one's.
        if store::is_file(&picture) {
            store::remove(&picture).map_err(|error| error.to_string())?;
        }
        let name = self.program.display();
        let mut command = Command::new(&self.program);
        command.arg("render").arg(&scene).arg("--out").arg(&picture);
        let bounds = Bounds { time: PATIENCE, growth: None, stop: &never };
        let ran = run(&mut command, &bounds).map_err(|error| format!("{name}: {error}"))?;
        match ran.ended {
            Ended::Alone(status) if status.success() => {}
            Ended::Alone(status) => {
                return Err(format!("{name}: {status}: {}", ran.stderr.text().trim()));
            }
            Ended::OutOfTime | Ended::TooMuch | Ended::Stopped => {
                return Err(format!("{name}: made no picture in {} s", PATIENCE.as_secs()));
            }
        }
        match find_golden(&picture) {
            Found::Golden(golden) => Ok(golden.picture),
            Found::Nothing => {
                Err(format!("{name} render SCENE --out PICTURE: expected a picture, found none"))
            }
            Found::Unreadable(why) => Err(format!("{name}: its picture {why}")),
        }
    }
}
