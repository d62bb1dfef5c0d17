//! `minimize`: a small fixture of a large one that fails.

use std::path::PathBuf;

use harness::fixture::{Build, Fixture};
use harness::golden;
use harness::minimize::{Failure, minimize};
use harness::store;
use harness::suite::{Suite, name_of};
use harness::template::check_name;

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

use super::reference::Reference;

/// Flags of `minimize`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The fixture, by its name or path
    #[arg(value_name = "NAME")]
    name: String,
    /// A build of this program that is right, such as the one before a change: what its `render`
    /// makes of a scene is what the picture should be [default: a relation that the fixture breaks]
    #[arg(long, value_name = "PROGRAM")]
    reference: Option<PathBuf>,
    /// The name of the new fixture [default: NAME-minimized]
    #[arg(long, value_name = "NAME")]
    out: Option<String>,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask minimize mesh/large       while it breaks a relation
  cargo xtask minimize mesh/large --reference ../before/program
                                        while its picture is not that program's";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    // Writes a golden, if it is told what is right.
    if args.reference.is_some() && std::env::var_os("CI").is_some() {
        let what = "minimize --reference: expected to run by hand, found the variable CI set";
        return Err(CannotAsk(what.to_owned()));
    }
    let suite = here.suite()?;
    let name = name_of(&args.name);
    let out =
        args.out.as_deref().map_or(format!("{name}-minimized"), |out| name_of(out).to_owned());
    check_name(&out).map_err(|error| CannotAsk(format!("{error}: name one with --out")))?;
    let (path, golden_path) = (suite.fixture_path(&out), suite.golden_path(&out));
    for path in [&path, &golden_path] {
        if path.exists() {
            return Err(CannotAsk::file(path, "is there already: name another with --out"));
        }
    }
    let label = Suite::fixture_label(name);
    let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default());
    let fixture = fixture.map_err(CannotAsk)?;
    if !fixture.assets().is_empty() && folder_of(&out) != folder_of(name) {
        return Err(CannotAsk(format!(
            "--out: expected a name beside {name}, whose scene names files there, found \"{out}\""
        )));
    }
    let reference = args.reference.as_deref().map(|program| Reference::new(program, &fixture));
    let reference = reference.transpose()?;
    let render = |text: &str| match &reference {
        Some(reference) => reference.render(text),
        None => Err("no other renderer was named".to_owned()),
    };
    let progress = Progress::counting("minimizing");
    let failure = match &reference {
        Some(_) => Some(Failure::Reference(&render)),
        None => Failure::of(&fixture, &|relation| progress.advance(relation)),
    };
    let Some(failure) = failure else {
        progress.finish();
        println!(
            "{name} breaks no relation, so nothing of it can be said to fail without its golden: \
             name a build that is right, such as target/release/xtask of the commit before, with \
             --reference PROGRAM"
        );
        return Ok(Answer::No);
    };
    let smallest = minimize(&fixture, &failure, &|objects, pixels| {
        progress.advance(&format!("{objects} objects, {pixels} pixels"));
    });
    progress.finish();
    let Some(smallest) = smallest.map_err(CannotAsk)? else {
        println!("{name} does not fail: its picture is that of the other renderer");
        return Ok(Answer::No);
    };
    let text = smallest.text(name).map_err(CannotAsk)?;
    // Nothing is written that could not be read again.
    let label = Suite::fixture_label(&out);
    let small = Fixture::read(&label, &text, fixture.assets(), Build::default());
    let small = small.map_err(CannotAsk)?;
    let golden = smallest
        .expected
        .as_ref()
        .map(|expected| golden::smallest_png(expected, &small.provenance).map_err(CannotAsk));
    let golden = golden.transpose()?;
    store::write_new(&path, text.as_bytes())?;
    if let Some(png) = golden {
        store::write_new(&golden_path, &png)?;
    }
    let (width, height) = smallest.file.image;
    let golden = match &smallest.expected {
        Some(_) => format!(", and golden/{out}.png as the other program has it"),
        None => String::new(),
    };
    println!(
        "wrote {}{golden}: {width} x {height} pixels after {} tries; it fails by this: {}",
        Suite::fixture_label(&out),
        smallest.tries,
        smallest.why
    );
    Ok(Answer::Yes)
}

/// The folder that a name is in.
fn folder_of(name: &str) -> &str {
    name.rsplit_once('/').map_or("", |(folder, _)| folder)
}
