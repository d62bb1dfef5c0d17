//! `contact-sheet`: all goldens on one sheet.

use std::path::PathBuf;

use harness::called::command;
use harness::suite::Suite;
use harness::{golden, picture, run};

use crate::{Answer, CannotAsk, Here};

/// Flags of `contact-sheet`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures, on a sheet of their own; all if none is given
    #[arg(value_name = "FILTER", requires = "out")]
    filters: Vec<String>,
    /// The sheet [default: docs/contact-sheet.png of the suite]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask contact-sheet                         redraws docs/contact-sheet.png
  cargo xtask contact-sheet torus --out torus.png   a sheet of a few";

pub(crate) fn run(here: &Here, Args { filters, out }: &Args) -> Result<Answer, CannotAsk> {
    let suite = here.suite()?;
    let selection = suite.select(filters)?;
    let mut pictures = Vec::new();
    for name in selection.fixtures {
        let path = suite.golden_path(&name);
        match run::find_golden(&path).picture() {
            Some(picture) => pictures.push((name, picture.clone())),
            None => {
                return Err(CannotAsk::file(
                    &path,
                    &format!("expected a golden: {} bless writes it", command()),
                ));
            }
        }
    }
    let sheet = picture::contact_sheet(&pictures);
    let out = out.clone().unwrap_or_else(|| suite.root().join(Suite::CONTACT_SHEET));
    let png = golden::to_png(&sheet, None).map_err(|why| CannotAsk::file(&out, &why))?;
    here.write(&out, &png)?;
    println!("{} goldens on {}", pictures.len(), out.display());
    Ok(Answer::Yes)
}
