//! `Svg`: the few elements of SVG that the plots are made of.
//!
//! The background is opaque, so that a picture reads the same in light and dark
//! viewers; the colors are Okabe and Ito's, which people with any color vision
//! tell apart, and every line has a marker of its own besides.

use std::fmt::Write as _;

/// Monospaced, so that the width of a text is known whatever the font: at most
/// this share of its size for each letter.
const FONT: &str = "ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace";
const LETTER: f64 = 0.605;
/// The size of labels.
pub(crate) const SMALL: f64 = 11.0;
/// The size of titles.
pub(crate) const LARGE: f64 = 15.0;

/// Text and what is to be seen first.
pub(crate) const INK: &str = "#1a1a1a";
/// Axes.
pub(crate) const GRAY: &str = "#767676";
/// Grids.
pub(crate) const PALE: &str = "#e4e4e4";
const BACKGROUND: &str = "#ffffff";

/// Okabe and Ito's colors but for yellow, which is too pale for a line; black
/// is for the first.
pub(crate) const COLORS: [&str; 7] =
    ["#000000", "#d55e00", "#0072b2", "#007a5a", "#cc79a7", "#e69f00", "#56b4e9"];

/// Half the size of a marker.
const MARKER: f64 = 4.0;

/// A text of SVG in the making.
pub(crate) struct Svg(String);

impl Svg {
    /// An empty picture of this size in pixels.
    pub(crate) fn new(width: f64, height: f64) -> Self {
        let mut svg = Self(String::new());
        svg.put(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"{FONT}\" font-size=\"{SMALL}\">"
        ));
        svg.rect((0.0, 0.0), (width, height), BACKGROUND);
        svg
    }

    /// The text of the file.
    pub(crate) fn finish(mut self) -> String {
        self.put(format_args!("</svg>"));
        self.0
    }

    fn put(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing into a string does not fail.
        let _ = writeln!(self.0, "{element}");
    }

    /// A text that begins at this point of its base line.
    pub(crate) fn text(&mut self, (x, y): (f64, f64), size: f64, color: &str, text: &str) {
        let text = escaped(text);
        self.put(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" fill=\"{color}\">{text}</text>"
        ));
    }

    /// A small text that ends at this point of its base line.
    pub(crate) fn text_ending(&mut self, (x, y): (f64, f64), color: &str, text: &str) {
        let text = escaped(text);
        self.put(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{color}\" text-anchor=\"end\">{text}</text>"
        ));
    }

    /// A straight line.
    pub(crate) fn line(&mut self, a: (f64, f64), b: (f64, f64), color: &str, width: f64) {
        self.put(format_args!(
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"{color}\" stroke-width=\"{width}\"/>",
            a.0, a.1, b.0, b.1
        ));
    }

    /// A filled rectangle with its upper left corner and its size.
    pub(crate) fn rect(&mut self, (x, y): (f64, f64), (width, height): (f64, f64), color: &str) {
        self.put(format_args!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" \
             fill=\"{color}\"/>"
        ));
    }

    /// The marker of the line of this number: a shape and a color of its own.
    pub(crate) fn marker(&mut self, (x, y): (f64, f64), number: usize) {
        let (m, color) = (MARKER, color(number));
        match number % 4 {
            0 => {
                self.put(format_args!(
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{m}\" fill=\"{color}\"/>"
                ));
            }
            1 => self.rect((x - m, y - m), (2.0 * m, 2.0 * m), color),
            2 => self.put(format_args!(
                "<path d=\"M{:.1} {:.1}h{}L{x:.1} {:.1}Z\" fill=\"{color}\"/>",
                x - m,
                y + m,
                2.0 * m,
                y - m
            )),
            _ => self.put(format_args!(
                "<path d=\"M{:.1} {y:.1}L{x:.1} {:.1}L{:.1} {y:.1}L{x:.1} {:.1}Z\" \
                 fill=\"{color}\"/>",
                x - m,
                y - m,
                x + m,
                y + m
            )),
        }
    }

    /// What follows is drawn this far to the right and down, until
    /// [`Svg::end_group`].
    pub(crate) fn group(&mut self, (x, y): (f64, f64)) {
        self.put(format_args!("<g transform=\"translate({x} {y})\">"));
    }

    /// Ends the last group begun.
    pub(crate) fn end_group(&mut self) {
        self.put(format_args!("</g>"));
    }
}

/// The color of the line of this number.
pub(crate) fn color(number: usize) -> &'static str {
    COLORS[number % COLORS.len()]
}

/// At most the width of a small text, in pixels.
pub(crate) fn width(text: &str) -> f64 {
    text.chars().count() as f64 * SMALL * LETTER
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_cannot_end_the_picture() {
        let mut svg = Svg::new(10.0, 10.0);
        svg.text((1.0, 1.0), SMALL, INK, "a < b && </svg>");
        let text = svg.finish();
        assert!(text.contains("a &lt; b &amp;&amp; &lt;/svg&gt;"), "{text}");
        assert_eq!(text.matches("</svg>").count(), 1);
    }

    #[test]
    fn neighboring_markers_differ_in_shape_and_color() {
        let drawn = |number| {
            let mut svg = Svg::new(1.0, 1.0);
            svg.marker((0.0, 0.0), number);
            svg.finish()
        };
        for number in 0..COLORS.len() {
            assert_ne!(drawn(number), drawn(number + 1));
            assert_ne!(color(number), color(number + 1));
        }
    }
}
