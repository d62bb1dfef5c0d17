//! `sensitivity`: the smallest damage that each fixture would notice.

use std::path::{Path, PathBuf};

use harness::block;
use harness::called::command;
use harness::case::Case;
use harness::encode::EncodedImage;
use harness::golden;
use harness::picture::{Heat, heat_map};
use harness::sensitivity::{self, Cell, DEFECTS, Row, Smallest, Visible};

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

/// Flags of `sensitivity`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write everything to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draw it: fixtures by defects, warm where something may be seen that is not caught
    #[arg(long, value_name = "FILE.png")]
    picture: Option<PathBuf>,
    /// Also write the summary into this file of Markdown, between its two marks
    #[arg(long, value_name = "FILE")]
    markdown: Option<PathBuf>,
    /// Say whether the summary in this file of Markdown is today's
    #[arg(long, value_name = "FILE", conflicts_with = "markdown")]
    check: Option<PathBuf>,
    /// From which strength on people see a defect: gain=2, or change=4 for the codes that any needs
    #[arg(long, value_name = "DEFECT=STRENGTH")]
    visible: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask sensitivity torus                     the smallest damage that is caught
  cargo xtask sensitivity --picture s.png           drawn, fixtures by defects
  cargo xtask sensitivity --markdown docs/trust.md  rewrite the summary";

/// What marks the summary in a file of Markdown.
const MARK: &str = "sensitivity";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let visible =
        Visible::from_texts(&args.visible).map_err(|why| CannotAsk(format!("--visible: {why}")))?;
    let files = [&args.json, &args.picture, &args.markdown];
    for path in files.into_iter().flatten() {
        here.may_report(path)?;
    }
    let suite = here.suite()?;
    let names = Here::fixtures(&suite, &args.filters)?;
    let cases = names.iter().map(|name| Case::open(&suite, name)).collect::<Result<Vec<_>, _>>();
    let cases = cases.map_err(CannotAsk)?;
    let progress = Progress::start("damaging", cases.len());
    let rows = sensitivity::of_cases(&cases, &visible, &|name| progress.advance(name));
    progress.finish();

    let summary = sensitivity::summarize(&rows);
    let text = sensitivity::markdown(&rows, &summary, &visible);
    if let Some(path) = &args.json {
        let json = serde_json::to_string_pretty(&sensitivity::json(&rows, &summary, &visible))?;
        here.write(path, format!("{json}\n").as_bytes())?;
    }
    if let Some(path) = &args.picture {
        let png = golden::to_png(&picture(&rows), None);
        here.write(path, &png.map_err(|why| CannotAsk::file(path, &why))?)?;
    }
    if let Some(path) = &args.check {
        return check(path, &text);
    }
    print!(
        "{}\n{}",
        sensitivity::fixture_lines(&rows),
        sensitivity::summary_lines(&summary, &visible)
    );
    if let Some(path) = &args.markdown {
        let whole = block::read(path).and_then(|whole| block::replaced(&whole, MARK, &text));
        here.write(path, whole.map_err(|why| CannotAsk::file(path, &why))?.as_bytes())?;
    }
    Ok(Answer::Yes)
}

fn check(path: &Path, text: &str) -> Result<Answer, CannotAsk> {
    let whole = block::read(path).map_err(|why| CannotAsk::file(path, &why))?;
    let today = block::replaced(&whole, MARK, text).map_err(|why| CannotAsk::file(path, &why))?;
    let path = path.display();
    if today == whole {
        println!("{path} says what is measured");
        return Ok(Answer::Yes);
    }
    println!("{path} is out of date: {} sensitivity --markdown {path}", command());
    Ok(Answer::No)
}

/// What stands above the picture.
const CAPTION: &str =
    "The smallest damage that is caught; warm: less of it is seen than is caught.";

fn picture(rows: &[Row]) -> EncodedImage {
    let titles: Vec<_> = DEFECTS.iter().map(|defect| [defect.name, defect.unit]).collect();
    let cells = |row: &Row| {
        let cell = |cell: &Cell| Heat {
            text: match cell.smallest {
                Smallest::NoEffect => "no effect".to_owned(),
                Smallest::Never { .. } => "never".to_owned(),
                Smallest::Caught { strength, .. } => sensitivity::number(strength),
            },
            heat: cell.times_visible,
        };
        (row.fixture.clone(), row.cells.iter().map(cell).collect())
    };
    heat_map(CAPTION, &titles, &rows.iter().map(cells).collect::<Vec<_>>())
}
