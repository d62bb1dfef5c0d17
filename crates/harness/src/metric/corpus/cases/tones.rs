//! Damage to brightness and contrast everywhere.

use super::super::Case;
use super::super::patterns::{gamma_again, scene};
use super::{BLACK, GRAY, each_code, flat, pair};

pub(super) fn cases() -> Vec<Case> {
    vec![
        pair(
            "every code one up",
            scene,
            each_code(scene, |code| code + 1),
            "Blind Large Blind Blind Blind Blind Small Small Blind Blind Blind Blind",
        ),
        pair(
            "flat, ten codes up",
            flat(GRAY),
            flat([110; 3]),
            "Small Large Blind Blind Blind Blind Small Large Large Large Blind Blind",
        ),
        pair(
            "gain 0.98",
            scene,
            each_code(scene, |code| (u32::from(code) * 98 / 100) as u8),
            "Small Large Blind Blind Blind Blind Small Small Small Small Small Small",
        ),
        pair(
            "half the contrast",
            scene,
            each_code(scene, |code| 64 + code / 2),
            "Large Large Small Large Small Large Small Large Large Large Large Large",
        ),
        pair(
            "gamma applied twice",
            scene,
            each_code(scene, gamma_again),
            "Large Large Small Large Small Large Large Large Large Large Large Large",
        ),
        pair(
            "the scene inverted",
            scene,
            each_code(scene, |code| 255 - code),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "all black",
            scene,
            flat(BLACK),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
    ]
}
