//! Texels found by their places, inside the picture and beyond.

use super::*;

/// Three by two texels, levels 0 to 5, the top row first.
fn image(filter: TexelFilter, wrap: Wrap) -> Image {
    let codes = (0..6).map(|code| [code, 0, 5 - code]).collect();
    let levels = (0..6).map(f64::from).collect();
    let texels = Texels::new(Size { width: 3, height: 2 }, codes, levels).unwrap();
    Image::new(Arc::new(texels), filter, wrap)
}

#[track_caller]
fn check(filter: TexelFilter, wrap: Wrap, uv: [f64; 2], expected: f64) {
    let (Rgb { r, g, b }, number) = image(filter, wrap).look_up(uv);
    assert_eq!(number == 0, filter == TexelFilter::Bilinear);
    assert!((r - expected).abs() < 1e-14, "{uv:?}: expected {expected}, found {r}");
    assert!(g == 0.0 && (r + b - 5.0).abs() < 1e-14, "{uv:?}: {r} {g} {b}");
}

#[test]
fn the_lower_left_texel_is_at_zero() {
    use TexelFilter::Nearest;
    use Wrap::Repeat;
    check(Nearest, Repeat, [0.0, 0.0], 3.0);
    check(Nearest, Repeat, [0.9, 0.1], 5.0);
    check(Nearest, Repeat, [0.1, 0.9], 0.0);
    check(Nearest, Repeat, [0.5, 0.9], 1.0);
    check(Nearest, Repeat, [0.5, 0.5], 1.0);
    check(Nearest, Repeat, [0.5, 0.5_f64.next_down()], 4.0);
}

#[test]
fn beyond_the_border_it_repeats_or_ends() {
    use TexelFilter::Nearest;
    use Wrap::{Clamp, Repeat};
    check(Nearest, Repeat, [1.0, 0.0], 3.0);
    check(Nearest, Clamp, [1.0, 0.0], 5.0);
    check(Nearest, Repeat, [-0.1, 0.1], 5.0);
    check(Nearest, Clamp, [-0.1, 0.1], 3.0);
    check(Nearest, Repeat, [0.1, -0.1], 0.0);
    check(Nearest, Clamp, [0.1, -7.0], 3.0);
    check(Nearest, Clamp, [0.1, 7.0], 0.0);
    check(Nearest, Repeat, [-0.0, 3.0], 3.0);
    // So near to the border that the sum rounds onto it.
    check(Nearest, Repeat, [-1e-300, 0.0], 5.0);
    check(Nearest, Clamp, [1e60, -1e60], 5.0);
    check(Nearest, Repeat, [f64::NAN, f64::NAN], 3.0);
}

#[test]
fn every_texel_has_its_number() {
    let image = image(TexelFilter::Nearest, Wrap::Repeat);
    let number = |u: f64, v: f64| image.look_up([u, v]).1;
    assert_eq!([0.1, 0.5, 0.9].map(|u| number(u, 0.1)), [1, 2, 3]);
    assert_eq!([0.1, 0.5, 0.9, 1.1].map(|u| number(u, 0.9)), [4, 5, 6, 4]);
}

#[test]
fn middles_are_half_a_texel_in() {
    use TexelFilter::Bilinear;
    use Wrap::{Clamp, Repeat};
    for wrap in [Repeat, Clamp] {
        check(Bilinear, wrap, [0.5, 0.25], 4.0);
        check(Bilinear, wrap, [1.0 / 6.0, 0.75], 0.0);
        check(Bilinear, wrap, [1.0 / 3.0, 0.25], 3.5);
        check(Bilinear, wrap, [0.5, 0.5], 2.5);
        check(Bilinear, wrap, [5.0 / 12.0, 0.375], 3.0);
    }
    check(Bilinear, Clamp, [0.0, 0.25], 3.0);
    check(Bilinear, Repeat, [0.0, 0.25], 4.0);
    check(Bilinear, Repeat, [1.0, 0.25], 4.0);
    check(Bilinear, Repeat, [-0.5, 0.0], 2.5);
    check(Bilinear, Clamp, [1e60, 1e60], 2.0);
}

#[test]
fn a_single_texel_is_everywhere() {
    let texels = Texels::new(Size { width: 1, height: 1 }, vec![[1, 0, 1]], vec![0.0, 7.0]);
    let texels = Arc::new(texels.unwrap());
    for filter in [TexelFilter::Nearest, TexelFilter::Bilinear] {
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            for u in [-1e300, -0.3, 0.0, 0.5, 1.0, 9.7] {
                let image = Image::new(Arc::clone(&texels), filter, wrap);
                assert_eq!(image.look_up([u, -u]).0, Rgb::new(7.0, 0.0, 7.0), "{u}");
            }
        }
    }
}

#[test]
fn bad_pictures_are_refused() {
    #[track_caller]
    fn check(size: (u32, u32), codes: usize, code: u16, levels: &[f64], expected: &str) {
        let size = Size { width: size.0, height: size.1 };
        let made = Texels::new(size, vec![[code; 3]; codes], levels.to_vec());
        let refused = made.unwrap_err().to_string();
        assert!(refused.starts_with(expected), "{refused}");
    }
    check((0, 1), 0, 0, &[0.0], "`size`: expected");
    check((16_385, 1), 16_385, 0, &[0.0], "`size`: expected");
    check((2, 2), 3, 0, &[0.0], "`codes`: expected 4 texels, found 3");
    check((2, 2), 4, 1, &[0.0], "`codes`: expected codes below 1, found 1");
    check((2, 2), 4, 0, &[], "`codes`: expected codes below 0, found 0");
    check((2, 2), 4, 0, &[f64::NAN], "`levels`: expected");
    check((2, 2), 4, 0, &[0.5, -0.5], "`levels`: expected");
}
