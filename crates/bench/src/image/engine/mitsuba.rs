//! Mitsuba 3, by a Python program that stays and renders on request.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde::{Deserialize, Serialize};

use super::{Engine, Setting, Shot, Stage};
use crate::files;
use crate::image::picture::from_floats;

/// The program, and the picture it writes.
const PROGRAM: &str = include_str!("ask_mitsuba.py");
const PICTURE: &str = "mitsuba.f32";
/// Its samplers that place samples evenly, of which there are always better ones
/// than `independent`; all of them take every power of 4.
const SAMPLERS: [&str; 3] = ["stratified", "multijitter", "ldsampler"];
const SAMPLES: [u32; 7] = [1, 4, 16, 64, 256, 1024, 4096];
/// The oldest LLVM that it works with, and how it is told which to use.
const OLDEST_LLVM: u32 = 15;
const LLVM: &str = "DRJIT_LIBLLVM_PATH";
/// Samples of all pixels that are taken at once. More do not fit into memory,
/// and are not faster.
const MOST_AT_ONCE: u32 = 1 << 22;

/// What the program is asked.
#[derive(Debug, Serialize)]
struct Request<'a> {
    scene: &'a std::path::Path,
    picture: &'a std::path::Path,
    sampler: &'a str,
    samples: u32,
    at_once: u32,
}

/// What it answers.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Answer {
    seconds: f64,
    version: String,
    error: Option<String>,
}

/// A Mitsuba that was found and runs.
pub(crate) struct Mitsuba {
    name: &'static str,
    version: String,
    child: Child,
    questions: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Mitsuba {
    /// The one in the folder of peers, in this variant.
    ///
    /// # Errors
    /// Says how to get it.
    pub(crate) fn find(name: &'static str, variant: &str) -> Result<Self, String> {
        let missing = |why: &str| format!("{why}; run `cargo xtask bench peers --install`");
        let python = files::peers().join("venv").join("bin").join("python");
        let program = files::target().join("image").join("ask_mitsuba.py");
        files::write(&program, PROGRAM.as_bytes())?;
        let mut command = Command::new(&python);
        command.arg(&program).arg(variant);
        if variant.starts_with("llvm") && std::env::var_os(LLVM).is_none() {
            let library = llvm().ok_or_else(|| {
                missing(&format!(
                    "expected LLVM {OLDEST_LLVM} or later among the system's libraries, or its \
                     path in {LLVM}"
                ))
            })?;
            command.env(LLVM, library);
        }
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|why| missing(&format!("{} cannot be run: {why}", python.display())))?;
        let (Some(questions), Some(answers)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("no pipes to Mitsuba's program".into());
        };
        let answers = BufReader::new(answers);
        let mut mitsuba = Self { name, version: String::new(), child, questions, answers };
        mitsuba.version = mitsuba.answer().map_err(|why| missing(&why))?.version;
        Ok(mitsuba)
    }

    fn answer(&mut self) -> Result<Answer, String> {
        let mut line = String::new();
        self.answers.read_line(&mut line).map_err(|why| why.to_string())?;
        read(&line)
    }
}

/// An answer of one line.
fn read(line: &str) -> Result<Answer, String> {
    if line.is_empty() {
        return Err("Mitsuba's program ended; what it said is above".into());
    }
    let answer: Answer = serde_json::from_str(line)
        .map_err(|why| format!("expected an answer of Mitsuba's program, found {line:?}: {why}"))?;
    answer.error.map_or(Ok(()), Err)?;
    serde_json::from_str(line).map_err(|why| why.to_string())
}

/// Ends with the bench.
impl Drop for Mitsuba {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The path of the latest LLVM that the system's linker knows.
fn llvm() -> Option<String> {
    let paths = ["ldconfig", "/sbin/ldconfig"];
    let told = paths.iter().find_map(|path| Command::new(path).arg("-p").output().ok())?;
    latest_llvm(&String::from_utf8_lossy(&told.stdout))
}

/// The path of the latest LLVM in a list of the linker's.
fn latest_llvm(told: &str) -> Option<String> {
    let libraries = told.lines().filter_map(|line| {
        let (name, path) = line.trim().split_once(" => ")?;
        let rest = name.strip_prefix("libLLVM-").or_else(|| name.strip_prefix("libLLVM.so."))?;
        let version: u32 = rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()?;
        (version >= OLDEST_LLVM).then(|| (version, path.to_owned()))
    });
    libraries.max().map(|(_, path)| path)
}

impl Engine for Mitsuba {
    fn name(&self) -> &'static str {
        self.name
    }

    fn version(&self) -> String {
        self.version.clone()
    }

    fn ladders(&self) -> Vec<Vec<Setting>> {
        let ladder = |sampler| SAMPLES.map(|samples| Setting::Mitsuba(sampler, samples)).to_vec();
        SAMPLERS.map(ladder).to_vec()
    }

    fn shoot(&mut self, stage: &Stage, setting: Setting) -> Result<Shot, String> {
        let Setting::Mitsuba(sampler, samples) = setting else {
            return Err(format!("Mitsuba has no setting \"{setting}\""));
        };
        let size = stage.size();
        let scene = stage.folder.join(crate::image::export::MITSUBA_SCENE);
        let picture = stage.folder.join(PICTURE);
        let fit = (MOST_AT_ONCE / (size.width * size.height)).max(1);
        // A divisor of the samples, which are a power of 2.
        let at_once = samples.min(1 << fit.ilog2());
        let request = Request { scene: &scene, picture: &picture, sampler, samples, at_once };
        let failed =
            |why: String| format!("{} on {}, {setting}: {why}", self.name, scene.display());
        let mut line = serde_json::to_string(&request).map_err(|why| why.to_string())?;
        line.push('\n');
        let asked = self.questions.write_all(line.as_bytes()).and_then(|()| self.questions.flush());
        asked.map_err(|why| failed(why.to_string()))?;
        let answer = self.answer();
        let failed =
            |why: String| format!("{} on {}, {setting}: {why}", self.name, scene.display());
        let Answer { seconds, .. } = answer.map_err(failed)?;
        let bytes = files::read(&picture)?;
        Ok(Shot { seconds, picture: from_floats(&bytes, size)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_read_and_complaints_passed_on() {
        let answer = read("{\"seconds\": 0.5, \"version\": \"3\"}").unwrap();
        assert_eq!((answer.seconds, answer.version.as_str()), (0.5, "3"));
        assert_eq!(read("{\"error\": \"no such file\"}").unwrap_err(), "no such file");
        assert!(read("").unwrap_err().contains("ended"));
        assert!(read("Traceback").unwrap_err().contains("\"Traceback\""));
    }

    #[test]
    fn the_latest_llvm_that_works_is_taken() {
        let list = |names: &[&str]| {
            let lines = names.iter().map(|name| format!("\t{name} (libc6,x86-64) => /lib/{name}"));
            latest_llvm(&lines.collect::<Vec<_>>().join("\n"))
        };
        assert_eq!(list(&["libLLVM-14.so.1", "libm.so.6"]), None);
        let found = list(&["libLLVM-14.so.1", "libLLVM-15.so.1"]);
        assert_eq!(found.as_deref(), Some("/lib/libLLVM-15.so.1"));
        let found = list(&["libLLVM-15.so.1", "libLLVM.so.19.1"]);
        assert_eq!(found.as_deref(), Some("/lib/libLLVM.so.19.1"));
    }
}
