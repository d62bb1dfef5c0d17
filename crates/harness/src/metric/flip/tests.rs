//! FLIP: sizes, borders and extremes.

use super::super::flip_map;
use super::*;
use crate::encode::EncodedImage;

fn noise(width: u32, height: u32, seed: u64) -> EncodedImage {
    let mut rng = fastrand::Rng::with_seed(seed);
    EncodedImage::from_fn(Size { width, height }, |_, _| [rng.u8(..), rng.u8(..), rng.u8(..)])
}

fn flat(width: u32, height: u32, rgb: [u8; 3]) -> EncodedImage {
    EncodedImage::from_fn(Size { width, height }, |_, _| rgb)
}

fn flip_of(golden: &EncodedImage, actual: &EncodedImage) -> Flip {
    flip(&Pair::new(golden, actual).unwrap())
}

#[test]
fn the_observer_sees_67_pixels_per_degree() {
    assert!((PIXELS_PER_DEGREE - 67.020_643_276).abs() < 1e-9, "{PIXELS_PER_DEGREE}");
}

#[test]
fn identical_pictures_give_exactly_0() {
    for (width, height) in [(1, 1), (1, 30), (2, 2), (33, 27)] {
        for picture in [noise(width, height, 1), flat(width, height, [255, 0, 1])] {
            let expected = Flip { mean: 0.0, max: 0.0, max_at: (0, 0) };
            assert_eq!(flip_of(&picture, &picture.clone()), expected);
        }
    }
}

#[test]
fn the_map_is_what_is_summed_up() {
    for (width, height) in [(1, 1), (3, 20), (21, 21), (40, 22)] {
        let (golden, actual) = (noise(width, height, 2), noise(width, height, 3));
        let map = flip_map(&Pair::new(&golden, &actual).unwrap());
        let found = flip_of(&golden, &actual);
        assert_eq!(map.errors.len(), (width * height) as usize);
        assert!(map.errors.iter().all(|error| (0.0..=1.0).contains(error)));
        assert_eq!(found.mean, map.errors.iter().sum::<f64>() / map.errors.len() as f64);
        let (x, y) = found.max_at;
        assert_eq!(map.errors[(y * width + x) as usize], found.max);
        assert_eq!(map.errors.iter().copied().fold(0.0, f64::max), found.max);
    }
}

/// Flat pictures have no features, so that only their colors are compared.
#[test]
fn no_colors_are_farther_apart_than_green_and_blue() {
    let corner = |i: u8| [i & 1, i >> 1 & 1, i >> 2 & 1].map(|bit| bit * 255);
    for a in 0..8 {
        for b in 0..a {
            let found = flip_of(&flat(1, 1, corner(a)), &flat(1, 1, corner(b))).max;
            assert!(0.5 < found && found <= 1.0, "{:?} {:?}: {found}", corner(a), corner(b));
        }
    }
    assert_eq!(flip_of(&flat(1, 1, [0, 255, 0]), &flat(1, 1, [0, 0, 255])).max, 1.0);
}

#[test]
fn one_pixel_is_found_wherever_it_is() {
    for (width, height) in [(1, 1), (3, 20), (25, 23)] {
        let golden = flat(width, height, [90, 100, 110]);
        for (x, y) in [(0, 0), (width - 1, 0), (0, height - 1), (width / 2, height / 2)] {
            let actual = EncodedImage::from_fn(golden.size(), |i, j| {
                if (i, j) == (x, y) { [255, 0, 0] } else { [90, 100, 110] }
            });
            let found = flip_of(&golden, &actual);
            assert!(0.3 < found.max, "{width}x{height}: {found:?}");
            assert_eq!(found.max_at, (x, y), "{width}x{height}");
        }
    }
}

#[test]
fn swapping_or_mirroring_both_changes_no_bit() {
    let (golden, actual) = (noise(25, 17, 4), noise(25, 17, 5));
    let map = |a: &EncodedImage, b: &EncodedImage| flip_map(&Pair::new(a, b).unwrap());
    assert_eq!(map(&golden, &actual), map(&actual, &golden));
    let mirror = |picture: &EncodedImage| {
        let bytes: Vec<u8> = picture.pixels().iter().rev().flatten().copied().collect();
        EncodedImage::from_bytes(picture.size(), bytes).unwrap()
    };
    let mut mirrored = map(&mirror(&golden), &mirror(&actual));
    mirrored.errors.reverse();
    assert_eq!(map(&golden, &actual), mirrored);
}

/// The blind spot that both metrics name.
#[test]
fn a_pattern_finer_than_the_eye_is_not_seen_in_color() {
    let board = |phase: u32| {
        let size = Size { width: 40, height: 40 };
        EncodedImage::from_fn(size, |x, y| {
            if (x + y + phase).is_multiple_of(2) { [200, 80, 40] } else { [80, 126, 200] }
        })
    };
    let (golden, actual) = (board(0), board(1));
    let map = flip_map(&Pair::new(&golden, &actual).unwrap());
    // At the edges, where the outermost pixel goes on, the pattern ends.
    let inside = |i: usize| (12..28).contains(&(i % 40)) && (12..28).contains(&(i / 40));
    let errors = map.errors.iter().enumerate().filter(|(i, _)| inside(*i)).map(|(_, error)| error);
    let worst = errors.copied().fold(0.0, f64::max);
    assert!(worst < 1e-3, "{worst}");
}
