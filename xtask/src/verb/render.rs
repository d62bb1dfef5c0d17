//! `render`: a scene into a picture file.

use std::path::{Path, PathBuf};

use harness::counts::Counts;
use harness::expectation::Rendered;
use harness::fixture::{Build, Fixture, Skipping};
use harness::overrides::{self, Filter, Overrides, Sampler};
use harness::store::FolderAssets;
use harness::suite::{Suite, name_of};
use harness::{golden, picture_file};
use interchange::export::{Dialect, export};
use interchange::import::{Source, Unreadable, Wishes, import};

use crate::{Answer, CannotAsk, Here};

/// Flags of `render`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// A scene file (*.ron, *.json) or a fixture's name
    scene: String,
    /// The picture: .png as stored in goldens, .exr linear
    #[arg(long, value_name = "FILE", required_unless_present_any = ["explain", "stats"])]
    out: Option<PathBuf>,
    /// Add samples until the root mean square error of the linear picture is estimated to be at
    /// most this, in place of those that the scene asks for
    #[arg(long, value_name = "ERROR", conflicts_with_all = ["samples", "sampler"])]
    error: Option<f64>,
    /// Take this many samples in each pixel, in place of those that the scene asks for
    #[arg(long, value_name = "COUNT")]
    samples: Option<u32>,
    /// Spread them by grid, stratified or sobol, the last two with a seed if wanted: sobol:7
    #[arg(long, value_name = "SAMPLER", value_parser = overrides::sampler)]
    sampler: Option<Sampler>,
    /// Weigh them by box, tent, gaussian or mitchell, the last three with a radius if wanted: tent:1
    #[arg(long, value_name = "FILTER", value_parser = overrides::filter)]
    filter: Option<Filter>,
    /// Print what the scene needs and what is skipped
    #[arg(long)]
    explain: bool,
    /// Count rays and tests, and write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
    /// Skip nothing: the same picture, made the long way
    #[arg(long)]
    no_skip: bool,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask render sphere/tangent --out a.png
  cargo xtask render scene.ron --out a.exr --samples 64 --sampler sobol
  cargo xtask render sphere/tangent --explain";

pub(crate) fn run(
    here: &Here,
    Args { scene, out, error, samples, sampler, filter, explain, stats, no_skip }: &Args,
) -> Result<Answer, CannotAsk> {
    let Opened { label, path, mut fixture } = Opened::new(here, scene)?;
    let overrides =
        Overrides { samples: *samples, sampler: *sampler, filter: *filter, error: *error };
    fixture.scene = overrides.apply(&fixture.scene).map_err(CannotAsk)?;
    let to_file = out.as_deref().map(encoder).transpose()?;
    // Before the work of rendering.
    for file in [out, stats].into_iter().flatten() {
        here.may_report(file)?;
    }
    let skipping = if *no_skip { Skipping::Off } else { Skipping::On };
    let plan = fixture.plan(skipping);
    let (linear, counted) = fixture.render_counted(&plan);
    if let Some(path) = stats {
        let counts = Counts::new(label, skipping, &counted);
        let text = serde_json::to_string_pretty(&counts)?;
        here.write(path, format!("{text}\n").as_bytes())?;
        println!("wrote {}", path.display());
    }
    if let (Some(out), Some(to_file)) = (out, to_file) {
        let picture = fixture.encoded(linear).map_err(|why| CannotAsk::file(&path, &why))?;
        let file = to_file(&picture).map_err(|why| CannotAsk::file(out, &why))?;
        here.write(out, &file)?;
        println!("wrote {}", out.display());
    }
    if *explain {
        for note in plan.notes() {
            println!("{note}");
        }
    }
    Ok(Answer::Yes)
}

/// A scene that was named on the command line.
pub(super) struct Opened {
    /// Its name in messages.
    pub(super) label: String,
    pub(super) path: PathBuf,
    pub(super) fixture: Fixture,
}

impl Opened {
    /// The scene file or the fixture of this name.
    ///
    /// # Errors
    /// There is none, or it makes no sense.
    pub(super) fn new(here: &Here, scene: &str) -> Result<Self, CannotAsk> {
        // A fixture has no ending in its name, so what has one is a file.
        let ending = Path::new(scene).extension().and_then(|ending| ending.to_str());
        let (label, path) = if matches!(ending, Some("ron" | "json")) {
            (scene.to_owned(), PathBuf::from(scene))
        } else {
            let suite = here.suite()?;
            // Says what was probably meant where there is no such fixture.
            let selection = suite.select(std::slice::from_ref(&scene.to_owned()))?;
            let is_whole = |name: &&String| *name == scene || *name == name_of(scene);
            let name = selection.fixtures.iter().find(is_whole).ok_or_else(|| {
                CannotAsk(format!(
                    "expected a scene file or a fixture's whole name, found \"{scene}\""
                ))
            })?;
            (Suite::fixture_label(name), suite.fixture_path(name))
        };
        let fixture = if ending == Some("json") {
            from_json(&label, &path)
        } else {
            Fixture::open(&label, &path, Build::default())
        };
        Ok(Self { fixture: fixture.map_err(CannotAsk)?, label, path })
    }
}

/// The fixture of a scene as JSON, without a check.
fn from_json(label: &str, path: &Path) -> Result<Fixture, String> {
    let text = Fixture::text(label, path)?;
    let assets = FolderAssets::beside(path);
    let source = Source { name: label, bytes: text.as_bytes() };
    let scene = import(source, &Wishes::default(), &assets).map_err(|all| {
        let said = all.iter().map(|Unreadable { place, message, help }| {
            let place = place.map_or(String::new(), |(line, column)| format!(":{line}:{column}"));
            let help = help.as_ref().map_or(String::new(), |help| format!("; {help}"));
            format!("{label}{place}: {message}{help}\n")
        });
        said.collect::<String>()
    })?;
    // Its problems are told without their places: those of the text are not the file's.
    let exported = export(Dialect::Ron, &scene.scene, &assets)
        .map_err(|problems| format!("{label}: {problems}\n"))?;
    let text = exported.files.get(&exported.main).map(Vec::as_slice).unwrap_or_default();
    let text = String::from_utf8_lossy(text);
    Fixture::read(label, &text, &assets, Build::default())
}

/// Makes a file of a picture.
type Encoder = fn(&Rendered) -> Result<Vec<u8>, String>;

/// How to make a file with this ending.
fn encoder(out: &Path) -> Result<Encoder, CannotAsk> {
    let ending = out.extension().and_then(|ending| ending.to_str()).unwrap_or("");
    match &*ending.to_ascii_lowercase() {
        "png" => Ok(|picture| golden::to_png(&picture.encoded, None)),
        "exr" => Ok(|picture| picture_file::to_exr(&picture.linear)),
        _ => Err(CannotAsk::file(out, "expected a file that ends in .png or .exr")),
    }
}
