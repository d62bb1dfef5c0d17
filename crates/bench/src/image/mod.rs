//! `image`: seconds to a picture of a given error, goldray beside POV-Ray and
//! Mitsuba 3.
//!
//! All renderers are given the same scenes. Each setting of each is tried once;
//! those that tell how long an error takes are then measured in turns.

mod curve;
mod engine;
mod export;
mod picture;
mod plot;
mod report;
mod scenes;
mod sweep;
mod table;
mod truth;

use std::collections::BTreeMap;
use std::path::PathBuf;

use tracer::LinearImage;

use crate::files;
use crate::machine::Machine;
use curve::telling;
use engine::{Engine, OURS, PEERS, Setting, Stage};
use report::{OfScene, Report, Row, TARGETS, mark_frontier, ratios, reached};
use sweep::{Limits, Trial, sweep, sweep_once};

/// Flags of `bench image`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Which scenes, with commas between; all if not given
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    scenes: Vec<String>,
    /// Which engines, with commas between; all that are installed if not given
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    engines: Vec<String>,
    /// How often each setting is measured, in turns
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..))]
    reps: u32,
    /// No setting is tried that is expected to take more seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    longest: f64,
    /// Try the settings of other renderers again, not only those that told most before
    #[arg(long)]
    again: bool,
    /// goldray only, small pictures, once: seconds in all
    #[arg(long)]
    quick: bool,
    /// Only list the scenes and engines
    #[arg(long)]
    list: bool,
    /// Also write the numbers as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draw seconds against error, a panel for each scene
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

/// The scenes of `--quick`, if none is named, and its size.
const QUICK_SCENES: [&str; 3] = ["disk", "balls", "knot-smooth"];
const QUICK: (u32, u32) = (64, 48);
/// The seconds of its longest setting.
const QUICK_LONGEST: f64 = 0.1;
/// Below the smallest error asked for by this factor, no better one is tried.
const BELOW: f64 = 0.9;

pub(crate) fn run(args: &Args) -> Result<(), String> {
    let sources = scenes::all();
    let names: Vec<_> = sources.iter().map(|source| source.name).collect();
    if args.list {
        for source in &sources {
            println!("scene   {:<22} {}", source.name, source.about);
        }
        for (all, whose) in [(&OURS[..], "goldray"), (&PEERS[..], "peer")] {
            for name in all {
                println!("engine  {name:<22} {whose}");
            }
        }
        return Ok(());
    }
    let chosen = match args.scenes[..] {
        [] if args.quick => QUICK_SCENES.to_vec(),
        _ => choose("--scenes", &args.scenes, &names)?,
    };
    let all = if args.quick { OURS.to_vec() } else { [&OURS[..], &PEERS[..]].concat() };
    let wanted = choose("--engines", &args.engines, &all)?;
    let (mut engines, missing) = engine::find(&wanted);
    for (name, why) in &missing {
        eprintln!("missing: {name}: {why}");
    }
    if engines.is_empty() {
        return Err("--engines: none of those that are wanted is there".into());
    }
    let mut report = Report {
        schema: 1,
        error: Report::ERROR,
        time: Report::TIME,
        machine: Machine::here().cpu,
        versions: engines.iter().map(|one| (one.name().to_owned(), one.version())).collect(),
        missing,
        scenes: Vec::new(),
        rows: Vec::new(),
        reached: Vec::new(),
        ratios: Vec::new(),
    };
    let mut pictures = BTreeMap::new();
    // Before minutes of measuring: a path that cannot be written is told at once.
    write(&report, &pictures, args)?;
    for source in sources.into_iter().filter(|source| chosen.contains(&source.name)) {
        let stage = Stage::new(source, args.quick.then_some(QUICK))?;
        let (of_scene, mut rows, truth) = measure(&stage, &mut engines, args)?;
        mark_frontier(&mut rows);
        report.reached.extend(reached(&rows));
        report.rows.extend(rows);
        pictures.insert(of_scene.scene.clone(), truth);
        report.scenes.push(of_scene);
        report.ratios = ratios(&report.reached, OURS[0]);
        // After each scene: nothing is lost if it ends early.
        write(&report, &pictures, args)?;
    }
    print!("{}", table::text(&report));
    Ok(())
}

/// Writes the files that were asked for.
fn write(
    report: &Report,
    pictures: &BTreeMap<String, LinearImage>,
    args: &Args,
) -> Result<(), String> {
    if let Some(path) = &args.json {
        let text = serde_json::to_string_pretty(report).map_err(|why| why.to_string())?;
        files::write(path, format!("{text}\n").as_bytes())?;
    }
    if let Some(path) = &args.svg {
        files::write(path, plot::svg(report, pictures)?.as_bytes())?;
    }
    Ok(())
}

/// Those of the known names that are wanted, in their own order; all if none is.
fn choose<'a>(flag: &str, wanted: &[String], known: &[&'a str]) -> Result<Vec<&'a str>, String> {
    if let Some(other) = wanted.iter().find(|name| !known.contains(&name.as_str())) {
        let known = known.join(", ");
        return Err(format!("{flag}: expected some of {known}, found \"{other}\""));
    }
    let is_wanted = |name: &&str| wanted.is_empty() || wanted.iter().any(|one| one == name);
    Ok(known.iter().copied().filter(is_wanted).collect())
}

/// All engines on one scene.
fn measure(
    stage: &Stage,
    engines: &mut [Box<dyn Engine>],
    args: &Args,
) -> Result<(OfScene, Vec<Row>, LinearImage), String> {
    let name = stage.source.name;
    eprintln!("{name}: finding the truth");
    let truth = truth::kept(&stage.folder, name, &stage.read.accurate, || {
        if stage.source.is_disk {
            truth::disk(&stage.read)
        } else {
            Ok(truth::integrated(&stage.read.accurate))
        }
    })?;
    stage.export()?;
    let limits = Limits {
        longest: if args.quick { QUICK_LONGEST } else { args.longest },
        rmse: TARGETS[TARGETS.len() - 1] * BELOW,
    };
    let mut jobs: Vec<(usize, Setting)> = Vec::new();
    let mut closest = BTreeMap::new();
    for (k, engine) in engines.iter_mut().enumerate() {
        if engine.is_redundant(stage) {
            continue;
        }
        eprintln!("{name}: trying {}", engine.name());
        let trials = if OURS.contains(&engine.name()) {
            sweep(&mut **engine, stage, &truth, limits)?
        } else {
            sweep_once(&mut **engine, stage, &truth, limits, args.again)?
        };
        let points: Vec<_> = trials.iter().map(|trial| trial.point).collect();
        let least = points.iter().map(|point| point.rmse).fold(f64::INFINITY, f64::min);
        closest.insert(engine.name().to_owned(), least);
        let telling = telling(&points, &TARGETS).into_iter();
        jobs.extend(
            telling
                .map(|i| (k, <[Trial]>::get(&trials, i).map(|t| t.setting)))
                .filter_map(|(k, setting)| setting.map(|setting| (k, setting))),
        );
    }
    let rows = in_turns(stage, engines, &jobs, &truth, if args.quick { 1 } else { args.reps })?;
    let (width, height) = stage.read.file.image;
    let truth_is = if stage.source.is_disk { "a formula" } else { "integrated" };
    let of_scene = OfScene {
        scene: name.to_owned(),
        about: stage.source.about.to_owned(),
        image: (width, height),
        truth: truth_is,
        closest,
    };
    Ok((of_scene, rows, truth))
}

/// Measures these settings in turns: in each repetition another one begins, so
/// that a slow spell of the machine meets all alike.
fn in_turns(
    stage: &Stage,
    engines: &mut [Box<dyn Engine>],
    jobs: &[(usize, Setting)],
    truth: &LinearImage,
    repetitions: u32,
) -> Result<Vec<Row>, String> {
    let mut seconds = vec![Vec::new(); jobs.len()];
    let mut errors = vec![0.0; jobs.len()];
    for repetition in 0..repetitions as usize {
        eprintln!("{}: repetition {} of {repetitions}", stage.source.name, repetition + 1);
        for turn in 0..jobs.len() {
            let j = (turn + repetition) % jobs.len();
            let (k, setting) = jobs[j];
            let shot = engines[k].shoot(stage, setting)?;
            seconds[j].push(shot.seconds);
            errors[j] = picture::rmse(&shot.picture, truth);
        }
    }
    let row = |((&(k, setting), mut seconds), rmse): ((&(usize, Setting), Vec<f64>), f64)| {
        seconds.sort_by(f64::total_cmp);
        Row {
            scene: stage.source.name.to_owned(),
            engine: engines[k].name().to_owned(),
            setting: setting.to_string(),
            seconds: median(&seconds),
            spread: (seconds[0], seconds[seconds.len() - 1]),
            repetitions: seconds.len(),
            rmse,
            frontier: false,
        }
    };
    Ok(jobs.iter().zip(seconds).zip(errors).map(row).collect())
}

/// The middle of sorted numbers, of which there is at least one.
fn median(sorted: &[f64]) -> f64 {
    let n = sorted.len();
    f64::midpoint(sorted[(n - 1) / 2], sorted[n / 2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_chosen_in_their_own_order_or_refused() {
        let known = ["a", "b", "c"];
        let choose = |wanted: &[&str]| {
            let wanted: Vec<_> = wanted.iter().map(|name| (*name).to_owned()).collect();
            super::choose("--scenes", &wanted, &known)
        };
        assert_eq!(choose(&[]).unwrap(), known);
        assert_eq!(choose(&["c", "a"]).unwrap(), ["a", "c"]);
        let why = choose(&["a", "d"]).unwrap_err();
        assert_eq!(why, "--scenes: expected some of a, b, c, found \"d\"");
    }

    #[test]
    fn the_quick_scenes_are_there() {
        let known: Vec<_> = scenes::all().iter().map(|source| source.name).collect();
        assert!(QUICK_SCENES.iter().all(|name| known.contains(name)));
    }

    #[test]
    fn medians_of_odd_and_even_counts() {
        assert_eq!(median(&[1.0, 2.0, 9.0]), 2.0);
        assert_eq!(median(&[1.0, 2.0, 4.0, 9.0]), 3.0);
        assert_eq!(median(&[3.0]), 3.0);
    }
}
