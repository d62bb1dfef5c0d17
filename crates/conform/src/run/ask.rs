//! `Renderer`: an adapter whose program is there.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use harness::store;
use harness::suite::Suite;

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
}

/// Why a renderer cannot be asked, as text for people.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CannotAsk(pub String);

/// How long it may take to say its version.
const PATIENCE: Duration = Duration::from_secs(30);

impl Renderer {
    /// The renderer of an adapter by its name or path; see [`locate`]. Its program
    /// is looked for in `path`, folders as in the variable `PATH`, and asked for its
    /// version. `out` is the folder in which its own is, `program` this very program.
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
        let failed = |error: store::StoreError| CannotAsk(error.to_string());
        let folder = out.join(&located.id);
        store::empty_artifacts(&folder).map_err(failed)?;
        let folder = absolute(&folder)?;
        let own = located.folder.unwrap_or_else(|| folder.join("adapter"));
        for (name, bytes) in located.programs {
            store::write(&own.join(name), bytes).map_err(failed)?;
        }
        let filling = Filling {
            folder: own.display().to_string(),
            root: absolute(suite.root())?.display().to_string(),
            program: program.display().to_string(),
            ..Filling::default()
        };
        let info =
            RendererInfo { name: adapter.name.clone(), id: located.id, version: String::new() };
        let mut renderer = Self { info, adapter, filling };
        renderer.check_program(&located.label, path)?;
        renderer.info.version = renderer.version(&folder, stop)?;
        Ok(renderer)
    }

    /// The command for a scene, in a folder.
    pub(super) fn command(&self, words: &[String], folder: &Path) -> Command {
        let (program, args) = words.split_first().map_or(("", &[][..]), |(p, args)| (p, args));
        let mut command = Command::new(program);
        command.args(args).current_dir(folder).envs(&self.adapter.env);
        command
    }

    fn check_program(&self, label: &str, path: &OsStr) -> Result<(), CannotAsk> {
        let own_path = self.adapter.env.get("PATH").map_or(path, OsStr::new);
        for (field, words) in
            [("command", &self.adapter.command), ("version", &self.adapter.version)]
        {
            let Some(word) = words.first() else { continue };
            let program = word.filled(&self.filling);
            let is_relative = Path::new(&program).is_relative() && program.contains('/');
            if is_relative {
                return Err(self.cannot(&format!(
                    "{label}: `{field}`: expected a program by its name or its whole path, found \
                     \"{program}\": write {{folder}}/... for what is beside the adapter file, or \
                     {{root}}/... for what is in the suite"
                )));
            }
            if find_program(&program, own_path).is_none() {
                return Err(self.cannot(&format!("there is no program \"{program}\" here")));
            }
        }
        Ok(())
    }

    /// What it says when asked for its version.
    fn version(&self, folder: &Path, stop: Stop<'_>) -> Result<String, CannotAsk> {
        if self.adapter.version.is_empty() {
            return Ok(String::new());
        }
        let words: Vec<_> =
            self.adapter.version.iter().map(|word| word.filled(&self.filling)).collect();
        let bounds = Bounds { time: PATIENCE, growth: None, stop };
        let ran = run(&mut self.command(&words, folder), &bounds)
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
            Ended::OutOfTime | Ended::TooMuch => Err(self.cannot(&format!(
                "\"{}\" took more than {} s",
                words.join(" "),
                PATIENCE.as_secs()
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
