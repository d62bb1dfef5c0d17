//! The sections where goldray stands beside others: rays, whole pictures,
//! kernels.

use serde_json::Value;

use super::Section;
use super::table::{distinct, geometric_mean, number, rows, shown, spread, table, text};

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

/// Whole pictures: for each scene the seconds to each error, and how many times
/// goldray's adaptive samples that is.
pub(super) fn image(file: &Value) -> Section {
    let (reached, ratios) = (rows(file, "reached"), rows(file, "ratios"));
    let mut said = String::new();
    for scene in rows(file, "scenes") {
        let name = text(scene, "scene");
        let of = |all: &[Value]| -> Vec<Value> {
            all.iter().filter(|row| text(row, "scene") == name).cloned().collect()
        };
        let (reached, ratios) = (of(reached), of(ratios));
        let mut errors = distinct(&reached, "rmse");
        let size = |error: &String| error.parse().unwrap_or(0.0_f64);
        errors.sort_by(|a, b| size(b).total_cmp(&size(a)));
        let line = |engine: &String| {
            let cell = |error: &String| {
                let is_it =
                    |row: &&Value| text(row, "engine") == *engine && text(row, "rmse") == *error;
                seconds(reached.iter().find(is_it), ratios.iter().find(is_it))
            };
            [engine.clone()].into_iter().chain(errors.iter().map(cell)).collect()
        };
        let lines: Vec<Vec<String>> = distinct(&reached, "engine").iter().map(line).collect();
        let title = format!("{name}: seconds to RMSE");
        let heads: Vec<_> =
            std::iter::once(title.as_str()).chain(errors.iter().map(String::as_str)).collect();
        said.push_str(&table(&heads, &lines));
    }
    Section { text: said, plots: Vec::new() }
}

/// The seconds to an error, more than which they are where it was not reached, and
/// how many times ours that is.
fn seconds(reached: Option<&Value>, ratio: Option<&Value>) -> String {
    let Some(reached) = reached else { return "-".to_owned() };
    let least = if text(reached, "how") == "not within" { "over " } else { "" };
    let times = ratio.and_then(|row| number(row, "times"));
    let times = times.map_or_else(String::new, |times| format!(", {}x", shown(Some(times))));
    format!("{least}{}{times}", shown(number(reached, "seconds")))
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
