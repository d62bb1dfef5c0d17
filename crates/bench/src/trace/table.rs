//! The tables that a run prints.

use std::fmt::Write;

use super::engine::BAR;
use super::report::{Report, Row};
use crate::stats::geometric_mean;

/// Width of the columns of names and of numbers.
const NAME: usize = 26;
const CELL: usize = 17;

/// Speeds and ratios of one scene: a line for each engine, a column for each
/// kind of rays.
pub(crate) fn scene(rows: &[Row]) -> String {
    let Some(first) = rows.first() else {
        return String::new();
    };
    let mut columns: Vec<&str> = Vec::new();
    let mut engines: Vec<&str> = Vec::new();
    for row in rows {
        if !columns.contains(&&*row.rays) {
            columns.push(&row.rays);
        }
        if !engines.contains(&&*row.engine) {
            engines.push(&row.engine);
        }
    }
    let mut text = format!("{:<NAME$}", first.scene);
    for column in &columns {
        let _ = write!(text, "{column:>CELL$}");
    }
    text.push('\n');
    for engine in engines {
        let _ = write!(text, "{engine:<NAME$}");
        for column in &columns {
            let of = |name: &str| rows.iter().find(|r| r.engine == name && r.rays == *column);
            let cell = of(engine).map_or("-".into(), |row| {
                let ratio = of(BAR).map(|bar| format!(" {:.2}x", row.mrays_s / bar.mrays_s));
                let wrong = if row.wrong == 0 { String::new() } else { format!(" !{}", row.wrong) };
                format!("{:.2}{}{wrong}", row.mrays_s, ratio.unwrap_or_default())
            });
            let _ = write!(text, "{cell:>CELL$}");
        }
        text.push('\n');
    }
    text
}

/// The geometric means of an engine's speeds over another's, over all cells
/// that both have; `None` where there are none.
pub(crate) fn mean_ratio(rows: &[Row], engine: &str, bar: &str, rays: &[&str]) -> Option<f64> {
    let ratios = rows.iter().filter(|row| row.engine == engine && rays.contains(&&*row.rays));
    let ratios: Vec<f64> = ratios
        .filter_map(|row| {
            let same = |other: &&Row| {
                other.engine == bar && other.scene == row.scene && other.rays == row.rays
            };
            Some(row.mrays_s / rows.iter().find(same)?.mrays_s)
        })
        .collect();
    geometric_mean(&ratios)
}

/// Geometric means over all scenes.
pub(crate) fn means(report: &Report) -> String {
    const ALL: [&str; 4] = ["primary", "diffuse", "shuffled", "shadow"];
    let mut text = String::new();
    for engine in ["goldray-accurate", "goldray-fast"] {
        for (bar, rays) in [
            (BAR, &ALL[..]),
            ("embree4-high", &ALL),
            ("embree4-robust", &ALL),
            ("embree4-packet16", &["primary", "shadow"]),
        ] {
            if let Some(ratio) = mean_ratio(&report.rows, engine, bar, rays) {
                let _ = writeln!(
                    text,
                    "{engine} / {bar}: {ratio:.3}x, geometric mean over all scenes of {}",
                    rays.join(", ")
                );
            }
        }
    }
    text
}
