//! Damage to few pixels, or to none.

use super::super::Case;
use super::super::patterns::{noise_rgb, scene};
use super::{BLACK, LARGE, SIDE, WHITE, flat, pair, sized, with};

pub(super) fn cases() -> Vec<Case> {
    let last = SIDE - 1;
    vec![
        pair(
            "identical",
            scene,
            scene,
            "Same Same Same Same Same Same Same Same Same Same Same Same",
        ),
        pair(
            "one pixel by one code",
            scene,
            |x, y| {
                let [r, g, b] = scene(x, y);
                [r, g + u8::from((x, y) == (40, 20)), b]
            },
            "Blind Blind Blind Blind Blind Blind Small Blind Blind Blind Blind Blind",
        ),
        pair(
            "one pixel black on white",
            flat(WHITE),
            with(flat(WHITE), BLACK, |x, y| (x, y) == (16, 16)),
            "Large Blind Large Small Large Small Small Blind Small Small Small Small",
        ),
        pair(
            "four pixels black on white",
            flat(WHITE),
            with(flat(WHITE), BLACK, |x, y| x % 32 == 16 && y % 32 == 16),
            "Large Small Large Small Large Small Small Blind Small Small Small Small",
        ),
        sized(
            "one pixel black on a large white",
            (LARGE, LARGE),
            flat(WHITE),
            with(flat(WHITE), BLACK, |x, y| (x, y) == (127, 127)),
            "Large Blind Large Blind Large Blind Small Blind Blind Blind Blind Blind",
        ),
        pair(
            "one pixel white in a corner",
            scene,
            with(scene, WHITE, |x, y| (x, y) == (0, 0)),
            "Large Blind Large Blind Large Blind Large Blind Small Small Small Small",
        ),
        pair(
            "one pixel by 8 codes amid noise",
            noise_rgb,
            |x, y| noise_rgb(x, y).map(|code| if (x, y) == (20, 20) { code ^ 8 } else { code }),
            "Small Blind Blind Blind Blind Blind Small Blind Blind Blind Blind Blind",
        ),
        pair(
            "a blot of 8 x 8",
            scene,
            with(scene, WHITE, |x, y| on_blot(x) && on_blot(y)),
            "Large Small Large Small Large Small Large Small Large Large Small Small",
        ),
        sized(
            "a blot of 8 x 8 in a large picture",
            (LARGE, LARGE),
            scene,
            with(scene, WHITE, |x, y| on_blot(x) && on_blot(y)),
            "Large Small Large Blind Large Blind Large Blind Small Small Blind Blind",
        ),
        pair(
            "the last row lost",
            scene,
            with(scene, BLACK, |_, y| y == last),
            "Large Small Large Blind Large Small Large Small Large Large Large Large",
        ),
    ]
}

/// Whether a coordinate lies on a blot 8 pixels wide.
fn on_blot(i: u32) -> bool {
    (40..48).contains(&i)
}
