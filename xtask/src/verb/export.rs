//! `export`: a scene in the language of another renderer.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser as _;
use harness::store;
use interchange::export::{Dialect, Exported, NotWritten, export};

use super::render::Opened;
use crate::{Answer, CannotAsk, Here};

/// Flags of `export`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// A scene file (*.ron, *.json) or a fixture's name
    scene: String,
    /// The language to write it in
    #[arg(long, value_name = "DIALECT", ignore_case = true, value_parser = dialects())]
    to: Dialect,
    /// The folder to write it into; other files there stay
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const EXAMPLES: &str = "\
Exits 1 where the language has no words for what the scene asks for, and says what that is:
then nothing is written.

Examples:
  cargo xtask export sphere/tangent --to PovRay --out tangent
  cargo xtask export scene.ron --to Mitsuba --out mitsuba-scene
  cargo xtask export scene.json --to Ron --out scene";

fn dialects() -> impl clap::builder::TypedValueParser<Value = Dialect> {
    let names = Dialect::ALL.iter().map(|dialect| dialect.name());
    PossibleValuesParser::new(names).try_map(|name| {
        let named = |dialect: &&Dialect| dialect.name().eq_ignore_ascii_case(&name);
        Dialect::ALL.iter().find(named).copied().ok_or("expected the name of a dialect")
    })
}

pub(crate) fn run(here: &Here, Args { scene, to, out }: &Args) -> Result<Answer, CannotAsk> {
    let opened = Opened::new(here, scene)?;
    let exported = match export(*to, &opened.fixture.scene_file(), opened.fixture.assets()) {
        Ok(exported) => exported,
        Err(NotWritten::Cannot(features)) => {
            println!("{}: {to} has {}", opened.label, NotWritten::Cannot(features));
            return Ok(Answer::No);
        }
        Err(NotWritten::Bad(why)) => return Err(CannotAsk(format!("{}: {why}", opened.label))),
    };
    write(here, out, &exported)?;
    for note in notes(&exported) {
        println!("{note}");
    }
    Ok(Answer::Yes)
}

/// Writes all files, or none where one would be written over another file.
fn write(here: &Here, out: &Path, exported: &Exported) -> Result<(), CannotAsk> {
    for (name, bytes) in &exported.files {
        let path = out.join(name);
        here.may_write(&path)?;
        // One byte more than ours is enough to tell that it is another.
        let there = store::read(&path, bytes.len() as u64 + 1);
        let is_free = matches!(&there, Ok(None)) || matches!(&there, Ok(Some(old)) if old == bytes);
        if !is_free {
            let what = "expected no such file, or the very same: remove it, or name another folder";
            return Err(CannotAsk::file(&path, what));
        }
    }
    for (name, bytes) in &exported.files {
        let path = out.join(name);
        here.write(&path, bytes)?;
        println!("wrote {}", path.display());
    }
    Ok(())
}

/// What whoever renders it must know besides.
fn notes(exported: &Exported) -> Vec<String> {
    let mut notes = Vec::new();
    if exported.grid > 1 {
        let side = exported.grid;
        notes.push(format!(
            "its samples: render it {side} times as wide and as high, and take the mean of each \
             {side} x {side} pixels"
        ));
    }
    if !exported.beside.is_empty() {
        let names: Vec<_> = exported.beside.iter().map(|feature| feature.name()).collect();
        notes.push(format!("not in the files, and to be said beside them: {}", names.join(", ")));
    }
    notes
}
