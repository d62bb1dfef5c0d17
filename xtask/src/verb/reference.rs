//! `Reference`: another build of this program, which is asked for pictures.

use std::io::{Read, sink};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use crate::CannotAsk;
use harness::encode::EncodedImage;
use harness::fixture::Fixture;
use harness::judge::Found;
use harness::run::find_golden;
use harness::store::{self, Scratch};

/// How long it may take for a picture.
const PATIENCE: Duration = Duration::from_mins(1);

/// How often it is asked whether it has ended.
const LOOK_EVERY: Duration = Duration::from_millis(2);

/// How much of what it says is kept.
const KEPT_BYTES: u64 = 4_096;

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
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        let child = command.spawn().map_err(|error| format!("{name}: {error}"))?;
        let (status, said) = end_of(child);
        match status {
            Ok(status) if status.success() => {}
            Ok(status) => return Err(format!("{name}: {status}: {}", said.trim())),
            Err(why) => return Err(format!("{name}: {why}")),
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

/// How a program ends, and the first of what it says as errors.
fn end_of(mut child: Child) -> (Result<ExitStatus, String>, String) {
    let errors = child.stderr.take();
    let listener = std::thread::spawn(move || {
        let mut said = Vec::new();
        if let Some(mut errors) = errors {
            // The rest is heard as well, so that it is not kept waiting.
            let _ = errors.by_ref().take(KEPT_BYTES).read_to_end(&mut said);
            let _ = std::io::copy(&mut errors, &mut sink());
        }
        String::from_utf8_lossy(&said).into_owned()
    });
    let started = Instant::now();
    let status = loop {
        match child.try_wait() {
            Ok(Some(status)) => break Ok(status),
            Err(error) => break Err(error.to_string()),
            Ok(None) if started.elapsed() < PATIENCE => std::thread::sleep(LOOK_EVERY),
            Ok(None) => {
                let _ = child.kill();
                let _ = child.wait();
                // What it has started may go on and hold its output open.
                return (
                    Err(format!("made no picture in {} s", PATIENCE.as_secs())),
                    String::new(),
                );
            }
        }
    };
    (status, listener.join().unwrap_or_default())
}
