//! Properties of Mitsuba's plugins.

use scene::format::Triple;

use crate::export::number;
use crate::export::text::numbers;

pub(super) fn float(name: &str, x: f64) -> String {
    format!("<float name=\"{name}\" value=\"{}\"/>", number(x))
}

pub(super) fn boolean(name: &str, x: bool) -> String {
    format!("<boolean name=\"{name}\" value=\"{x}\"/>")
}

pub(super) fn integer(name: &str, x: u32) -> String {
    format!("<integer name=\"{name}\" value=\"{x}\"/>")
}

pub(super) fn string(name: &str, x: &str) -> String {
    format!("<string name=\"{name}\" value=\"{x}\"/>")
}

pub(super) fn point(name: &str, at: Triple) -> String {
    coordinates("point", name, at)
}

/// Three numbers as they are: our plugins take colors so, which no profile of
/// colors touches.
pub(super) fn vector3(name: &str, v: Triple) -> String {
    coordinates("vector", name, v)
}

pub(super) fn color(name: &str, rgb: Triple) -> String {
    format!("<rgb name=\"{name}\" value=\"{}\"/>", numbers(rgb, ", "))
}

fn coordinates(kind: &str, name: &str, v: Triple) -> String {
    let [x, y, z] = v.map(number);
    format!("<{kind} name=\"{name}\" x=\"{x}\" y=\"{y}\" z=\"{z}\"/>")
}
