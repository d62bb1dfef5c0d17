//! `render`: a scene into a picture file.

use std::path::{Path, PathBuf};

use harness::expectation::Rendered;
use harness::fixture::{Build, Fixture};
use harness::suite::{Suite, name_of};
use harness::{golden, picture_file};

use crate::{Answer, CannotAsk, Here};

/// Flags of `render`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// A scene file (*.ron) or a fixture's name
    scene: String,
    /// The picture: .png as stored in goldens, .exr linear
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

pub(crate) fn run(here: &Here, Args { scene, out }: &Args) -> Result<Answer, CannotAsk> {
    // A fixture has no ending in its name, so what has one is a file.
    let (label, path) = if Path::new(scene).extension().is_some_and(|e| e == "ron") {
        (scene.clone(), PathBuf::from(scene))
    } else {
        let (suite, name) = (here.suite()?, name_of(scene));
        // Says what was probably meant where there is no such fixture.
        let selection = suite.select(&[name.to_owned()])?;
        if !selection.fixtures.iter().any(|fixture| fixture == name) {
            let what =
                format!("expected a scene file or a fixture's whole name, found \"{scene}\"");
            return Err(CannotAsk(what));
        }
        (Suite::fixture_label(name), suite.fixture_path(name))
    };
    let fixture = Fixture::open(&label, &path, Build::default()).map_err(CannotAsk)?;
    let ending = out.extension().and_then(|ending| ending.to_str()).unwrap_or("");
    let to_file: fn(&Rendered) -> Result<Vec<u8>, String> = match &*ending.to_ascii_lowercase() {
        "png" => |picture| golden::to_png(&picture.encoded, None),
        "exr" => |picture| picture_file::to_exr(&picture.linear),
        _ => return Err(CannotAsk::file(out, "expected a file that ends in .png or .exr")),
    };
    let picture = fixture.render().map_err(|why| CannotAsk::file(&path, &why))?;
    let file = to_file(&picture).map_err(|why| CannotAsk::file(out, &why))?;
    here.write(out, &file)?;
    println!("wrote {}", out.display());
    Ok(Answer::Yes)
}
