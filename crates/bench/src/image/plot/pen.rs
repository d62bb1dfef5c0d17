//! A text of SVG in the making.

use std::fmt::Write as _;

/// Monospaced, so that the width of a text is known whatever the font: at most
/// this share of its size for each letter.
const FONT: &str = "ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace";
const LETTER: f64 = 0.605;
/// The sizes of labels and of titles.
pub(super) const SMALL: f64 = 11.0;
pub(super) const LARGE: f64 = 15.0;

pub(super) const INK: &str = "#1a1a1a";
pub(super) const GRAY: &str = "#6b6b6b";
pub(super) const PALE: &str = "#e6e6e6";
const BACKGROUND: &str = "#ffffff";

/// Half the size of a marker.
const MARKER: f64 = 4.0;

/// A place in pixels, y downwards.
type Place = (f64, f64);

/// How a line is drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    pub(super) color: &'static str,
    pub(super) width: f64,
    /// Lengths of dashes and gaps; none for a whole line.
    pub(super) dashes: &'static str,
}

/// What stands at a point.
#[derive(Debug, Clone, Copy)]
pub(super) enum Marker {
    Diamond,
    Disk,
    Square,
    Triangle,
}

/// How wide a text is, at most.
pub(super) fn width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * LETTER
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Writes elements one after the other.
pub(super) struct Pen(String);

impl Pen {
    /// A picture of this size, empty and white.
    pub(super) fn new(width: f64, height: f64) -> Self {
        let mut pen = Self(String::new());
        pen.put(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"{FONT}\">"
        ));
        pen.put(format_args!("<rect width=\"100%\" height=\"100%\" fill=\"{BACKGROUND}\"/>"));
        pen
    }

    /// The whole text.
    pub(super) fn end(mut self) -> String {
        self.put(format_args!("</svg>"));
        self.0
    }

    fn put(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing into a string does not fail.
        let _ = writeln!(self.0, "{element}");
    }

    /// From here on places are relative to this one, until `close`.
    pub(super) fn open(&mut self, (x, y): Place) {
        self.put(format_args!("<g transform=\"translate({x} {y})\">"));
    }

    pub(super) fn close(&mut self) {
        self.put(format_args!("</g>"));
    }

    pub(super) fn text(&mut self, place: Place, look: (f64, &str), text: &str) {
        self.text_anchored(place, look, "start", text);
    }

    /// A text that ends there.
    pub(super) fn text_ending(&mut self, place: Place, look: (f64, &str), text: &str) {
        self.text_anchored(place, look, "end", text);
    }

    fn text_anchored(
        &mut self,
        (x, y): Place,
        (size, color): (f64, &str),
        anchor: &str,
        text: &str,
    ) {
        self.put(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" fill=\"{color}\" \
             text-anchor=\"{anchor}\" xml:space=\"preserve\">{}</text>",
            escaped(text)
        ));
    }

    /// A line through all of these, if there are two.
    pub(super) fn path(&mut self, places: &[Place], stroke: Stroke) {
        let Stroke { color, width, dashes } = stroke;
        let [first, rest @ ..] = places else { return };
        if rest.is_empty() {
            return;
        }
        let mut d = format!("M{:.1} {:.1}", first.0, first.1);
        for (x, y) in rest {
            let _ = write!(d, "L{x:.1} {y:.1}");
        }
        let dashes = match dashes {
            "" => String::new(),
            dashes => format!(" stroke-dasharray=\"{dashes}\""),
        };
        self.put(format_args!(
            "<path d=\"{d}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" \
             stroke-linejoin=\"round\" stroke-linecap=\"round\"{dashes}/>"
        ));
    }

    pub(super) fn marker(&mut self, (x, y): Place, color: &str, marker: Marker) {
        let style = format!("fill=\"{color}\" stroke=\"{BACKGROUND}\" stroke-width=\"0.8\"");
        let corners: &[Place] = match marker {
            Marker::Disk => {
                self.put(format_args!(
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{MARKER}\" {style}/>"
                ));
                return;
            }
            Marker::Diamond => &[(-1.4, 0.0), (0.0, -1.4), (1.4, 0.0), (0.0, 1.4)],
            Marker::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            Marker::Triangle => &[(-1.2, 0.9), (0.0, -1.2), (1.2, 0.9)],
        };
        let corners: Vec<_> = corners
            .iter()
            .map(|(u, v)| format!("{:.1},{:.1}", x + u * MARKER, y + v * MARKER))
            .collect();
        self.put(format_args!("<polygon points=\"{}\" {style}/>", corners.join(" ")));
    }

    /// A PNG file in base 64.
    pub(super) fn image(&mut self, (x, y): Place, (width, height): (u32, u32), base64: &str) {
        self.put(format_args!(
            "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
             href=\"data:image/png;base64,{base64}\"/>"
        ));
    }
}
