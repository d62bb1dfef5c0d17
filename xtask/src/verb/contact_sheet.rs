//! `contact-sheet`: all goldens on one sheet.

use std::path::PathBuf;

use harness::suite::Suite;
use harness::{golden, picture, run, store};

use crate::{Answer, CannotAsk};

/// Flags of `contact-sheet`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// The sheet [default: docs/contact-sheet.png of the suite]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

pub(crate) fn run(suite: &Suite, Args { filters, out }: &Args) -> Result<Answer, CannotAsk> {
    let selection = suite.select(filters)?;
    let mut pictures = Vec::new();
    for name in selection.fixtures {
        let path = suite.golden_path(&name);
        match run::find_golden(&path).picture() {
            Some(picture) => pictures.push((name, picture.clone())),
            None => return Err(CannotAsk::file(&path, "expected a golden: run check first")),
        }
    }
    let sheet = picture::contact_sheet(&pictures);
    let out = out.clone().unwrap_or_else(|| suite.root().join("docs/contact-sheet.png"));
    let png = golden::to_png(&sheet, None).map_err(|why| CannotAsk::file(&out, &why))?;
    store::write(&out, &png)?;
    println!("{} goldens on {}", pictures.len(), out.display());
    Ok(Answer::Yes)
}
