//! Damage to the structure everywhere: noise, blur, and things in other places.

use super::super::Case;
use super::super::patterns::{blurred, checkerboard, noise_rgb, noisy, scene};
use super::{GRAY, SIDE, flat, pair};

pub(super) fn cases() -> Vec<Case> {
    let last = SIDE - 1;
    vec![
        pair(
            "faint noise",
            scene,
            |x, y| noisy(scene(x, y), (x, y), 2),
            "Small Large Small Small Small Small Small Small Small Small Small Small",
        ),
        pair(
            "faint noise on gray",
            flat(GRAY),
            |x, y| noisy(GRAY, (x, y), 2),
            "Small Large Small Small Small Small Small Small Small Small Large Large",
        ),
        pair(
            "heavy noise",
            scene,
            |x, y| noisy(scene(x, y), (x, y), 40),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "noise shifted by one pixel",
            noise_rgb,
            |x, y| noise_rgb(x + 1, y),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "the scene shifted by one pixel",
            scene,
            |x, y| scene(x + 1, y),
            "Large Large Large Large Large Large Small Small Large Large Large Large",
        ),
        pair(
            "the scene blurred",
            scene,
            |x, y| blurred(scene, x, y),
            "Large Large Small Small Large Small Small Small Large Large Small Small",
        ),
        pair(
            "noise blurred",
            noise_rgb,
            |x, y| blurred(noise_rgb, x, y),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "the order of rows flipped",
            scene,
            |x, y| scene(x, last - y),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "mirrored",
            scene,
            |x, y| scene(last - x, y),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
        pair(
            "checkerboard inverted",
            checkerboard,
            |x, y| checkerboard(x + 8, y),
            "Large Large Large Large Large Large Large Large Large Large Large Large",
        ),
    ]
}
