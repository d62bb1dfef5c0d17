//! The report as a picture: seconds against error, a panel for each scene.
//!
//! Left is faster and down is more exact; both axes are logarithmic and the same
//! in all panels. Written as SVG with an opaque background, so that it reads the
//! same in light and dark viewers; the colors are Okabe and Ito's, which people
//! with any color vision tell apart, and no meaning is color's alone.

mod pen;
mod scale;
mod thumbnail;

use std::collections::BTreeMap;

use pen::{GRAY, INK, LARGE, PALE, Pen, SMALL, Stroke};
use scale::{Rect, Scales};
use tracer::LinearImage;

use super::curve::{Point, frontier};
use super::engine::OURS;
use super::report::{OfScene, Report, Row, TARGETS};
use super::table::digits;

/// Panels side by side.
const COLUMNS: usize = 3;
/// A panel with its title, axes and table, in pixels.
const PANEL: (f64, f64) = (452.0, 436.0);
/// The part of it that has points.
const INSIDE: Rect = Rect { left: 52.0, top: 44.0, right: 440.0, bottom: 334.0 };
/// The head with the title and the legend.
const HEAD: f64 = 92.0;
/// Where the legend is, and the length of its lines.
const LEGEND: f64 = 68.0;
const SAMPLE: f64 = 30.0;
/// Of the small picture of a scene.
const THUMBNAIL: (u32, u32) = (96, 72);
/// The frontier of all engines, under their lines.
const BAND: Stroke = Stroke { color: "#f3df7a", width: 9.0, dashes: "" };
/// The error whose times are told in each panel: the one between others.
const TOLD: f64 = TARGETS[TARGETS.len() / 2];
/// The first line of the table, and its columns.
const TABLE: f64 = 382.0;
const TABLE_COLUMNS: usize = 2;
/// From one line of text to the next, in its size.
const LINE: f64 = 1.35;

/// How an engine is drawn.
struct Look {
    engine: &'static str,
    stroke: Stroke,
    marker: pen::Marker,
}

const fn look(
    engine: &'static str,
    color: &'static str,
    (width, dashes): (f64, &'static str),
    marker: pen::Marker,
) -> Look {
    Look { engine, stroke: Stroke { color, width, dashes }, marker }
}

/// Each engine, the last drawn first.
const LOOKS: [Look; 7] = [
    look("goldray-adaptive", "#000000", (2.4, ""), pen::Marker::Diamond),
    look("goldray-adaptive-fast", "#000000", (1.4, "5 3"), pen::Marker::Diamond),
    look("goldray-grid", "#007a5a", (1.6, ""), pen::Marker::Square),
    look("goldray-grid-fast", "#007a5a", (1.4, "5 3"), pen::Marker::Square),
    look("povray", "#d55e00", (1.8, ""), pen::Marker::Triangle),
    look("mitsuba-llvm", "#0072b2", (1.8, ""), pen::Marker::Disk),
    look("mitsuba-scalar", "#56a0d3", (1.4, "2 3"), pen::Marker::Disk),
];

/// The text of an SVG file, with these pictures of the scenes in it.
///
/// # Errors
/// Says so if a small picture cannot be encoded.
pub(crate) fn svg(
    report: &Report,
    pictures: &BTreeMap<String, LinearImage>,
) -> Result<String, String> {
    let points: Vec<_> = report.rows.iter().map(Row::point).collect();
    let scales = Scales::new(&points, INSIDE);
    let across = COLUMNS.min(report.scenes.len()).max(1);
    let width = PANEL.0 * across as f64;
    let height = HEAD + PANEL.1 * report.scenes.len().div_ceil(across) as f64;
    let mut pen = Pen::new(width, height);
    head(&mut pen, report);
    for (k, scene) in report.scenes.iter().enumerate() {
        let corner = (PANEL.0 * (k % across) as f64, HEAD + PANEL.1 * (k / across) as f64);
        pen.open(corner);
        panel(&mut pen, report, scene, &scales);
        if let Some(picture) = pictures.get(&scene.scene) {
            let place = (INSIDE.right - f64::from(THUMBNAIL.0), INSIDE.top);
            pen.image(place, THUMBNAIL, &thumbnail::base64(picture, THUMBNAIL)?);
        }
        pen.close();
    }
    Ok(pen.end())
}

/// The title, how to read it, and the legend.
fn head(pen: &mut Pen, report: &Report) {
    /// The left border of all that is written here.
    const LEFT: f64 = 16.0;
    pen.text((LEFT, 26.0), (LARGE, INK), "seconds to a picture against its error");
    let how = format!(
        "CPU seconds of one thread, {}; RMSE of linear RGB; medians, bars from least to most; \
         lower left is better",
        report.machine
    );
    pen.text((LEFT, 46.0), (SMALL, GRAY), &how);
    let mut x = LEFT;
    let is_there = |look: &&Look| report.rows.iter().any(|row| row.engine == look.engine);
    for look in LOOKS.iter().filter(is_there) {
        pen.path(&[(x, LEGEND), (x + SAMPLE, LEGEND)], look.stroke);
        pen.marker((x + SAMPLE / 2.0, LEGEND), look.stroke.color, look.marker);
        x += SAMPLE + 6.0;
        pen.text((x, LEGEND + 4.0), (SMALL, INK), look.engine);
        x += pen::width(look.engine, SMALL) + 16.0;
    }
    pen.path(&[(x, LEGEND), (x + SAMPLE, LEGEND)], BAND);
    pen.text((x + SAMPLE + 6.0, LEGEND + 4.0), (SMALL, INK), "frontier");
}

/// One scene.
fn panel(pen: &mut Pen, report: &Report, scene: &OfScene, scales: &Scales) {
    pen.text((INSIDE.left, 22.0), (LARGE, INK), &scene.scene);
    let (width, height) = scene.image;
    pen.text((INSIDE.left, 37.0), (SMALL, GRAY), &format!("{}, {width} x {height}", scene.about));
    axes(pen, scales);
    let rows: Vec<_> = report.rows.iter().filter(|row| row.scene == scene.scene).collect();
    let all = |rows: &[&Row]| -> Vec<Point> { rows.iter().map(|row| row.point()).collect() };
    let line = |rows: &[&Row]| -> Vec<(f64, f64)> {
        let points = all(rows);
        frontier(&points).into_iter().map(|i| scales.place(points[i])).collect()
    };
    pen.path(&line(&rows), BAND);
    for look in LOOKS.iter().rev() {
        let own: Vec<_> = rows.iter().copied().filter(|row| row.engine == look.engine).collect();
        pen.path(&line(&own), look.stroke);
        for row in own {
            let (x, y) = scales.place(row.point());
            let ends = [row.spread.0, row.spread.1].map(|seconds| (scales.x(seconds), y));
            pen.path(&ends, Stroke { color: look.stroke.color, width: 1.0, dashes: "" });
            pen.marker((x, y), look.stroke.color, look.marker);
        }
    }
    told(pen, report, scene);
}

/// How many times longer others take, below the axes in columns.
fn told(pen: &mut Pen, report: &Report, scene: &OfScene) {
    let of_scene = |name: &str, rmse: f64| name == scene.scene && rmse == TOLD;
    let all = || report.reached.iter().filter(|one| of_scene(&one.scene, one.rmse));
    let Some(ours) = all().find(|one| one.engine == OURS[0]) else { return };
    let sign = if ours.is_not_within() { "more than " } else { "" };
    let mut y = TABLE;
    let takes = format!("to {TOLD:e} {} takes {sign}{} s", OURS[0], digits(ours.seconds));
    pen.text((INSIDE.left, y), (SMALL, INK), &takes);
    let ratios = report.ratios.iter().filter(|ratio| of_scene(&ratio.scene, ratio.rmse));
    for (k, ratio) in ratios.enumerate() {
        let look = LOOKS.iter().find(|look| look.engine == ratio.engine);
        let color = look.map_or(GRAY, |look| look.stroke.color);
        let sign = if ratio.at_least { ">" } else { "" };
        let times = format!("{sign}{}x", digits(ratio.times));
        if k % TABLE_COLUMNS == 0 {
            y += SMALL * LINE;
        }
        let x = INSIDE.left
            + (INSIDE.right - INSIDE.left) * (k % TABLE_COLUMNS) as f64 / TABLE_COLUMNS as f64;
        pen.text((x, y), (SMALL, color), &format!("{times:>8} {}", ratio.engine));
    }
}

/// The frame, the grid, and the names of both axes.
fn axes(pen: &mut Pen, scales: &Scales) {
    let Rect { left, top, right, bottom } = INSIDE;
    let thin = |color| Stroke { color, width: 1.0, dashes: "" };
    for (error, name) in scales.errors() {
        let y = scales.y(error);
        let is_target = TARGETS.contains(&error);
        let stroke = Stroke { dashes: if is_target { "2 3" } else { "" }, ..thin(PALE) };
        let stroke = if is_target { Stroke { color: GRAY, ..stroke } } else { stroke };
        pen.path(&[(left, y), (right, y)], stroke);
        pen.text_ending((left - 6.0, y + 4.0), (SMALL, GRAY), &name);
    }
    for (seconds, name) in scales.times() {
        let x = scales.x(seconds);
        pen.path(&[(x, top), (x, bottom)], thin(PALE));
        pen.text((x - pen::width(&name, SMALL) / 2.0, bottom + 15.0), (SMALL, GRAY), &name);
    }
    pen.path(&[(left, top), (left, bottom), (right, bottom)], thin(GRAY));
    pen.text_ending((right, bottom + 29.0), (SMALL, GRAY), "CPU seconds");
    pen.text((left, bottom + 29.0), (SMALL, GRAY), "up: RMSE");
}

#[cfg(test)]
mod tests {
    use tracer::{Rgb, Size};

    use super::*;
    use crate::image::report::tests::report;

    #[test]
    fn a_panel_has_its_engines_its_ratios_and_its_picture() {
        let size = Size { width: 192, height: 144 };
        let picture = LinearImage::from_fn(size, |_, _| Rgb::WHITE);
        let pictures = BTreeMap::from([("balls".to_owned(), picture)]);
        let text = svg(&report(), &pictures).unwrap();
        for part in [
            ">balls<",
            ">povray<",
            "to 1e-3 goldray-adaptive takes 0.224 s",
            " >13.4x povray",
            "image/png;base64,iVBOR",
        ] {
            let part = part.replace(" >", " &gt;");
            assert!(text.contains(&part), "{part} in {text}");
        }
        assert!(!text.contains("mitsuba-scalar"), "it measured nothing");
        assert_eq!(text.matches("<g ").count(), text.matches("</g>").count());
        assert!(text.starts_with("<svg ") && text.trim_end().ends_with("</svg>"));
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }

    #[test]
    fn every_engine_has_a_look_of_its_own() {
        for name in [&OURS[..], &crate::image::engine::PEERS[..]].concat() {
            assert_eq!(LOOKS.iter().filter(|look| look.engine == name).count(), 1, "{name}");
        }
    }

    #[test]
    fn nothing_measured_is_a_picture_all_the_same() {
        let empty = Report { rows: vec![], scenes: vec![], ..report() };
        let text = svg(&empty, &BTreeMap::new()).unwrap();
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }
}
