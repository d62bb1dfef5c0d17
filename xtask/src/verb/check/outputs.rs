//! `Outputs`: what a check writes for others to read: files, and what a build
//! server shows.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::path::{Path, PathBuf};

use harness::report::{Reader, annotations, junit, markdown, run_json};
use harness::store;
use harness::suite::Suite;
use harness::verdict::Outcome;

use crate::{CannotAsk, Here};

/// Flags of what is written.
#[derive(Debug, clap::Args)]
pub(crate) struct Outputs {
    /// Also write everything to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also write it to this file as JUnit XML, for build servers
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Also write a summary to this file as Markdown
    #[arg(long, value_name = "FILE")]
    summary: Option<PathBuf>,
    /// Also print failures as GitHub's runner shows them, and append the summary to the file
    /// that it names [default: where `GITHUB_ACTIONS` is true]
    #[arg(long)]
    github: bool,
}

/// GitHub takes so many bytes of a step's summary, or none of it.
const GITHUB_SUMMARY_BYTES: usize = 1 << 20;

impl Outputs {
    /// Refuses files that cannot be written, before the work of rendering.
    pub(crate) fn may_write(&self, here: &Here) -> Result<(), CannotAsk> {
        let files = [&self.json, &self.junit, &self.summary];
        let files: Vec<_> = files.into_iter().flatten().collect();
        for (i, file) in files.iter().enumerate() {
            here.may_report(file)?;
            if files[..i].iter().any(|other| store::is_inside(file, other)) {
                let what = "expected a file for each output, found it named for two";
                return Err(CannotAsk::file(file, what));
            }
        }
        Ok(())
    }

    /// Writes the files that are asked for.
    ///
    /// # Errors
    /// One of them cannot be written.
    pub(crate) fn write(
        &self,
        here: &Here,
        suite: &Suite,
        outcomes: &[Outcome],
        elapsed_ms: f64,
    ) -> Result<(), CannotAsk> {
        let reader = here.reader(suite);
        if let Some(path) = &self.json {
            let json = serde_json::to_string_pretty(&run_json(outcomes, elapsed_ms))?;
            here.write(path, json.as_bytes())?;
        }
        if let Some(path) = &self.junit {
            here.write(path, junit(outcomes, elapsed_ms, &reader).as_bytes())?;
        }
        if let Some(path) = &self.summary {
            let page = markdown(outcomes, elapsed_ms, &reader, usize::MAX).unwrap_or_default();
            here.write(path, page.as_bytes())?;
        }
        Ok(())
    }

    /// Prints what is meant for people. GitHub's runner is told to take none of it
    /// for a command: names and texts of fixtures are in it.
    pub(crate) fn to_people(&self, print: impl FnOnce()) {
        if !self.is_github() {
            return print();
        }
        // Another word each time, which no fixture knows.
        let word = format!("goldray-{:016x}", RandomState::new().build_hasher().finish());
        println!("::stop-commands::{word}");
        print();
        println!("::{word}::");
    }

    /// Says on GitHub what its runner shows, beside the lines and as the step's
    /// summary.
    pub(crate) fn say(&self, here: &Here, suite: &Suite, outcomes: &[Outcome], elapsed_ms: f64) {
        if !self.is_github() {
            return;
        }
        let reader = here.reader(suite);
        let in_repository = Reader { path_prefix: in_repository(suite), ..reader.clone() };
        print!("{}", annotations(outcomes, &in_repository));
        if let Some(path) = self.step_summary() {
            // The user named no such file: what becomes of it changes no answer.
            let page = |max_bytes| markdown(outcomes, elapsed_ms, &reader, max_bytes);
            if let Err(CannotAsk(why)) = add(here, &path, &page) {
                println!("the summary of this step could not be added to: {why}");
            }
        }
    }

    fn is_github(&self) -> bool {
        self.github || std::env::var_os("GITHUB_ACTIONS").is_some_and(|value| value == "true")
    }

    /// Where the runner takes a summary from, if it is one.
    fn step_summary(&self) -> Option<PathBuf> {
        let file = std::env::var_os("GITHUB_STEP_SUMMARY").filter(|file| !file.is_empty());
        file.filter(|_| self.is_github()).map(PathBuf::from)
    }
}

/// Adds the page of at most so many bytes to the runner's file, if one fits.
fn add(here: &Here, path: &Path, page: &dyn Fn(usize) -> Option<String>) -> Result<(), CannotAsk> {
    // What another command of this step has written stays.
    let found = store::read(path, GITHUB_SUMMARY_BYTES as u64)?.unwrap_or_default();
    match page(GITHUB_SUMMARY_BYTES.saturating_sub(found.len() + 1)) {
        Some(page) => here.write(path, &[&found[..], b"\n", page.as_bytes()].concat()),
        None => Ok(()),
    }
}

/// What is before a path of the suite where paths are relative to the
/// repository: that of the runner, or else the current folder. A suite that is
/// not in it is named in full.
fn in_repository(suite: &Suite) -> String {
    let workspace = std::env::var_os("GITHUB_WORKSPACE").filter(|folder| !folder.is_empty());
    let repository = workspace.map(PathBuf::from).or_else(|| std::env::current_dir().ok());
    let repository = repository.and_then(|folder| store::real_path(&folder).ok());
    let root = store::real_path(suite.root()).unwrap_or_else(|_| suite.root().to_owned());
    match repository.and_then(|folder| root.strip_prefix(folder).map(Path::to_owned).ok()) {
        // With slashes, whatever the system has.
        Some(inside) => inside.iter().map(|part| part.to_string_lossy() + "/").collect(),
        // Joining nothing ends it in a slash.
        None => root.join("").display().to_string(),
    }
}
