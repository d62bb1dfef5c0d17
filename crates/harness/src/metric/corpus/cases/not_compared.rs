//! Pairs that no metric may be asked about.

use super::super::{Case, files};
use super::{GRAY, flat, picture};

pub(super) fn cases() -> Vec<Case> {
    let refused = |name, golden, actual, expected| Case { name, golden, actual, expected };
    let sized = |(width, height)| Ok(picture(width, height, flat(GRAY)));
    let pixel = || Ok(picture(1, 1, flat(files::PIXEL)));
    vec![
        refused("0 x 0", sized((0, 0)), sized((0, 0)), "there is no pixel"),
        refused("sizes that differ", sized((8, 8)), sized((8, 9)), "sizes differ"),
        refused("12 x 1 for 6 x 2", sized((12, 1)), sized((6, 2)), "sizes differ"),
        refused("4 x 3 for 3 x 4", sized((4, 3)), sized((3, 4)), "sizes differ"),
        refused(
            "NaN in a render",
            pixel(),
            files::not_a_number(),
            "1 pixel with NaN; the first is (1, 1), channel green",
        ),
        refused(
            "a PNG partly transparent",
            files::with_alpha(254),
            pixel(),
            "is partly transparent: expected an opaque picture",
        ),
        refused(
            "a PNG of 16 bits",
            files::sixteen_bits(),
            pixel(),
            "has 16 bits a channel: expected 8",
        ),
        refused(
            "a PNG cut short",
            files::cut_short(),
            pixel(),
            "is not a readable PNG: unexpected end of file",
        ),
    ]
}
