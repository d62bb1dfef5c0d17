//! The bench's rows as a picture: time against error, a panel for each family.
//!
//! Down is more exact and left is faster, both axes logarithmic and the same in
//! all panels. Written as SVG with an opaque background, so that it reads the
//! same in light and dark viewers; the colors are Okabe and Ito's, which
//! people with any color vision tell apart, and no meaning is color's alone.

mod label;
mod scale;

use std::fmt::Write as _;

use label::{Rect, Surroundings, place};
use scale::Scales;

use super::table::ppm;
use super::{OURS, Report, Row};

/// Panels side by side.
const COLUMNS: usize = 2;
/// A panel with its axes and title, in pixels.
const PANEL: (f64, f64) = (680.0, 430.0);
/// The part of it that has points: left, top, right, bottom.
const INSIDE: Rect = Rect { left: 62.0, top: 34.0, right: 668.0, bottom: 392.0 };
/// The head with the title and the legend.
const HEAD: f64 = 96.0;
/// Half the size of a marker.
const MARKER: f64 = 4.0;
/// Monospaced, so that the width of a text is known whatever the font: at most
/// this share of its size for each letter.
const FONT: &str = "ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace";
const LETTER: f64 = 0.605;
/// The sizes of labels and of titles.
const SMALL: f64 = 11.0;
const LARGE: f64 = 15.0;

/// The height of a line of text in its size.
const LINE: f64 = 1.3;
/// What one rounding of `t` may be off by.
const ROUNDINGS: [(f64, &str); 2] = [
    (f32::EPSILON as f64 / 2.0, "one rounding to f32"),
    (f64::EPSILON / 2.0, "one rounding to f64"),
];

const INK: &str = "#1a1a1a";
const PALE: &str = "#e4e4e4";
const GRAY: &str = "#767676";
const BACKGROUND: &str = "#ffffff";
/// The color of each kind of kernel, and what the legend calls it.
const KINDS: [(&str, &str); 4] = [
    ("#d55e00", "f32"),
    ("#0072b2", "f64"),
    ("#007a5a", "double-double"),
    ("#000000", "goldray (f64)"),
];

fn color(row: &Row) -> &'static str {
    let kind = match row.kernel {
        OURS => 3,
        name if name.ends_with("f32") => 0,
        name if name.ends_with("f64") => 1,
        _ => 2,
    };
    KINDS[kind].0
}

/// The picture of a report, as the text of an SVG file.
pub fn svg(report: &Report) -> String {
    let families: Vec<_> =
        report.rows.chunk_by(|a, b| (a.primitive, a.family) == (b.primitive, b.family)).collect();
    let scales = Scales::new(&report.rows, INSIDE);
    let across = COLUMNS.min(families.len()).max(1);
    let width = PANEL.0 * across as f64;
    let height = HEAD + PANEL.1 * families.len().div_ceil(across) as f64;
    let mut svg = Svg(String::new());
    svg.put(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"{FONT}\" font-size=\"{SMALL}\">"
    ));
    svg.put(format_args!("<rect width=\"{width}\" height=\"{height}\" fill=\"{BACKGROUND}\"/>"));
    head(&mut svg, report);
    for (k, rows) in families.iter().enumerate() {
        let (x, y) = (PANEL.0 * (k % across) as f64, HEAD + PANEL.1 * (k / across) as f64);
        svg.put(format_args!("<g transform=\"translate({x} {y})\">"));
        panel(&mut svg, rows, &scales);
        svg.put(format_args!("</g>"));
    }
    svg.put(format_args!("</svg>"));
    svg.0
}

/// The title, how to read it, and the legend.
fn head(svg: &mut Svg, report: &Report) {
    let features = report.features.join(", ");
    svg.text((16.0, 26.0), LARGE, INK, "run time against error of ray intersection kernels");
    svg.text((16.0, 46.0), SMALL, GRAY, &format!("built for {features}; lower left is better"));
    let mut x = 22.0;
    for (color, name) in KINDS {
        svg.marker((x, 64.0), color, false, name.starts_with(OURS));
        svg.text((x + 10.0, 68.0), SMALL, INK, name);
        x += 36.0 + name.len() as f64 * SMALL * LETTER;
    }
    svg.marker((22.0, 82.0), INK, true, false);
    let wrong = "hollow: some hits or misses are wrong, or rays leak; how many";
    svg.text((32.0, 86.0), SMALL, INK, wrong);
    svg.line((x, 64.0), (x + 26.0, 64.0), GRAY, 2.0);
    svg.text((x + 32.0, 68.0), SMALL, INK, "frontier, underlined");
}

/// One family.
fn panel(svg: &mut Svg, rows: &[Row], scales: &Scales) {
    svg.text((INSIDE.left, 22.0), LARGE, INK, &format!("{}/{}", rows[0].primitive, rows[0].family));
    axes(svg, scales);
    let mut order: Vec<&Row> = rows.iter().collect();
    // Ours is labeled first and drawn last; then what is on the frontier.
    order.sort_by_key(|row| (row.kernel != OURS, !row.frontier));
    let points: Vec<_> = order.iter().map(|row| scales.point(row)).collect();
    let mut line: Vec<_> = rows.iter().filter(|row| row.frontier).collect();
    line.sort_by(|a, b| a.ns.total_cmp(&b.ns));
    // The rest of the frontier is on it for being wrong less often.
    let mut lowest = f64::INFINITY;
    line.retain(|row| {
        let falls = row.error_p999 <= lowest;
        lowest = lowest.min(row.error_p999);
        falls
    });
    let line: Vec<_> = line.into_iter().map(|row| scales.point(row)).collect();
    for ends in line.windows(2) {
        svg.line(ends[0], ends[1], GRAY, 2.0);
    }
    let texts: Vec<_> = order.iter().map(|row| caption(row)).collect();
    let widths: Vec<_> = texts.iter().map(|text| width(text)).collect();
    let roundings = ROUNDINGS.map(|(error, name)| {
        let bottom = scales.y(error) + SMALL * LINE;
        let left = INSIDE.right - width(name) - 2.0 * MARKER;
        Rect { left, top: bottom - SMALL * LINE, right: INSIDE.right, bottom }
    });
    let labels =
        place(&points, &widths, &Surroundings { inside: INSIDE, texts: &roundings, line: &line });
    for ((row, label), text) in order.iter().zip(&labels).zip(&texts).rev() {
        let point = scales.point(row);
        if let Some(end) = label.leader(point) {
            svg.line(point, end, GRAY, 0.75);
        }
        let weight = if row.kernel == OURS { " font-weight=\"bold\"" } else { "" };
        let under = if row.frontier { " text-decoration=\"underline\"" } else { "" };
        let Rect { left, bottom, .. } = label.text;
        let (y, color) = (bottom - 3.5, color(row));
        svg.put(format_args!(
            "<text x=\"{left:.1}\" y=\"{y:.1}\" fill=\"{color}\"{weight}{under}>{text}</text>"
        ));
    }
    for (row, point) in order.iter().zip(&points).rev() {
        svg.marker(*point, color(row), row.is_unsound(), row.kernel == OURS);
    }
}

fn width(text: &str) -> f64 {
    text.chars().count() as f64 * SMALL * LETTER
}

/// A kernel's name, and how often it is wrong.
fn caption(row: &Row) -> String {
    let mut text = row.kernel.to_owned();
    for (share, what) in [(row.misclassified_ppm, "wrong"), (row.leaks_ppm, "leak")] {
        if share > 0.0 {
            // Writing into a string does not fail.
            let _ = write!(text, " {} {what}", share_of(share));
        }
    }
    text
}

/// Parts per million, or percent where they are many.
fn share_of(share: f64) -> String {
    const PERCENT: f64 = 1e4;
    if share < PERCENT {
        format!("{}ppm", ppm(share))
    } else {
        format!("{}%", ppm(share / PERCENT))
    }
}

/// The frame, the grid, and the names of both axes.
fn axes(svg: &mut Svg, scales: &Scales) {
    let Rect { left, top, right, bottom } = INSIDE;
    for (y, name) in scales.errors() {
        svg.line((left, y), (right, y), PALE, 1.0);
        svg.text_ending((left - 6.0, y + 4.0), GRAY, &name);
    }
    for (x, name) in scales.times() {
        svg.line((x, top), (x, bottom), PALE, 1.0);
        svg.text((x - width(&name) / 2.0, bottom + 15.0), SMALL, GRAY, &name);
    }
    for (error, name) in ROUNDINGS {
        let y = scales.y(error);
        svg.put(format_args!(
            "<path d=\"M{left} {y:.1}H{right}\" stroke=\"{GRAY}\" stroke-dasharray=\"2 4\"/>"
        ));
        svg.text_ending((right - MARKER, y + SMALL), GRAY, name);
    }
    svg.line((left, top), (left, bottom), GRAY, 1.0);
    svg.line((left, bottom), (right, bottom), GRAY, 1.0);
    svg.text_ending((right, bottom + 30.0), INK, "ns per test");
    svg.text((left, bottom + 30.0), SMALL, INK, "up: error of t, |t - exact| / |exact|, p99.9");
}

/// A text of SVG in the making.
struct Svg(String);

impl Svg {
    fn put(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing into a string does not fail.
        let _ = writeln!(self.0, "{element}");
    }

    fn text(&mut self, (x, y): (f64, f64), size: f64, color: &str, text: &str) {
        self.put(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" fill=\"{color}\">{text}</text>"
        ));
    }

    fn text_ending(&mut self, (x, y): (f64, f64), color: &str, text: &str) {
        self.put(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{color}\" text-anchor=\"end\">{text}</text>"
        ));
    }

    fn line(&mut self, a: (f64, f64), b: (f64, f64), color: &str, width: f64) {
        self.put(format_args!(
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"{color}\" stroke-width=\"{width}\"/>",
            a.0, a.1, b.0, b.1
        ));
    }

    /// A disk; a hollow square for what is wrong at times; a diamond for ours.
    fn marker(&mut self, (x, y): (f64, f64), color: &str, hollow: bool, ours: bool) {
        let fill = if hollow { BACKGROUND } else { color };
        let style = format!("fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"1.6\"");
        let m = MARKER;
        match (ours, hollow) {
            (true, _) => {
                let m = m * 1.6;
                self.put(format_args!(
                    "<path d=\"M{:.1} {y:.1}L{x:.1} {:.1}L{:.1} {y:.1}L{x:.1} {:.1}Z\" {style}/>",
                    x - m,
                    y - m,
                    x + m,
                    y + m
                ));
            }
            (false, true) => self.put(format_args!(
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{}\" height=\"{}\" {style}/>",
                x - m,
                y - m,
                2.0 * m,
                2.0 * m
            )),
            (false, false) => {
                self.put(format_args!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{m}\" {style}/>"));
            }
        }
    }
}
