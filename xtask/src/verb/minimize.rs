//! `minimize`: a small fixture of a large one that fails.

use std::path::{Path, PathBuf};
use std::process::Command;

use harness::encode::EncodedImage;
use harness::fixture::{Build, Fixture};
use harness::golden;
use harness::judge::Found;
use harness::minimize::{Failure, minimize};
use harness::run::find_golden;
use harness::store::{self, Scratch};
use harness::suite::{Suite, name_of};
use harness::template::check_name;

use xtask::progress::Progress;
use xtask::{Answer, CannotAsk, Here};

/// Flags of `minimize`.
#[derive(Debug, clap::Args)]
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
    check_name(&out)?;
    let path = suite.fixture_path(&out);
    if store::is_file(&path) {
        return Err(CannotAsk::file(&path, "is there already: name another with --out"));
    }
    let label = Suite::fixture_label(name);
    let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default());
    let fixture = fixture.map_err(CannotAsk)?;
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
    store::write_new(&path, text.as_bytes())?;
    if let Some(expected) = &smallest.expected {
        let label = Suite::fixture_label(&out);
        let small = Fixture::open(&label, &path, Build::default()).map_err(CannotAsk)?;
        let png = golden::smallest_png(expected, &small.provenance).map_err(CannotAsk)?;
        store::write(&suite.golden_path(&out), &png)?;
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

/// Another build of this program.
struct Reference {
    program: PathBuf,
    /// Where a scene is put, with its assets.
    folder: Scratch,
}

impl Reference {
    fn new(program: &Path, fixture: &Fixture) -> Result<Self, CannotAsk> {
        if !store::is_file(program) {
            return Err(CannotAsk::file(program, "expected a program, found no such file"));
        }
        let folder = Scratch::new()?;
        for (name, bytes) in fixture.assets() {
            store::write(&folder.path(name), bytes)?;
        }
        Ok(Self { program: std::path::absolute(program)?, folder })
    }

    /// The picture of a scene.
    fn render(&self, text: &str) -> Result<EncodedImage, String> {
        let (scene, picture) = (self.folder.path("scene.ron"), self.folder.path("picture.png"));
        store::write(&scene, text.as_bytes()).map_err(|error| error.to_string())?;
        let said = Command::new(&self.program)
            .arg("render")
            .arg(&scene)
            .arg("--out")
            .arg(&picture)
            .output()
            .map_err(|error| format!("{}: {error}", self.program.display()))?;
        if !said.status.success() {
            let why = String::from_utf8_lossy(&said.stderr);
            return Err(format!("{}: {}: {}", self.program.display(), said.status, why.trim()));
        }
        match find_golden(&picture) {
            Found::Golden(golden) => Ok(golden.picture),
            Found::Nothing => Err(format!(
                "{} render SCENE --out PICTURE: expected a picture, found none",
                self.program.display()
            )),
            Found::Unreadable(why) => Err(why),
        }
    }
}
