//! `Bars`: a value for each of several names, as horizontal bars.

use crate::measure::Spread;
use crate::svg::{GRAY, INK, LARGE, PALE, SMALL, Svg, color, width};

/// A bar.
#[derive(Debug, Clone)]
pub(crate) struct Bar {
    /// Bars of one group follow each other and have one color.
    pub(crate) group: String,
    /// Its name in the group.
    pub(crate) name: String,
    /// Its length, and the whisker from the lowest to the highest.
    pub(crate) value: Spread,
}

/// The height of a bar with the room around it.
const ROW: f64 = 17.0;
/// The height of the title and the note.
const HEAD: f64 = 64.0;
/// The length of the longest whisker.
const LONGEST: f64 = 420.0;
/// Room for the number behind a bar, and around everything.
const NUMBER: f64 = 110.0;
const MARGIN: f64 = 16.0;

/// The picture, as the text of an SVG file; `unit` stands behind each number.
pub(crate) fn svg(title: &str, note: &str, unit: &str, bars: &[Bar]) -> String {
    let label = |bar: &Bar| format!("{} {}", bar.group, bar.name);
    let left = MARGIN + bars.iter().map(|bar| width(&label(bar))).fold(0.0, f64::max) + 8.0;
    let highest = bars.iter().map(|bar| bar.value.high).fold(f64::MIN_POSITIVE, f64::max);
    let least = width(note).max(width(title) * LARGE / SMALL) + 2.0 * MARGIN;
    let all = (left + LONGEST + NUMBER).max(least);
    let mut svg = Svg::new(all, HEAD + ROW * bars.len() as f64 + MARGIN);
    svg.text((MARGIN, 26.0), LARGE, INK, title);
    svg.text((MARGIN, 46.0), SMALL, GRAY, note);
    let at = |value: f64| left + LONGEST * value / highest;
    svg.line((left, HEAD), (left, HEAD + ROW * bars.len() as f64), GRAY, 1.0);
    let (mut group, mut number) = ("", 0);
    for (k, bar) in bars.iter().enumerate() {
        let top = HEAD + ROW * k as f64;
        if bar.group != group {
            number += 1;
            group = &bar.group;
            svg.line((MARGIN, top), (left + LONGEST, top), PALE, 1.0);
        }
        let base = top + ROW * 0.75;
        let middle = top + ROW / 2.0;
        svg.text_ending((left - 6.0, base), INK, &label(bar));
        svg.rect((left, top + 3.0), (at(bar.value.median) - left, ROW - 6.0), color(number));
        svg.line((at(bar.value.low), middle), (at(bar.value.high), middle), GRAY, 1.5);
        let shown = format!("{} {unit}", short(bar.value.median));
        svg.text((at(bar.value.high) + 6.0, base), SMALL, INK, &shown);
    }
    svg.finish()
}

/// Three digits.
pub(crate) fn short(value: f64) -> String {
    /// Where whole numbers have three digits, and where one decimal makes three.
    const WHOLE: f64 = 99.95;
    const TENS: f64 = 9.995;
    if value >= WHOLE {
        format!("{value:.0}")
    } else if value >= TENS {
        format!("{value:.1}")
    } else {
        format!("{value:.2}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_bar_has_its_name_and_number() {
        let bar = |group: &str, median: f64| Bar {
            group: group.into(),
            name: "hit".into(),
            value: Spread { median, low: median * 0.9, high: median * 1.1 },
        };
        let svg = svg("kernels", "lower is better", "ns", &[bar("box", 5.0), bar("torus", 321.4)]);
        for part in ["box hit", "torus hit", "5.00 ns", "321 ns", "kernels"] {
            assert!(svg.contains(part), "{part}: {svg}");
        }
        assert_eq!(svg.matches("<rect").count(), 3);
    }

    #[test]
    fn three_digits() {
        assert_eq!(
            [0.123, 1.0, 9.996, 12.34, 99.96, 1234.5].map(short),
            ["0.12", "1.00", "10.0", "12.3", "100", "1234"]
        );
    }
}
