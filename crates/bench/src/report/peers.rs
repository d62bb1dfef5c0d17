//! The sections where goldray stands beside others: rays, whole pictures,
//! kernels.

use serde_json::Value;

use super::Section;
use super::table::{distinct, geometric_mean, number, rows, shown, spread, table, text};
use crate::plot::{self, Line, Panel, Plot};

/// What our engines' names begin with.
const OURS: &str = "goldray";

/// Rays through meshes: a table for each scene, builds, aimed rays, and the
/// ratios to each peer.
pub(super) fn trace(file: &Value) -> Section {
    let all = rows(file, "rows");
    let mut section = ratios(all);
    for scene in distinct(all, "scene") {
        let here: Vec<_> = all.iter().filter(|row| text(row, "scene") == scene).cloned().collect();
        let label = |row: &Value| format!("{} {}", text(row, "rays"), text(row, "query"));
        let mut kinds = Vec::new();
        for row in &here {
            if !kinds.contains(&label(row)) {
                kinds.push(label(row));
            }
        }
        let line = |engine: &String| {
            let cell = |kind: &String| {
                let is_it = |row: &&Value| text(row, "engine") == *engine && label(row) == *kind;
                here.iter().find(is_it).map_or("-".to_owned(), rate)
            };
            [engine.clone()].into_iter().chain(kinds.iter().map(cell)).collect()
        };
        let heads: Vec<_> =
            std::iter::once("Mrays/s").chain(kinds.iter().map(String::as_str)).collect();
        let lines: Vec<Vec<String>> = distinct(&here, "engine").iter().map(line).collect();
        section.extend(["\n### ", &scene, "\n", &table(&heads, &lines)]);
    }
    let builds = rows(file, "builds").iter().map(|row| {
        let ms = format!("{}{}", shown(number(row, "ms")), spread(&row["spread"]));
        let bytes = shown(number(row, "bytes_per_triangle"));
        vec![text(row, "scene"), text(row, "engine"), text(row, "threads"), ms, bytes]
    });
    let builds = table(
        &["builds of", "engine", "threads", "ms", "bytes a triangle"],
        &builds.collect::<Vec<_>>(),
    );
    let aimed = rows(file, "aimed").iter().map(|row| {
        let [scene, rays, engine] = ["scene", "rays", "engine"].map(|key| text(row, key));
        vec![scene, rays, engine, text(row, "wrong"), text(row, "of")]
    });
    let aimed =
        table(&["rays aimed at", "rays", "engine", "wrong", "of"], &aimed.collect::<Vec<_>>());
    Section { text: format!("{section}{builds}{aimed}"), plots: Vec::new() }
}

/// Millions of rays a second, with how many of them are answered wrong.
fn rate(row: &Value) -> String {
    let wrong = number(row, "wrong").filter(|wrong| *wrong > 0.0);
    let wrong = wrong.map_or_else(String::new, |wrong| format!(", {wrong:.0} wrong"));
    format!("{}{}{wrong}", shown(number(row, "mrays_s")), spread(&row["spread"]))
}

/// Each of ours against each peer: the geometric mean of the ratios over all
/// that both were asked, and the lowest.
fn ratios(all: &[Value]) -> String {
    let engines = distinct(all, "engine");
    let is_ours = |name: &&String| name.starts_with(OURS);
    let question = |row: &Value| ["scene", "rays", "query"].map(|key| text(row, key));
    let mut lines = Vec::new();
    for ours in engines.iter().filter(is_ours) {
        for peer in engines.iter().filter(|name| !is_ours(name)) {
            let of = |name: &str| -> Vec<&Value> {
                all.iter().filter(|row| text(row, "engine") == name).collect()
            };
            let theirs = of(peer);
            let found = of(ours).into_iter().filter_map(|mine| {
                let its = theirs.iter().find(|its| question(its) == question(mine))?;
                let ratio = number(mine, "mrays_s")? / number(its, "mrays_s")?;
                Some((ratio, question(mine).join(" ")))
            });
            let found: Vec<_> = found.collect();
            let values: Vec<_> = found.iter().map(|(ratio, _)| *ratio).collect();
            let Some(lowest) = found.iter().min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
            let least = format!("{} ({})", shown(Some(lowest.0)), lowest.1);
            let [mean, count] = [shown(geometric_mean(&values)), found.len().to_string()];
            lines.push(vec![format!("{ours} / {peer}"), mean, least, count]);
        }
    }
    table(&["times as many rays a second", "geometric mean", "lowest", "of"], &lines)
}

/// Whole pictures: a panel for each scene, and the seconds to each error.
pub(super) fn image(file: &Value) -> Section {
    let scenes = rows(file, "scenes");
    let mut text_of_all = String::new();
    let mut panels = Vec::new();
    for scene in scenes {
        let name = text(scene, "scene");
        let points = rows(scene, "points");
        let line = |engine: &String| {
            let here = points.iter().filter(|point| text(point, "engine") == *engine);
            let mut points: Vec<_> = here
                .filter_map(|point| Some((number(point, "seconds")?, number(point, "rmse")?)))
                .collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            Line { name: engine.clone(), points }
        };
        panels.push(Panel {
            title: name.clone(),
            x: "seconds".to_owned(),
            y: "RMSE".to_owned(),
            lines: distinct(points, "engine").iter().map(line).collect(),
        });
        text_of_all.push_str(&to_rmse(&name, rows(scene, "to_rmse")));
    }
    let note = "lower left is better; the truth of each scene is its own engine's or a formula";
    let title = "whole pictures: seconds against error".to_owned();
    let plot = Plot { title, note: note.to_owned(), panels };
    let plots = if scenes.is_empty() {
        Vec::new()
    } else {
        vec![("time-against-error-of-pictures.svg".to_owned(), plot::svg(&plot))]
    };
    Section { text: text_of_all, plots }
}

/// A line for each engine, a column for each error.
fn to_rmse(scene: &str, all: &[Value]) -> String {
    let errors = distinct(all, "rmse");
    let line = |engine: &String| {
        let cell = |error: &String| {
            let is_it =
                |row: &&Value| text(row, "engine") == *engine && text(row, "rmse") == *error;
            shown(all.iter().find(is_it).and_then(|row| number(row, "seconds")))
        };
        [engine.clone()].into_iter().chain(errors.iter().map(cell)).collect()
    };
    let lines: Vec<Vec<String>> = distinct(all, "engine").iter().map(line).collect();
    let title = format!("{scene}: seconds to RMSE");
    let heads: Vec<_> =
        std::iter::once(title.as_str()).chain(errors.iter().map(String::as_str)).collect();
    table(&heads, &lines)
}

/// Kernels on the frontier of time and error, and goldray's.
pub(super) fn error(file: &Value) -> Section {
    let all = rows(file, "rows");
    let is_shown = |row: &&Value| {
        row["frontier"].as_bool() == Some(true) || text(row, "kernel").starts_with(OURS)
    };
    let line = |row: &Value| {
        let family = format!("{}/{}", text(row, "primitive"), text(row, "family"));
        let mark = if row["frontier"].as_bool() == Some(true) { "yes" } else { "no" };
        vec![
            family,
            text(row, "kernel"),
            shown(number(row, "ns")),
            shown(number(row, "error_p99.9")),
            shown(number(row, "misclassified_ppm")),
            mark.to_owned(),
        ]
    };
    let lines: Vec<_> = all.iter().filter(is_shown).map(line).collect();
    let heads = ["family", "kernel", "ns", "error, p99.9", "wrong, ppm", "on the frontier"];
    Section { text: table(&heads, &lines), plots: Vec::new() }
}
