//! Damage to hue and saturation.

use super::super::Case;
use super::super::patterns::{bars, fine_hues, scene};
use super::{RED, each_code, flat, pair};

pub(super) fn cases() -> Vec<Case> {
    let red_green = |x, y| {
        let [r, g, b] = scene(x, y);
        [g, r, b]
    };
    let without_blue = |x, y| {
        let [r, g, _] = scene(x, y);
        [r, g, 0]
    };
    vec![
        pair(
            "blue lost",
            scene,
            without_blue,
            "Large Large Large Large Large Large Large Large Large Large Small Small",
        ),
        pair(
            "red and green swapped",
            scene,
            red_green,
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "another hue of equal luma",
            flat(RED),
            flat([0, 60, 0]),
            "Large Large Large Large Large Large Large Large Large Large Blind Large",
        ),
        pair(
            "another hue of equal chroma",
            flat(RED),
            flat([0, 102, 0]),
            "Large Large Large Large Large Large Large Large Large Large Large Blind",
        ),
        pair(
            "hues swapped pixel by pixel",
            |x, y| fine_hues(x, y, 0),
            |x, y| fine_hues(x, y, 1),
            "Large Large Large Large Large Large Blind Blind Large Large Large Large",
        ),
        pair(
            "saturated colors dulled",
            bars,
            each_code(bars, |code| code.clamp(20, 235)),
            "Small Large Large Large Large Large Large Large Large Large Large Large",
        ),
    ]
}
