//! `report`: writes `docs/performance.md` and its plots from the JSON files of
//! the benches.
//!
//! What was not measured is said not to be. Files of other forms than expected
//! are read as far as they go: a field that is missing is a dash in a table.

mod growth;
mod peers;
mod table;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use serde_json::Value;

use crate::machine::Machine;
use crate::place;

/// The document, in the repository.
const DOCUMENT: &str = "docs/performance.md";

/// Flags of `bench report`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The folder with trace.json, image.json, kernels.json, check.json, scaling.json,
    /// skipping.json and error.json, as far as they are there, and with the plots
    /// that were drawn beside them
    #[arg(long, value_name = "DIR")]
    from: PathBuf,
    /// The document; plots go into a folder of its name beside it
    /// [default: docs/performance.md of this repository]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// The part of the document that one bench makes.
#[derive(Debug, Clone, PartialEq, Default)]
struct Section {
    text: String,
    /// Plots, by the name of their file.
    plots: Vec<(String, String)>,
}

/// A bench: its name, a heading, the command that measures it, and what makes a
/// section of its file.
struct Part {
    name: &'static str,
    heading: &'static str,
    command: &'static str,
    section: fn(&Value) -> Section,
}

/// In the order of the document.
const PARTS: [Part; 7] = [
    Part {
        name: "image",
        heading: "Whole pictures: seconds to a given error",
        command: "cargo xtask bench image",
        section: peers::image,
    },
    Part {
        name: "trace",
        heading: "Rays through meshes",
        command: "cargo xtask bench trace",
        section: peers::trace,
    },
    Part {
        name: "error",
        heading: "Kernels: time against error",
        command: "cargo xtask bench error",
        section: peers::error,
    },
    Part {
        name: "kernels",
        heading: "Kernels: time",
        command: "cargo xtask bench kernels",
        section: growth::kernels,
    },
    Part {
        name: "check",
        heading: "A whole check",
        command: "cargo xtask bench check",
        section: growth::check,
    },
    Part {
        name: "scaling",
        heading: "How times grow",
        command: "cargo xtask bench scaling",
        section: growth::scaling,
    },
    Part {
        name: "skipping",
        heading: "What is skipped",
        command: "cargo xtask bench skipping",
        section: growth::skipping,
    },
];

pub(crate) fn run(args: &Args) -> Result<ExitCode, String> {
    let path = match &args.out {
        Some(path) => path.clone(),
        None => place::repository()?.join(DOCUMENT),
    };
    let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("performance").to_owned();
    let files = read(&args.from)?;
    let drawn = drawn(&args.from)?;
    let (text, plots) = document(&stem, &Machine::here(), &files, &drawn);
    let folder = path.with_extension("");
    for (name, svg) in &plots {
        place::write(&folder.join(name), svg)?;
    }
    place::write(&path, &text)?;
    for (part, file) in PARTS.iter().zip(&files) {
        println!("{}: {}", part.name, if file.is_some() { "written" } else { "not measured" });
    }
    println!("wrote {} and {} plots", path.display(), plots.len());
    Ok(ExitCode::SUCCESS)
}

/// The file of each part that is there.
fn read(folder: &Path) -> Result<Vec<Option<Value>>, String> {
    let read = |part: &Part| {
        let path = folder.join(format!("{}.json", part.name));
        let Some(text) = place::text(&path)? else { return Ok(None) };
        let value = serde_json::from_str(&text);
        value.map(Some).map_err(|error| format!("{}: expected JSON: {error}", path.display()))
    };
    let files: Vec<_> = PARTS.iter().map(read).collect::<Result<_, String>>()?;
    if files.iter().all(Option::is_none) {
        let names: Vec<_> = PARTS.iter().map(|part| format!("{}.json", part.name)).collect();
        return Err(format!(
            "{}: expected one at least of {}, found none; each bench writes its own with --json",
            folder.display(),
            names.join(", ")
        ));
    }
    Ok(files)
}

/// The plot that each bench has drawn beside its file, where there is one.
fn drawn(folder: &Path) -> Result<Vec<Option<String>>, String> {
    PARTS.iter().map(|part| place::text(&folder.join(format!("{}.svg", part.name)))).collect()
}

/// The document, and its plots by the names of their files: those of the sections,
/// or what the bench itself has drawn.
fn document(
    stem: &str,
    machine: &Machine,
    files: &[Option<Value>],
    drawn: &[Option<String>],
) -> (String, Vec<(String, String)>) {
    let mut text = format!(
        "# Performance\n\n\
         Written by `cargo xtask bench report`; every number comes from a bench that prints it \
         again.\nWritten on: {}.\n\n\
         Times are medians of interleaved turns, of the processor's clock unless said otherwise; \
         `[a-b]`\nis from the lowest to the highest turn. Compare within a table: its rows took \
         turns in one run.\n",
        machine.sentence()
    );
    let mut plots = Vec::new();
    for ((part, file), drawn) in PARTS.iter().zip(files).zip(drawn) {
        text.extend(["\n## ", part.heading, "\n\n"]);
        let Some(file) = file else {
            text.extend(["Not measured here: `", part.command, "`.\n"]);
            continue;
        };
        text.extend(["`", part.command, "`"]);
        match table::machine(file) {
            Some(machine) => text.extend([" on ", &machine, ".\n"]),
            None => text.push_str(".\n"),
        }
        let mut section = (part.section)(file);
        if let (true, Some(svg)) = (section.plots.is_empty(), drawn) {
            section.plots.push((format!("{}.svg", part.name), svg.clone()));
        }
        for (name, _) in &section.plots {
            let what = name.trim_end_matches(".svg").replace('-', " ");
            text.extend(["\n![", &what, "](", stem, "/", name, ")\n"]);
        }
        text.push_str(&section.text);
        plots.extend(section.plots);
    }
    (text, plots)
}

#[cfg(test)]
mod tests;
