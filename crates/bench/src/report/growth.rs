//! The sections about goldray alone: kernels, a check, growth, skipping.

use std::fmt::Write as _;

use serde::de::DeserializeOwned;
use serde_json::Value;

use super::Section;
use super::table::{number, rows, shown, table, text};
use crate::measure::Spread;
use crate::{check, kernels, scaling};

/// A file as its bench writes it; `None` for one of another version.
fn known<T: DeserializeOwned>(file: &Value) -> Option<T> {
    serde_json::from_value(file.clone()).ok()
}

fn of_another_version() -> Section {
    let text = "\nThe file is of another form than this version of the bench writes.\n";
    Section { text: text.to_owned(), plots: Vec::new() }
}

/// A median with its ends.
fn spread(of: Spread) -> String {
    let [median, low, high] = [of.median, of.low, of.high].map(|x| shown(Some(x)));
    format!("{median} [{low}-{high}]")
}

pub(super) fn kernels(file: &Value) -> Section {
    let Some(report) = known::<kernels::Report>(file) else { return of_another_version() };
    let line = |row: &kernels::Row| vec![format!("{} {}", row.group, row.name), spread(row.ns)];
    let lines: Vec<_> = report.rows.iter().map(line).collect();
    let text = "\nWhat leaves a flat shape cannot meet it again, so there is nothing to compute.\n";
    Section {
        text: format!("{text}{}", table(&["test", "ns"], &lines)),
        plots: vec![("kernels.svg".to_owned(), kernels::svg(&report))],
    }
}

pub(super) fn check(file: &Value) -> Section {
    let Some(report) = known::<check::Report>(file) else { return of_another_version() };
    let check::Whole { fixtures, wall_ms, processor_ms, .. } = &report.whole;
    let mut text = format!(
        "\n{fixtures} fixtures: {} a second by the wall's clock, {} ms of it and {} ms of the \
         processor's.\n\nNext bottleneck: {}.\n",
        spread(report.fixtures_a_second()),
        spread(*wall_ms),
        spread(*processor_ms),
        report.bottleneck()
    );
    let stage = |stage: &check::Stage| {
        vec![stage.name.clone(), spread(stage.ms), format!("{:.1} %", stage.share * 100.0)]
    };
    let stages: Vec<_> = report.stages.iter().map(stage).collect();
    text.push_str(&table(&["stage, on one thread", "ms", "share"], &stages));
    let slow =
        |slow: &check::Slow| vec![slow.fixture.clone(), shown(Some(slow.ms)), slow.stage.clone()];
    let slowest: Vec<_> = report.slowest.iter().map(slow).collect();
    text.push_str(&table(&["slowest fixtures", "ms", "mostly"], &slowest));
    let rate = |row: &check::Throughput| vec![row.name.clone(), spread(row.mpix_s)];
    let rates: Vec<_> = report.throughput.iter().map(rate).collect();
    text.push_str(&table(&["pictures", "MPix/s"], &rates));
    Section { text, plots: vec![("check.svg".to_owned(), check::svg(&report))] }
}

pub(super) fn scaling(file: &Value) -> Section {
    let Some(report) = known::<scaling::Report>(file) else { return of_another_version() };
    let line = |sweep: &scaling::Sweep| {
        let end = |point: Option<&scaling::Point>| {
            point.map_or("-".to_owned(), |p| format!("{} at {}", spread(p.time), p.size))
        };
        vec![
            format!("{}: {}, {}", sweep.over, sweep.name, sweep.unit),
            sweep.slope_text(),
            end(sweep.points.first()),
            end(sweep.points.last()),
        ]
    };
    let lines: Vec<_> = report.sweeps.iter().map(line).collect();
    let mut text = table(&["over", "slope", "first", "last"], &lines);
    let of = |threads: &scaling::Threads| {
        vec![
            threads.count.to_string(),
            spread(threads.wall),
            spread(threads.processor),
            spread(threads.speedup),
            spread(threads.overhead),
        ]
    };
    let threads: Vec<_> = report.threads.iter().map(of).collect();
    let heads = ["threads", "wall, s", "processor, s", "times as fast", "times the processor"];
    text.push_str(&table(&heads, &threads));
    text.push_str(
        "\nA slope is the exponent of the growth, by least squares over all sizes. The wall's \
         clock is\nanother program's as well: where others ran beside, two threads seem slower \
         than they are.\n",
    );
    Section { text, plots: vec![("scaling.svg".to_owned(), scaling::svg(&report))] }
}

/// Sums over all scenes, and whether any picture changes.
pub(super) fn skipping(file: &Value) -> Section {
    let all = rows(file, "rows");
    let sum = |side: &str, key: &str| -> f64 {
        all.iter().filter_map(|row| number(row.get(side)?, key)).sum()
    };
    let mut keys: Vec<_> = Vec::new();
    for side in ["without", "with"] {
        let fields = all.iter().filter_map(|row| row.get(side)?.as_object());
        for key in fields.flat_map(serde_json::Map::keys) {
            if !keys.contains(key) {
                keys.push(key.clone());
            }
        }
    }
    let line = |key: &String| {
        let (with, without) = (sum("with", key), sum("without", key));
        let share = (without > 0.0).then(|| with / without);
        vec![
            key.replace('_', " "),
            format!("{with:.0}"),
            format!("{without:.0}"),
            share.map_or("-".to_owned(), |share| format!("{:.0} %", share * 100.0)),
        ]
    };
    let lines: Vec<_> = keys.iter().map(line).collect();
    let same = all.iter().filter(|row| row["same_bits"].as_bool() == Some(true)).count();
    let mut said =
        format!("\n{same} of {} pictures have the same bits with and without.\n", all.len());
    for row in all.iter().filter(|row| row["same_bits"].as_bool() != Some(true)) {
        // Writing into a string does not fail.
        let _ = writeln!(said, "Other bits: {}.", text(row, "scene"));
    }
    said.push_str(&table(&["over all scenes", "with skipping", "without", "left"], &lines));
    Section { text: said, plots: Vec::new() }
}
