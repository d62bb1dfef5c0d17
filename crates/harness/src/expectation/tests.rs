//! Each expectation met, and each one broken.

use tracer::{LinearImage, Size};

use super::*;
use crate::encode::{Transfer, encode};

/// Two rows: 1, 0.25, 1 and 1, 0.25, 0.5, in gray.
fn rendered() -> Rendered {
    let values = [1.0, 0.25, 1.0, 1.0, 0.25, 0.5].map(|v| Rgb::WHITE * v);
    let size = Size { width: 3, height: 2 };
    let linear = LinearImage::from_pixels(size, values.to_vec()).unwrap();
    let encoded = encode(&linear, Transfer::Gamma22).unwrap();
    Rendered { linear, encoded }
}

#[track_caller]
#[allow(clippy::needless_pass_by_value)]
fn check(expectation: Expectation, expected: Result<(), &str>) {
    let found = expectation.check(&rendered());
    assert_eq!(found.as_ref().map_err(String::as_str).copied(), expected);
}

#[test]
fn pixels() {
    let pixel = |at, rgb| Expectation::Pixel(Pixel { at, rgb });
    check(pixel((0, 1), (255, 255, 255)), Ok(()));
    check(
        pixel((1, 0), (255, 255, 255)),
        Err("pixel (1, 0): expected (255, 255, 255), found (136, 136, 136)"),
    );
}

#[test]
fn radiances() {
    let radiance = |rgb, within| Expectation::Radiance(Radiance { at: (1, 0), rgb, within });
    check(radiance((0.25, 0.25, 0.25), 0.0), Ok(()));
    check(radiance((0.26, 0.25, 0.25), 0.1), Ok(()));
    check(
        radiance((0.26, 0.25, 0.25), 0.01),
        Err("radiance of pixel (1, 0): expected [0.26, 0.25, 0.25] within 0.01, \
             found [0.25, 0.25, 0.25]"),
    );
}

#[test]
fn counts() {
    let about = |pixels, within| Expectation::Count(Count { rgb: (255, 255, 255), pixels, within });
    check(about(3, 0), Ok(()));
    check(about(4, 0), Err("pixels of color (255, 255, 255): expected 4, found 3"));
    check(about(4, 1), Ok(()));
    check(about(2, 1), Ok(()));
    check(about(5, 1), Err("pixels of color (255, 255, 255): expected 5 within 1, found 3"));
    let is_problem = |pixels, within| !about(pixels, within).problems((3, 2)).is_empty();
    assert!(!is_problem(5, 2) && is_problem(4, 2) && is_problem(0, 1) && !is_problem(0, 0));
}

#[test]
fn an_allowance_is_written_where_there_is_one() {
    #[track_caller]
    fn check(within: u64, expected: &str) {
        let count = Expectation::Count(Count { rgb: (1, 2, 3), pixels: 9, within });
        let text = serde_json::to_string(&count).unwrap();
        assert_eq!(text, expected);
        assert_eq!(serde_json::from_str::<Expectation>(&text).unwrap(), count);
    }
    check(0, r#"{"Count":{"rgb":[1,2,3],"pixels":9}}"#);
    check(2, r#"{"Count":{"rgb":[1,2,3],"pixels":9,"within":2}}"#);
}

#[test]
fn of_black_only_roundings_are_close() {
    let dark = |within| {
        let picture = Rendered {
            linear: LinearImage::from_fn(Size { width: 3, height: 2 }, |_, _| Rgb::WHITE * 0.05),
            ..rendered()
        };
        Expectation::Radiance(Radiance { at: (1, 0), rgb: (0.0, 0.0, 0.0), within }).check(&picture)
    };
    assert!(dark(0.1).is_err() && dark(1e-12).is_err());
}

#[test]
fn a_tolerance_that_is_left_out_is_a_few_roundings() {
    #[track_caller]
    fn check(written: &str, found: f64, is_met: bool) {
        let picture = Rendered {
            linear: LinearImage::from_fn(Size { width: 3, height: 2 }, |x, _| {
                Rgb::WHITE * if x == 0 { found } else { 1.0 }
            }),
            ..rendered()
        };
        let expectation: Expectation = serde_json::from_str(written).unwrap();
        assert_eq!(expectation.check(&picture).is_ok(), is_met, "{written} of {found}");
    }
    let radiance = r#"{"Radiance": {"at": [0, 0], "rgb": [0.25, 0.25, 0.25]}}"#;
    let black = r#"{"Radiance": {"at": [0, 0], "rgb": [0, 0, 0]}}"#;
    let ratio = r#"{"Ratio": {"of": [0, 0], "to": [1, 1], "is": 0.25}}"#;
    for written in [radiance, ratio] {
        check(written, 0.25 * (1.0 + 1e-13), true);
        check(written, 0.25 * (1.0 + 1e-11), false);
    }
    check(black, 1e-13, true);
    check(black, 1e-11, false);
}

#[test]
fn a_line_of_one_pixel_is_its_own_mirror_image() {
    let fields = |mirror, image| Expectation::Mirror(mirror).problems(image).len();
    assert_eq!(fields(Mirror::LeftRight, (1, 9)), 1);
    assert_eq!(fields(Mirror::TopBottom, (9, 1)), 1);
    assert_eq!(fields(Mirror::LeftRight, (2, 1)), 0);
}

#[test]
fn mirrors() {
    let mut picture = rendered();
    let mirror = Expectation::Mirror(Mirror::LeftRight);
    check(
        mirror.clone(),
        Err("LeftRight mirror: pixels (0, 1) and (2, 1): expected equal bits, \
             found [1.0, 1.0, 1.0] and [0.5, 0.5, 0.5]"),
    );
    assert!(Expectation::Mirror(Mirror::TopBottom).check(&picture).is_err());
    picture.linear =
        LinearImage::from_fn(picture.linear.size(), |x, _| Rgb::WHITE * f64::from(x % 2));
    assert_eq!(mirror.check(&picture), Ok(()));
    assert_eq!(Expectation::Mirror(Mirror::TopBottom).check(&picture), Ok(()));
}

#[test]
fn ratios() {
    let ratio = |of, is| Expectation::Ratio(Ratio { of, to: (1, 0), is, within: 1e-12 });
    check(ratio((0, 0), 4.0), Ok(()));
    check(ratio((2, 1), 2.0), Ok(()));
    check(
        ratio((0, 0), 2.0),
        Err("ratio of pixels (0, 0) to (1, 0): expected 2 within 0.000000000001, \
             found [1.0, 1.0, 1.0] to [0.25, 0.25, 0.25]"),
    );
    let dark = Rendered {
        linear: LinearImage::from_fn(Size { width: 3, height: 2 }, |_, _| Rgb::BLACK),
        ..rendered()
    };
    assert!(ratio((0, 0), 1.0).check(&dark).is_err(), "black is no multiple of black");
}

#[test]
fn nonsense_is_found_before_rendering() {
    let fields = |e: Expectation| e.problems((3, 2)).iter().map(|p| p.0).collect::<Vec<_>>();
    assert_eq!(fields(Expectation::Pixel(Pixel { at: (3, 0), rgb: (0, 0, 0) })), ["at"]);
    assert_eq!(fields(Expectation::Pixel(Pixel { at: (2, 1), rgb: (0, 0, 0) })), [""; 0]);
    let itself = Ratio { of: (1, 1), to: (1, 1), is: 1.0, within: 0.0 };
    assert_eq!(fields(Expectation::Ratio(itself)), ["to"]);
    let ratio = Ratio { of: (0, 2), to: (9, 9), is: f64::NAN, within: 1.0 };
    assert_eq!(fields(Expectation::Ratio(ratio)), ["within", "is", "of", "to"]);
}
