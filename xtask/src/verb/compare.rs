//! `compare`: two picture files by every metric.

use std::path::{Path, PathBuf};

use harness::encode::Transfer;
use harness::metric;
use harness::picture_file::{PictureFile, linear_max_abs};
use harness::report::{comparison_json, comparison_lines};
use harness::store;
use serde_json::json;

use crate::{Answer, CannotAsk};

/// Flags of `compare`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// A PNG, EXR, PFM or PPM file
    golden: PathBuf,
    /// A file of the same size
    actual: PathBuf,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// How linear pictures (EXR, PFM) become 8 bits
    #[arg(long, value_enum, default_value = "gamma22")]
    encoding: Encoding,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask compare golden/sphere/tangent.png a.png
  cargo xtask compare before.exr after.exr --json";

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Encoding {
    Gamma22,
    Srgb,
}

/// The largest picture file that is read, in bytes.
const MAX_BYTES: u64 = 1 << 30;

pub(crate) fn run(args: &Args) -> Result<Answer, CannotAsk> {
    let transfer = match args.encoding {
        Encoding::Gamma22 => Transfer::Gamma22,
        Encoding::Srgb => Transfer::Srgb,
    };
    let read = |path: &Path| {
        let bytes = store::read(path, MAX_BYTES)?;
        let bytes = bytes.ok_or_else(|| CannotAsk::file(path, "there is no such file"))?;
        let file = PictureFile::read(&bytes).map_err(|why| CannotAsk::file(path, &why))?;
        let encoded = file.encoded(transfer).map_err(|why| CannotAsk::file(path, &why))?;
        Ok::<_, CannotAsk>((file, encoded))
    };
    let (golden_file, golden) = read(&args.golden)?;
    let (actual_file, actual) = read(&args.actual)?;
    let comparison = metric::compare(&golden, &actual).ok_or_else(|| {
        let size =
            |p: &harness::encode::EncodedImage| format!("{} x {}", p.size().width, p.size().height);
        let what = format!("expected a picture of {}, found {}", size(&golden), size(&actual));
        CannotAsk::file(&args.actual, &what)
    })?;
    let linear = match (&golden_file, &actual_file) {
        (PictureFile::Linear(a), PictureFile::Linear(b)) => linear_max_abs(a, b),
        _ => None,
    };
    if args.json {
        let mut document = comparison_json(&comparison);
        document["linear_max_abs"] = json!(linear);
        println!("{}", serde_json::to_string_pretty(&document)?);
    } else {
        print!("{}", comparison_lines(&comparison));
        if let Some(linear) = linear {
            println!("{:<22} {linear:e}", "linear_max_abs");
        }
    }
    let same = comparison.is_identical() && linear.is_none_or(|linear| linear == 0.0);
    Ok(if same { Answer::Yes } else { Answer::No })
}
