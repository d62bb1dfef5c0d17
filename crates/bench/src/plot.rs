//! `Plot`: lines over two logarithmic axes, in panels with a legend.

use crate::svg::{GRAY, INK, LARGE, PALE, SMALL, Svg, color, width};

/// A picture of panels.
#[derive(Debug, Clone)]
pub(crate) struct Plot {
    /// What it shows.
    pub(crate) title: String,
    /// How to read it.
    pub(crate) note: String,
    /// Side by side, two in a row.
    pub(crate) panels: Vec<Panel>,
}

/// Lines that share their axes.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    /// What its lines have in common.
    pub(crate) title: String,
    /// What goes to the right.
    pub(crate) x: String,
    /// What goes up.
    pub(crate) y: String,
    /// In the order of the legend.
    pub(crate) lines: Vec<Line>,
}

/// Points that belong together.
#[derive(Debug, Clone)]
pub(crate) struct Line {
    /// Its name in the legend.
    pub(crate) name: String,
    /// In the order in which they are joined. One that is not above 0 and
    /// finite has no place on a logarithmic axis and is left out.
    pub(crate) points: Vec<(f64, f64)>,
}

/// Panels side by side.
const COLUMNS: usize = 2;
/// The width of a panel.
const WIDTH: f64 = 560.0;
/// The height of the part of it that has points.
const INSIDE: f64 = 250.0;
/// Above and below that: the title, the numbers and the name of an axis.
const ABOVE: f64 = 34.0;
const BELOW: f64 = 44.0;
/// Left and right of it.
const LEFT: f64 = 70.0;
const RIGHT: f64 = 16.0;
/// The height of a line of the legend.
const ENTRY: f64 = 17.0;
/// The height of the title and the note.
const HEAD: f64 = 58.0;

/// The picture, as the text of an SVG file.
pub(crate) fn svg(plot: &Plot) -> String {
    let most = plot.panels.iter().map(|panel| panel.lines.len()).max().unwrap_or(0);
    let height = ABOVE + INSIDE + BELOW + ENTRY * most as f64 + ENTRY;
    let across = COLUMNS.min(plot.panels.len()).max(1);
    let rows = plot.panels.len().div_ceil(across);
    let least = width(&plot.note).max(width(&plot.title) * LARGE / SMALL) + 2.0 * RIGHT;
    let mut svg = Svg::new((WIDTH * across as f64).max(least), HEAD + height * rows as f64);
    svg.text((RIGHT, 26.0), LARGE, INK, &plot.title);
    svg.text((RIGHT, 46.0), SMALL, GRAY, &plot.note);
    for (k, panel) in plot.panels.iter().enumerate() {
        svg.group((WIDTH * (k % across) as f64, HEAD + height * (k / across) as f64));
        draw(&mut svg, panel);
        svg.end_group();
    }
    svg.finish()
}

/// The points that have a place.
fn usable(line: &Line) -> impl Iterator<Item = (f64, f64)> + '_ {
    let has_place = |v: f64| v > 0.0 && v.is_finite();
    line.points.iter().copied().filter(move |p| has_place(p.0) && has_place(p.1))
}

fn draw(svg: &mut Svg, panel: &Panel) {
    svg.text((LEFT, 20.0), LARGE, INK, &panel.title);
    let all: Vec<_> = panel.lines.iter().flat_map(usable).collect();
    if all.is_empty() {
        svg.text((LEFT, ABOVE + ENTRY), SMALL, GRAY, "nothing to draw");
        return;
    }
    let right = WIDTH - RIGHT;
    let bottom = ABOVE + INSIDE;
    let x = Axis::around(all.iter().map(|p| p.0), LEFT, right);
    let y = Axis::around(all.iter().map(|p| p.1), bottom, ABOVE);
    for (value, name) in x.ticks() {
        svg.line((x.at(value), ABOVE), (x.at(value), bottom), PALE, 1.0);
        svg.text((x.at(value) - width(&name) / 2.0, bottom + 15.0), SMALL, GRAY, &name);
    }
    for (value, name) in y.ticks() {
        svg.line((LEFT, y.at(value)), (right, y.at(value)), PALE, 1.0);
        svg.text_ending((LEFT - 6.0, y.at(value) + 4.0), GRAY, &name);
    }
    svg.line((LEFT, ABOVE), (LEFT, bottom), GRAY, 1.0);
    svg.line((LEFT, bottom), (right, bottom), GRAY, 1.0);
    svg.text_ending((right, bottom + 32.0), INK, &panel.x);
    svg.text((LEFT, bottom + 32.0), SMALL, INK, &format!("up: {}", panel.y));
    for (number, line) in panel.lines.iter().enumerate() {
        let points: Vec<_> = usable(line).map(|p| (x.at(p.0), y.at(p.1))).collect();
        for ends in points.windows(2) {
            svg.line(ends[0], ends[1], color(number), 1.6);
        }
        for &point in &points {
            svg.marker(point, number);
        }
        let base = bottom + BELOW + ENTRY * (number as f64 + 0.5);
        svg.marker((LEFT + 4.0, base - 4.0), number);
        svg.text((LEFT + 16.0, base), SMALL, INK, &line.name);
    }
}

/// A logarithmic axis over whole powers of ten.
struct Axis {
    /// The powers at its ends.
    first: i32,
    last: i32,
    /// Where these are, in pixels.
    from: f64,
    to: f64,
}

impl Axis {
    /// The axis that has room for all of these, which are above 0.
    fn around(values: impl Iterator<Item = f64> + Clone, from: f64, to: f64) -> Self {
        let low = values.clone().fold(f64::INFINITY, f64::min).log10().floor() as i32;
        let high = values.fold(0.0, f64::max).log10().ceil() as i32;
        Self { first: low, last: high.max(low + 1), from, to }
    }

    fn at(&self, value: f64) -> f64 {
        let share = (value.log10() - f64::from(self.first)) / f64::from(self.last - self.first);
        self.from + (self.to - self.from) * share
    }

    /// The powers of ten, with a few between where there are few.
    fn ticks(&self) -> Vec<(f64, String)> {
        /// Up to so many decades there is room for more than their ends.
        const FEW: i32 = 2;
        let mut ticks = Vec::new();
        for power in self.first..=self.last {
            let decade = 10_f64.powi(power);
            ticks.push((decade, number(decade)));
            if self.last - self.first <= FEW && power < self.last {
                ticks.extend([2.0, 5.0].map(|k| (k * decade, number(k * decade))));
            }
        }
        ticks
    }
}

/// A number as an axis shows it.
fn number(value: f64) -> String {
    /// What is as short written out as with an exponent.
    const PLAIN: std::ops::Range<f64> = 0.01..9_999.0;
    if PLAIN.contains(&value) {
        // Rounded away is what a power of ten of `powi` is off by.
        let text = format!("{value:.3}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(points: &[(f64, f64)]) -> Plot {
        let line = Line { name: "ours & theirs".into(), points: points.to_vec() };
        let panel = Panel { title: "a".into(), x: "n".into(), y: "s".into(), lines: vec![line] };
        Plot { title: "growth".into(), note: "lower is better".into(), panels: vec![panel] }
    }

    #[test]
    fn points_are_where_their_logarithms_are() {
        let axis = Axis::around([1.0, 1e4].into_iter(), 100.0, 500.0);
        for (value, place) in [(1.0, 100.0), (10.0, 200.0), (100.0, 300.0), (1e4, 500.0)] {
            assert!((axis.at(value) - place).abs() < 1e-9, "{value}");
        }
        let up = Axis::around([2e-3, 5e-3].into_iter(), 300.0, 100.0);
        assert!((up.at(1e-3) - 300.0).abs() < 1e-9 && (up.at(1e-2) - 100.0).abs() < 1e-9);
        let one = Axis::around([1.0].into_iter(), 0.0, 1.0);
        assert!(one.at(1.0).is_finite() && one.last > one.first);
    }

    #[test]
    fn every_point_with_a_place_has_a_marker_and_every_line_a_name() {
        let svg = svg(&plot(&[(1.0, 1.0), (10.0, 0.0), (100.0, 3.0), (f64::NAN, 1.0)]));
        // Two points and the legend.
        assert_eq!(svg.matches("<circle").count(), 3, "{svg}");
        assert!(svg.contains("ours &amp; theirs") && svg.contains("lower is better"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn without_points_it_says_so() {
        assert!(svg(&plot(&[])).contains("nothing to draw"));
        assert!(svg(&Plot { panels: vec![], ..plot(&[]) }).contains("growth"));
    }

    #[test]
    fn numbers_are_short() {
        let shown = [0.001, 0.02, 1.0, 50.0, 1000.0, 1e4, 2e6].map(number);
        assert_eq!(shown, ["1e-3", "0.02", "1", "50", "1000", "1e4", "2e6"]);
    }
}
