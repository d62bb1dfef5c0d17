//! `Adapter`: how a renderer that goldray does not know is asked for a picture,
//! read from a small RON file.
//!
//! `docs/conform.md` has its fields. All problems of a file's form are told at once,
//! then all of its meaning, each with its place.

mod builtin;
mod find;
mod meaning;
mod word;

pub use builtin::BUILTIN;
pub use find::{Located, find_program, locate};
pub use meaning::{Meaning, Rounding, Rows, Transfer};
pub use word::{Filling, Word};

use std::collections::BTreeMap;
use std::time::Duration;

use harness::suite::Suite;
use interchange::Feature;
use interchange::export::Dialect;
use scene::{Problem, Step, report, span_of};
use serde::Deserialize;

/// What an adapter file says.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename = "Adapter", deny_unknown_fields)]
struct AdapterFile {
    name: String,
    command: Vec<String>,
    #[serde(default)]
    version: Vec<String>,
    #[serde(default)]
    help: String,
    scene: Dialect,
    #[serde(default = "default_output")]
    output: String,
    #[serde(default)]
    transfer: Transfer,
    #[serde(default)]
    rounding: Rounding,
    #[serde(default)]
    rows: Rows,
    #[serde(default = "default_timeout")]
    timeout_s: f64,
    #[serde(default)]
    unsupported: BTreeMap<Feature, String>,
    #[serde(default)]
    same_samples: bool,
    #[serde(default = "default_tolerance")]
    tolerance: f64,
    #[serde(default = "all")]
    edges: f64,
    #[serde(default = "default_reach")]
    edge_reach: f64,
    #[serde(default)]
    env: BTreeMap<String, String>,
}

fn default_output() -> String {
    "out.exr".to_owned()
}
fn default_timeout() -> f64 {
    60.0
}
fn default_tolerance() -> f64 {
    1e-5
}
fn all() -> f64 {
    1.0
}
fn default_reach() -> f64 {
    DEFAULT_REACH
}

/// The longest name of a file that file systems have, in bytes.
const MOST_OF_A_NAME: usize = 255;

/// How far a sample is moved to tell edges, in pixels, unless an adapter says so.
pub const DEFAULT_REACH: f64 = 1.0 / 64.0;

/// The longest that a renderer may be given for a picture, in seconds: a day.
pub const MAX_TIMEOUT_S: f64 = 86_400.0;

/// How a renderer is asked, and how its pictures are meant.
#[derive(Debug, Clone, PartialEq)]
pub struct Adapter {
    /// The renderer's name for people.
    pub name: String,
    /// The program and its arguments.
    pub command: Vec<Word>,
    /// What it is asked for its version by; empty if it is not.
    pub version: Vec<Word>,
    /// What to do where there is no such program; may be empty.
    pub help: String,
    /// The language of the scenes that it reads.
    pub scene: Dialect,
    /// The name of the picture that it writes, in the folder where it is run.
    pub output: String,
    /// What the numbers of its pictures mean.
    pub meaning: Meaning,
    /// How long it may take for a picture.
    pub timeout: Duration,
    /// What it cannot do, each with a reason, which may be empty.
    pub unsupported: BTreeMap<Feature, String>,
    /// Whether it takes the very samples that goldray does where a scene asks for
    /// several, for a filter or for an error.
    pub same_samples: bool,
    /// How far an interior pixel may be off, relative.
    pub tolerance: f64,
    /// Which share of the edge pixels may be off.
    pub edges: f64,
    /// How far a sample is moved to tell edges, in pixels.
    pub edge_reach: f64,
    /// Variables of its environment, beside those of this program.
    pub env: BTreeMap<String, String>,
}

impl Adapter {
    /// The adapter that is asked for by its name or path; see [`locate`].
    ///
    /// # Errors
    /// There is none, or all its problems, as text for people.
    pub fn find(suite: &Suite, wanted: &str) -> Result<Self, String> {
        let located = locate(suite, wanted)?;
        Self::read(&located.label, &located.text)
    }

    /// Reads an adapter file, called `name` in messages.
    ///
    /// # Errors
    /// All its problems, as text for people.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        let problems = |problems: Vec<Problem>| report(name, text, &problems);
        let file = scene::read::<AdapterFile>(text).map_err(problems)?;
        let mut found = Vec::new();
        let mut refuse = |path: Vec<Step>, message: String, help: Option<String>| {
            found.push(Problem { span: span_of(text, &path), message, help });
        };
        let command = words("command", &file.command, &mut refuse);
        let version = words("version", &file.version, &mut refuse);
        examine(&file, &command, &version, &mut refuse);
        if !found.is_empty() {
            found.sort_by_key(|problem| problem.span);
            return Err(problems(found));
        }
        Ok(Self {
            name: file.name,
            command,
            version,
            help: file.help,
            scene: file.scene,
            output: file.output,
            meaning: Meaning { transfer: file.transfer, rounding: file.rounding, rows: file.rows },
            timeout: Duration::from_secs_f64(file.timeout_s),
            unsupported: file.unsupported,
            same_samples: file.same_samples,
            tolerance: file.tolerance,
            edges: file.edges,
            edge_reach: file.edge_reach,
            env: file.env,
        })
    }
}

/// Notes a problem: its path, what is wrong, what helps.
type Refuse<'a> = dyn FnMut(Vec<Step>, String, Option<String>) + 'a;

/// The words of a command; those that cannot be read are refused.
fn words(field: &'static str, written: &[String], refuse: &mut Refuse<'_>) -> Vec<Word> {
    let mut words = Vec::new();
    for (number, text) in written.iter().enumerate() {
        match Word::read(text) {
            Ok(word) => words.push(word),
            Err((message, help)) => refuse(vec![field.into(), number.into()], message, help),
        }
    }
    words
}

/// What makes no sense in a file.
fn examine(file: &AdapterFile, command: &[Word], version: &[Word], refuse: &mut Refuse<'_>) {
    /// The largest tolerance: a tenth is no agreement.
    const LOOSEST: f64 = 0.1;
    let at = |field: &'static str| vec![Step::from(field)];
    if file.name.trim().is_empty() {
        refuse(at("name"), "expected a name, found none".to_owned(), None);
    } else if file.name.chars().any(scene::is_invisible) {
        let found = scene::visible(&file.name);
        let message = format!("expected a name of letters that are seen, found \"{found}\"");
        refuse(at("name"), message, None);
    }
    let is_complete = command.len() == file.command.len();
    if file.command.is_empty() {
        refuse(
            at("command"),
            "expected a program and its arguments, found nothing".to_owned(),
            None,
        );
    } else if is_complete && !command.iter().any(|word| word.names("scene")) {
        let help = "the file to render is written {scene}".to_owned();
        refuse(at("command"), "expected a word with {scene}, found none".to_owned(), Some(help));
    }
    for (field, words) in [("command", command), ("version", version)] {
        let is_early = field == "version";
        for (number, word) in words.iter().enumerate().filter(|(n, _)| is_early || *n == 0) {
            if let Some(late) = word.of_a_scene() {
                let message = format!("{{{late}}} is known only where a scene is rendered");
                refuse(vec![field.into(), number.into()], message, None);
            }
        }
    }
    if file.scene == Dialect::Obj {
        let message = "expected a language with cameras and lights, found Obj, which has neither";
        let help = "whoever renders an OBJ file sees no more than shapes and their colors: take \
                    `scene: Json`, which says all, or another";
        refuse(at("scene"), message.to_owned(), Some(help.to_owned()));
    }
    let is_plain = |name: &str| {
        !name.is_empty() && name != "." && name != ".." && !name.contains(['/', '\\', '\0', ':'])
    };
    if !is_plain(&file.output) {
        let message = format!("expected the name of a file, found \"{}\"", file.output);
        let help = "it is written into the folder where the program is run".to_owned();
        refuse(at("output"), message, Some(help));
    }
    let mut range = |field: &'static str, found: f64, least: f64, most: f64| {
        if !(least..=most).contains(&found) {
            let message = format!("expected a number from {least} to {most}, found {found}");
            refuse(at(field), message, None);
        }
    };
    range("timeout_s", file.timeout_s, 0.1, MAX_TIMEOUT_S);
    range("tolerance", file.tolerance, 0.0, LOOSEST);
    range("edges", file.edges, 0.0, 1.0);
    range("edge_reach", file.edge_reach, 1e-6, 0.1);
    for name in file.env.keys() {
        if name.is_empty() || name.contains(['=', '\0']) {
            let found = scene::visible(name);
            let message = format!("expected the name of a variable, found \"{found}\"");
            let help = "letters, digits and _, without = and zero bytes".to_owned();
            refuse(vec!["env".into(), Step::key(name.clone())], message, Some(help));
        }
    }
    sizes(file, refuse);
}

/// What no system starts a program with.
fn sizes(file: &AdapterFile, refuse: &mut Refuse<'_>) {
    /// The most bytes of a command, and of what is set in the environment beside it.
    /// Windows starts no longer command than 32,767 characters, Linux has no longer word
    /// than 128 KiB; what is filled in needs room too.
    const MOST: usize = 24 << 10;
    let in_script = "put it into a script beside the adapter: {folder}/render.sh";
    for (field, words) in [("command", &file.command), ("version", &file.version)] {
        let bytes: usize = words.iter().map(String::len).sum();
        if bytes > MOST {
            let message = format!("expected a command of at most {MOST} bytes, found {bytes}");
            refuse(vec![field.into()], message, Some(in_script.to_owned()));
        }
    }
    for (name, value) in file.env.iter().filter(|(_, value)| value.contains('\0')) {
        let found = scene::visible(value);
        let found: String = found.chars().take(40).collect();
        let message = format!("expected a value without zero bytes, found \"{found}\"");
        let help = "no variable can have one; take it out".to_owned();
        refuse(vec!["env".into(), Step::key(name.clone())], message, Some(help));
    }
    let bytes: usize = file.env.iter().map(|(name, value)| name.len() + value.len()).sum();
    if bytes > MOST {
        let message = format!("expected variables of at most {MOST} bytes together, found {bytes}");
        refuse(vec!["env".into()], message, Some(in_script.to_owned()));
    }
    if file.output.len() > MOST_OF_A_NAME {
        let message = format!(
            "expected the name of a file of at most {MOST_OF_A_NAME} bytes, found {}",
            file.output.len()
        );
        refuse(vec!["output".into()], message, None);
    }
}

#[cfg(test)]
mod tests;
