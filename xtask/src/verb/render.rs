//! `render`: a scene into a picture file.

use std::path::{Path, PathBuf};

use harness::fixture::{Build, Fixture};
use harness::suite::Suite;
use harness::{golden, picture_file, store};

use crate::{Answer, CannotAsk};

/// Flags of `render`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// A scene file (*.ron) or a fixture's name
    scene: String,
    /// The picture: .png as stored in goldens, .exr linear
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

pub(crate) fn run(
    suite: impl FnOnce() -> Result<Suite, CannotAsk>,
    Args { scene, out }: &Args,
) -> Result<Answer, CannotAsk> {
    let is_file = Path::new(scene).extension().is_some_and(|ending| ending == "ron");
    let (label, path) = if is_file {
        (scene.clone(), PathBuf::from(scene))
    } else {
        (Suite::fixture_label(scene), suite()?.fixture_path(scene))
    };
    let fixture = Fixture::open(&label, &path, Build::default()).map_err(CannotAsk)?;
    let ending = out.extension().and_then(|ending| ending.to_str()).unwrap_or("");
    let file = match ending.to_ascii_lowercase().as_str() {
        "png" => {
            let picture = fixture.render().map_err(|why| CannotAsk::file(&path, &why))?;
            golden::to_png(&picture.encoded, None)
        }
        "exr" => picture_file::to_exr(&fixture.render_linear()),
        _ => {
            return Err(CannotAsk::file(out, "expected a file that ends in .png or .exr"));
        }
    };
    let file = file.map_err(|why| CannotAsk::file(out, &why))?;
    store::write(out, &file)?;
    Ok(Answer::Yes)
}
