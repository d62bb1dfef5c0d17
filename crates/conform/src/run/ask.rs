//! `Renderer`: an adapter whose program is there.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use harness::store::{self, Scratch, StoreError};
use harness::suite::Suite;

use super::one::MAX_WRITTEN;
use crate::RendererInfo;
use crate::adapter::{Adapter, Filling, find_program, locate};
use crate::process::{Bounds, Ended, Stop, run};

/// A renderer that can be asked.
#[derive(Debug, Clone)]
pub struct Renderer {
    /// Its name, and its version if it was asked for it.
    pub info: RendererInfo,
    /// How it is asked.
    pub adapter: Adapter,
    /// What is the same for every scene.
    pub filling: Filling,
    /// The programs that it needs in a folder of its own, which [`Renderer::prepare`]
    /// makes.
    programs: &'static [(&'static str, &'static [u8])],
    /// Its adapter's file, if it has one.
    path: Option<PathBuf>,
    /// Where the programs are that its commands name, by what they are called there.
    places: BTreeMap<String, String>,
}

/// Why a renderer cannot be asked, as text for people.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CannotAsk(pub String);

/// The variable that says where temporary files go.
const TEMPORARY: &str = "TMPDIR";

/// How long it may take to say its version.
const PATIENCE: Duration = Duration::from_secs(30);

impl Renderer {
    /// The renderer of an adapter by its name or path; see [`locate`]. Its program
    /// is looked for in `path`, folders as in the variable `PATH`, and asked for its
    /// version. `out` is the folder in which its own is, `program` this very program.
    ///
    /// Nothing is written or removed there: what an earlier run has left stays as long as
    /// not all that are asked for are found.
    ///
    /// # Errors
    /// There is no such adapter, it has problems, or its program is not there.
    pub fn find(
        suite: &Suite,
        wanted: &str,
        (out, program, path): (&Path, &Path, &OsStr),
        stop: Stop<'_>,
    ) -> Result<Self, CannotAsk> {
        let located = locate(suite, wanted).map_err(CannotAsk)?;
        let adapter = Adapter::read(&located.label, &located.text).map_err(CannotAsk)?;
        let folder = absolute(&out.join(&located.id))?;
        let own = located.folder.unwrap_or_else(|| folder.join("adapter"));
        let filling = Filling {
            folder: own.display().to_string(),
            root: absolute(suite.root())?.display().to_string(),
            program: program.display().to_string(),
            ..Filling::default()
        };
        let info =
            RendererInfo { name: adapter.name.clone(), id: located.id, version: String::new() };
        let (programs, path_of_file) = (located.programs, located.path);
        let places = BTreeMap::new();
        let mut renderer = Self { info, adapter, filling, programs, path: path_of_file, places };
        renderer.check_program(&located.label, path)?;
        renderer.info.version = renderer.version(stop)?;
        Ok(renderer)
    }

    /// Whether [`Renderer::prepare`] may empty this folder. Nothing is changed.
    ///
    /// # Errors
    /// A folder that is not goldray's to empty.
    pub fn check_folder(folder: &Path) -> Result<(), StoreError> {
        store::check_artifacts(folder)
    }

    /// Makes an empty folder for its results, with the programs that it needs beside them.
    ///
    /// # Errors
    /// A folder that is not goldray's to empty, and what cannot be written.
    pub fn prepare(&self, folder: &Path) -> Result<(), StoreError> {
        store::empty_artifacts(folder)?;
        self.write_programs(Path::new(&self.filling.folder))
    }

    /// The files that it is asked by, which nobody may write over: its adapter, and what
    /// the words of its commands name by a whole path.
    pub fn own_files(&self) -> Vec<PathBuf> {
        let words = self.adapter.command.iter().chain(&self.adapter.version);
        let named = words.map(|word| PathBuf::from(word.filled(&self.filling)));
        let named = named.filter(|path| path.is_absolute() && store::is_file(path));
        self.path.iter().cloned().chain(named).collect()
    }

    fn write_programs(&self, own: &Path) -> Result<(), StoreError> {
        self.programs.iter().try_for_each(|(name, bytes)| store::write(&own.join(name), bytes))
    }

    /// The words with the program's whole path. It is run in another folder, where a path
    /// from here leads to nothing, and by hand with another `PATH`.
    pub(super) fn placed(&self, mut words: Vec<String>) -> Vec<String> {
        if let Some(word) = words.first_mut()
            && let Some(place) = self.places.get(word)
        {
            word.clone_from(place);
        }
        words
    }

    /// The command for a scene, in a folder.
    pub(super) fn command(&self, words: &[String], folder: &Path) -> Command {
        let (program, args) = words.split_first().map_or(("", &[][..]), |(p, args)| (p, args));
        let mut command = Command::new(program);
        command.args(args).current_dir(folder).envs(&self.adapter.env);
        if !self.adapter.env.contains_key(TEMPORARY) {
            // What it leaves there goes away with the folder.
            command.env(TEMPORARY, folder);
        }
        command
    }

    fn check_program(&mut self, label: &str, path: &OsStr) -> Result<(), CannotAsk> {
        let own_path = self.adapter.env.get("PATH").map_or(path.to_owned(), Into::into);
        let fields = [("command", &self.adapter.command), ("version", &self.adapter.version)];
        let programs = fields
            .map(|(field, words)| (field, words.first().map(|word| word.filled(&self.filling))));
        for (field, program) in programs {
            let Some(program) = program else { continue };
            let is_relative = Path::new(&program).is_relative() && program.contains('/');
            if is_relative {
                return Err(self.cannot(&format!(
                    "{label}: `{field}`: expected a program by its name or its whole path, found \
                     \"{program}\": write {{folder}}/... for what is beside the adapter file, or \
                     {{root}}/... for what is in the suite"
                )));
            }
            let Some(found) = find_program(&program, &own_path) else {
                return Err(self.cannot(&format!("there is no program \"{program}\" here")));
            };
            // A word is text; a path that is none is left to be looked for once more.
            if let Some(place) = absolute(&found)?.to_str() {
                self.places.insert(program, place.to_owned());
            }
        }
        Ok(())
    }

    /// What it says when asked for its version, in a folder that goes away.
    fn version(&self, stop: Stop<'_>) -> Result<String, CannotAsk> {
        if self.adapter.version.is_empty() {
            return Ok(String::new());
        }
        let failed = |error: StoreError| CannotAsk(error.to_string());
        let scratch = Scratch::new().map_err(failed)?;
        let mut filling = self.filling.clone();
        if !self.programs.is_empty() {
            let own = scratch.path("adapter");
            self.write_programs(&own).map_err(failed)?;
            filling.folder = own.display().to_string();
        }
        let words: Vec<_> = self.adapter.version.iter().map(|word| word.filled(&filling)).collect();
        let growth = Some((scratch.folder(), MAX_WRITTEN));
        let bounds = Bounds { time: PATIENCE, growth, stop };
        let ran = run(&mut self.command(&self.placed(words.clone()), scratch.folder()), &bounds)
            .map_err(|error| self.cannot(&format!("\"{}\": {error}", words.join(" "))))?;
        let (stdout, stderr) = (ran.stdout.text(), ran.stderr.text());
        let first = |text: &str| {
            let line = text.lines().map(str::trim).find(|line| !line.is_empty());
            line.map(|line| scene::visible(line).chars().take(100).collect::<String>())
        };
        let said = first(&stdout).or_else(|| first(&stderr));
        match ran.ended {
            Ended::Alone(status) if status.success() => said.ok_or_else(|| {
                self.cannot(&format!("\"{}\" says nothing: expected a version", words.join(" ")))
            }),
            Ended::Alone(status) => {
                // The last line of a failure says most.
                let last = stderr.lines().rev().map(str::trim).find(|line| !line.is_empty());
                let said = last.map(|line| format!(": {}", scene::visible(line)));
                let words = words.join(" ");
                Err(self
                    .cannot(&format!("\"{words}\" failed: {status}{}", said.unwrap_or_default())))
            }
            Ended::Stopped => Err(CannotAsk("interrupted".to_owned())),
            Ended::OutOfTime => Err(self.cannot(&format!(
                "\"{}\" took more than {} s: expected a version",
                words.join(" "),
                PATIENCE.as_secs()
            ))),
            Ended::TooMuch => Err(self.cannot(&format!(
                "\"{}\" wrote more than {MAX_WRITTEN} bytes: expected a version",
                words.join(" ")
            ))),
        }
    }

    fn cannot(&self, why: &str) -> CannotAsk {
        let help = match self.adapter.help.as_str() {
            "" => String::new(),
            help => format!("; {help}"),
        };
        CannotAsk(format!("{} cannot be asked: {why}{help}", self.info.name))
    }
}

fn absolute(path: &Path) -> Result<PathBuf, CannotAsk> {
    std::path::absolute(path).map_err(|error| CannotAsk(format!("{}: {error}", path.display())))
}
