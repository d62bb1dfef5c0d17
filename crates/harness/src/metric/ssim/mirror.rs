//! The picture beyond its edges: mirrored, the outermost pixel twice.

/// The pixel to read at every position of a line of `pixels` that goes on for
/// `border` positions at either end; `pixels` is at least 1.
///
/// Four pixels continue as `d c b a | a b c d | d c b a`, over and over where
/// the border is longer than the line: `reflect` in `scipy.ndimage`.
pub(super) fn mirrored(pixels: usize, border: usize) -> Vec<usize> {
    let there_and_back = (0..pixels).chain((0..pixels).rev());
    let period = 2 * pixels;
    let start = period - border % period;
    there_and_back.cycle().skip(start).take(border + pixels + border).collect()
}

#[cfg(test)]
mod tests {
    use super::mirrored;

    #[track_caller]
    fn check(pixels: usize, border: usize, expected: &[usize]) {
        assert_eq!(mirrored(pixels, border), expected, "{pixels} pixels, {border} beyond");
    }

    #[test]
    fn the_outermost_pixel_is_repeated() {
        check(4, 2, &[1, 0, 0, 1, 2, 3, 3, 2]);
        check(4, 4, &[3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0]);
        check(3, 0, &[0, 1, 2]);
    }

    #[test]
    fn a_short_line_is_mirrored_again_and_again() {
        check(1, 3, &[0; 7]);
        check(2, 5, &[0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1]);
        check(3, 5, &[1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1]);
    }
}
