//! Pictures smaller than any window.

use super::super::{Case, files};
use super::{BLACK, SIDE, WHITE, flat, picture, sized};

pub(super) fn cases() -> Vec<Case> {
    let stripes = |x: u32, y: u32| [60 + 20 * ((x + y) % 5) as u8; 3];
    vec![
        sized(
            "1 x 1, black to white",
            (1, 1),
            flat(BLACK),
            flat(WHITE),
            "Large Blind Large Large Large Large Large Large Large Large Large Large",
        ),
        sized(
            "1 x 64, shifted",
            (1, SIDE),
            stripes,
            |x, y| stripes(x, y + 1),
            "Large Small Large Large Large Large Small Large Large Large Large Large",
        ),
        sized(
            "2 x 2, mirrored",
            (2, 2),
            stripes,
            |x, y| stripes(1 - x, y),
            "Small Small Large Large Large Large Small Large Large Large Large Large",
        ),
        Case {
            name: "a PNG with alpha, all opaque",
            golden: files::with_alpha(u8::MAX),
            actual: Ok(picture(1, 1, flat(files::PIXEL))),
            expected: "Same Same Same Same Same Same Same Same Same Same Same Same",
        },
    ]
}
