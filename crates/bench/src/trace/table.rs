//! The tables that a run prints.

use std::fmt::Write;

use super::engine::BAR;
use super::report::{Aimed, Build, Report, Row};
use crate::slope::slope;

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

/// `None` of no numbers, and where one is not positive.
fn geometric_mean(values: &[f64]) -> Option<f64> {
    let usable = !values.is_empty() && values.iter().all(|value| *value > 0.0);
    let logs: f64 = values.iter().map(|value| value.ln()).sum();
    usable.then(|| (logs / values.len() as f64).exp())
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
                let is_there = |rays: &&&str| report.rows.iter().any(|row| row.rays == **rays);
                let rays: Vec<&str> = rays.iter().filter(is_there).copied().collect();
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

/// Building, of one scene.
pub(crate) fn builds(builds: &[Build]) -> String {
    let mut text = format!(
        "{:<NAME$}{:>CELL$}{:>CELL$}{:>CELL$}{:>CELL$}\n",
        "built, CPU ms", "busiest thread", "all threads", "wall", "bytes/triangle"
    );
    for build in builds {
        let name = format!("{}, {} thr.", build.engine, build.threads);
        let of_same = |other: &&Build| other.engine == BAR && other.threads == build.threads;
        let ratio = builds.iter().find(of_same).map(|bar| build.ms / bar.ms);
        let ratio = ratio.map_or(String::new(), |ratio| format!(" {ratio:.2}x"));
        let ms = format!("{:.1}{ratio}", build.ms);
        let (all, wall) = (build.all_threads_ms, build.wall_ms);
        let bytes = build.bytes_per_triangle;
        let _ =
            writeln!(text, "{name:<NAME$}{ms:>CELL$}{all:>CELL$.1}{wall:>CELL$.1}{bytes:>CELL$.1}");
    }
    text
}

/// Rays through edges and corners, of one scene.
pub(crate) fn aimed(aimed: &[Aimed]) -> String {
    let mut text = String::new();
    let mut set = "";
    for row in aimed {
        if row.rays != set {
            set = &row.rays;
            let _ = writeln!(
                text,
                "{:<NAME$}{:>CELL$}{:>CELL$}",
                format!("{} rays from {set}", row.of),
                "hit or miss",
                "elsewhere"
            );
        }
        let (engine, missed, moved) = (&row.engine, row.hit_or_miss, row.elsewhere);
        let _ = writeln!(text, "{engine:<NAME$}{missed:>CELL$}{moved:>CELL$}");
    }
    text
}

/// How the time of a ray grows with the number of triangles, over the generated
/// balls: the slope of a line through the logarithms, for each engine.
pub(crate) fn growth(rows: &[Row]) -> String {
    /// Balls that a line is drawn through.
    const ENOUGH: usize = 3;
    let balls: Vec<&Row> = rows.iter().filter(|row| row.scene.starts_with("bumpy-")).collect();
    let mut text = String::new();
    let mut done: Vec<(&str, &str)> = Vec::new();
    for row in &balls {
        let key = (&*row.engine, &*row.rays);
        let same = balls.iter().filter(|other| (&*other.engine, &*other.rays) == key);
        let points: Vec<_> = same.map(|row| (row.triangles as f64, row.mrays_s.recip())).collect();
        if done.contains(&key) || points.len() < ENOUGH {
            continue;
        }
        done.push(key);
        if let Some(slope) = slope(&points) {
            let name = format!("{} {}", row.engine, row.rays);
            let _ = writeln!(text, "{name:<36} time ~ triangles^{slope:.3}");
        }
    }
    text
}

#[cfg(test)]
pub(super) mod tests;
