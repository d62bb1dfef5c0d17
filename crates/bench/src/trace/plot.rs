//! The picture of a run: for each scene and kind of rays, where each engine
//! lies on a line of speeds over Embree's.

use std::fmt::Write;

use super::engine::BAR;
use super::report::Row;

/// The engines drawn, with their colors, which are read on light and dark
/// ground alike. Circles are goldray's, squares the others'.
const DRAWN: [(&str, &str); 9] = [
    ("goldray-accurate", "#d9480f"),
    ("goldray-fast", "#f08c00"),
    ("embree4-high", "#2f9e44"),
    ("embree4-robust", "#1c7ed6"),
    ("embree4-packet16", "#9c36b5"),
    ("embree3", "#495057"),
    ("obvhs", "#e64980"),
    ("bvh", "#a67c52"),
    ("parry3d", "#74808c"),
];
/// What text and lines are drawn in.
const INK: &str = "#808890";
/// A line's height, a scene's heading, and the margins around all lines.
const LINE: f64 = 22.0;
const HEADING: f64 = 30.0;
const LEFT: f64 = 90.0;
const TOP: f64 = 78.0;
const PLOT_WIDTH: f64 = 640.0;
const MARGIN: f64 = 20.0;
const MARK: f64 = 5.0;
/// The ratios that get a line of their own.
const TICKS: [f64; 7] = [0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

/// The picture, as SVG text; rows of a scene and kind without the bar are left
/// out.
pub(crate) fn svg(rows: &[Row]) -> String {
    let ratio = |row: &Row| {
        let same = |bar: &&Row| bar.engine == BAR && bar.scene == row.scene && bar.rays == row.rays;
        rows.iter().find(same).map(|bar| row.mrays_s / bar.mrays_s)
    };
    let drawn = rows.iter().filter(|row| DRAWN.iter().any(|(name, _)| *name == row.engine));
    let ratios: Vec<(&Row, f64)> = drawn.filter_map(|row| Some((row, ratio(row)?))).collect();
    let lowest = ratios.iter().map(|(_, r)| *r).fold(TICKS[2], f64::min) * 0.9;
    let highest = ratios.iter().map(|(_, r)| *r).fold(TICKS[4], f64::max) * 1.1;
    let x = |ratio: f64| LEFT + PLOT_WIDTH * (ratio / lowest).ln() / (highest / lowest).ln();

    let mut marks = String::new();
    let mut y = TOP;
    let (mut scene, mut rays) = ("", "");
    for (row, ratio) in &ratios {
        if row.scene != scene {
            (scene, rays) = (&row.scene, "");
            y += HEADING;
            let title = format!("{scene}, {} triangles", row.triangles);
            text(&mut marks, (LEFT, y), "start", "bold", &title);
        }
        if row.rays != rays {
            rays = &row.rays;
            y += LINE;
            text(&mut marks, (LEFT - 10.0, y + MARK), "end", "normal", rays);
            let end = LEFT + PLOT_WIDTH;
            let _ = writeln!(marks, r#"<path d="M{LEFT} {y}H{end}" opacity="0.35"/>"#);
        }
        mark(&mut marks, &row.engine, (x(*ratio), y), &format!("{ratio:.2}x"));
    }
    let (width, height) = (LEFT + PLOT_WIDTH + MARGIN, y + LINE + MARGIN);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"13\" fill=\"{INK}\" stroke=\"{INK}\" \
         stroke-width=\"1\">\n"
    );
    text(
        &mut svg,
        (LEFT, MARGIN),
        "start",
        "bold",
        "Rays a second, as a multiple of embree4-avx2's",
    );
    legend(&mut svg, &ratios);
    for tick in TICKS.into_iter().filter(|tick| (lowest..=highest).contains(tick)) {
        let (x, bottom) = (x(tick), height - MARGIN);
        text(&mut svg, (x, TOP + MARK), "middle", "normal", &format!("{tick}x"));
        let (from, opacity) = (TOP + 2.0 * MARK, if tick == 1.0 { 1.0 } else { 0.3 });
        let _ = writeln!(svg, r#"<path d="M{x:.1} {from}V{bottom}" opacity="{opacity}"/>"#);
    }
    svg + &marks + "</svg>\n"
}

fn legend(svg: &mut String, ratios: &[(&Row, f64)]) {
    /// Engines in a row of the legend, and how wide each is.
    const COLUMNS: usize = 4;
    const COLUMN: f64 = PLOT_WIDTH / COLUMNS as f64;
    let is_there = |name: &str| ratios.iter().any(|(row, _)| row.engine == name);
    let engines = DRAWN.iter().map(|(name, _)| *name).filter(|name| is_there(name));
    for (number, engine) in engines.enumerate() {
        let x = LEFT + MARK + COLUMN * (number % COLUMNS) as f64;
        let y = 2.0 * MARGIN + LINE * 0.8 * (number / COLUMNS) as f64;
        mark(svg, engine, (x, y), engine);
        text(svg, (x + 2.0 * MARK, y + MARK), "start", "normal", engine);
    }
}

fn mark(svg: &mut String, engine: &str, (x, y): (f64, f64), title: &str) {
    let color = DRAWN.iter().find(|(name, _)| *name == engine).map_or(INK, |(_, color)| color);
    let title = format!("<title>{engine} {title}</title>");
    let _ = if engine.starts_with("goldray") {
        let r = MARK * 1.2;
        writeln!(
            svg,
            r#"<circle cx="{x:.1}" cy="{y:.1}" r="{r}" fill="{color}" stroke="none">{title}</circle>"#
        )
    } else {
        let (left, top, side) = (x - 0.8 * MARK, y - 0.8 * MARK, 1.6 * MARK);
        writeln!(
            svg,
            r#"<rect x="{left:.1}" y="{top:.1}" width="{side}" height="{side}" fill="{color}" stroke="none">{title}</rect>"#
        )
    };
}

fn text(svg: &mut String, (x, y): (f64, f64), anchor: &str, weight: &str, words: &str) {
    let _ = writeln!(
        svg,
        r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" font-weight="{weight}" stroke="none">{words}</text>"#
    );
}

#[cfg(test)]
mod tests {
    use super::super::table::tests::row;
    use super::*;

    #[test]
    fn what_is_twice_as_fast_lies_on_the_line_of_two() {
        let rows = [
            row("a", "primary", "goldray-fast", 8.0),
            row("a", "primary", BAR, 4.0),
            row("b", "primary", "goldray-fast", 8.0),
        ];
        let svg = svg(&rows);
        let after = |text: &str, from: &str| {
            let found = text.split_once(from).unwrap().1;
            found.split(['"', ' ']).next().unwrap().to_owned()
        };
        let tick = svg.lines().find(|line| line.contains(">2x<")).unwrap();
        let dot = svg.lines().find(|line| line.contains("goldray-fast 2.00x")).unwrap();
        assert_eq!(after(tick, "x=\""), after(dot, "cx=\""));
        assert!(!svg.contains(">b,"), "a scene without the bar has no ratios");
    }
}
