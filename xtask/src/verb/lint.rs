//! `lint`: fixtures that would match where they should not.

use std::path::PathBuf;

use harness::lint::{self, finding_line, findings_json, rule_lines};
use harness::sensitivity::Visible;

use crate::progress::Progress;
use crate::{Answer, CannotAsk, Here};

/// Flags of `lint`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Which fixtures; all if none is given
    #[arg(value_name = "FILTER")]
    filters: Vec<String>,
    /// Also write the findings to this file as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// From which strength on people see a defect: gain=2, or change=4 for the codes that any needs
    #[arg(long, value_name = "DEFECT=STRENGTH")]
    visible: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask lint                      every fixture
  cargo xtask lint torus --json l.json  some, also for machines
  cargo xtask lint --visible gain=2     with another idea of what people see";

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let visible =
        Visible::from_texts(&args.visible).map_err(|why| CannotAsk(format!("--visible: {why}")))?;
    if let Some(path) = &args.json {
        here.may_report(path)?;
    }
    let suite = here.suite()?;
    let names = Here::fixtures(&suite, &args.filters)?;
    let progress = Progress::start("linting", names.len());
    let findings = lint::lint(&suite, &names, &visible, &|name| progress.advance(name));
    progress.finish();
    let findings = findings.map_err(CannotAsk)?;

    let reader = here.reader(&suite);
    for finding in &findings {
        println!("{}", finding_line(finding, &reader.path_prefix));
    }
    print!("{}", rule_lines(&findings));
    let plural = if findings.len() == 1 { "" } else { "s" };
    println!("{} linted: {} finding{plural}", names.len(), findings.len());
    if let Some(path) = &args.json {
        let json = serde_json::to_string_pretty(&findings_json(&findings))?;
        here.write(path, format!("{json}\n").as_bytes())?;
    }
    Ok(if findings.is_empty() { Answer::Yes } else { Answer::No })
}
