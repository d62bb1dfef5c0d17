//! `blame`: which objects of a fixture a difference lies on, and where in the
//! fixture's file they are.

use scene::Place;
use tracer::objects_seen;

use crate::encode::EncodedImage;
use crate::fixture::Fixture;

/// An object, or the background, with its part of a difference.
#[derive(Debug, Clone, PartialEq)]
pub struct Blamed {
    /// The object's number and where it is written; `None` for the background.
    pub object: Option<(u32, Place)>,
    /// How many pixels that differ show it.
    pub pixels: u64,
    /// Its part of the sum of all differences of codes, from 0 to 1.
    pub share: f64,
}

/// What a difference lies on, the most blamed first; equals in the order of the
/// file, the background first. Nothing for equal pictures, and for those of
/// different sizes.
///
/// A pixel is put down to the object that is in its middle in today's scene: what
/// is gone is not blamed, but what is seen in its place.
pub fn blame(fixture: &Fixture, golden: &EncodedImage, actual: &EncodedImage) -> Vec<Blamed> {
    if golden.size() != actual.size() || golden == actual {
        return Vec::new();
    }
    let seen = objects_seen(&fixture.scene);
    let places = fixture.object_places();
    // The background first, then the objects by number: pixels, and codes.
    let mut sums = vec![(0_u64, 0_u64); places.len() + 1];
    let pairs = golden.pixels().iter().zip(actual.pixels());
    for ((golden, actual), object) in pairs.zip(seen) {
        let codes: u64 = golden.iter().zip(actual).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        let place = object.map_or(0, |object| object.0 as usize + 1);
        if let Some((pixels, sum)) = sums.get_mut(place).filter(|_| codes > 0) {
            *pixels += 1;
            *sum += codes;
        }
    }
    let all: u64 = sums.iter().map(|(_, codes)| codes).sum();
    let mut order: Vec<usize> = (0..sums.len()).filter(|&i| sums[i].0 > 0).collect();
    // Stable: equals stay in the order of the file.
    order.sort_by_key(|&i| std::cmp::Reverse(sums[i].1));
    let blamed = |i: usize| Blamed {
        object: i.checked_sub(1).map(|number| (number as u32, places[number].clone())),
        pixels: sums[i].0,
        share: sums[i].1 as f64 / all as f64,
    };
    order.into_iter().map(blamed).collect()
}

#[cfg(test)]
mod tests {
    use scene::NoAssets;
    use tracer::Size;
    use tracer::accel::Build;

    use super::*;

    const TWO: &str = "(version: 1, image: (8, 4), show: Silhouette,
        camera: Parallel(view_point: (0, 0, 5), view_width: 8, view_height: 4),
        objects: [
            Box(min: (-4, -2, 0), max: (-2, 2, 0)),
            Group(objects: [Box(min: (0, -2, 0), max: (2, 2, 0))]),
        ])";

    /// The number and line of an object, its pixels, and hundredths.
    type Found = (Option<(u32, usize)>, u64, u32);

    /// What is blamed for so many codes in red at these pixels.
    #[track_caller]
    fn check(differences: &[((u32, u32), u8)], expected: &[Found]) {
        let fixture = Fixture::read("two", TWO, &NoAssets, Build::Bvh).unwrap();
        let actual = fixture.render().unwrap().encoded;
        let golden = EncodedImage::from_fn(actual.size(), |x, y| {
            let [r, g, b] = actual.get(x, y).unwrap();
            let found = differences.iter().find(|(at, _)| *at == (x, y));
            [found.map_or(r, |(_, codes)| r ^ codes), g, b]
        });
        let found: Vec<Found> = blame(&fixture, &golden, &actual)
            .into_iter()
            .map(|b| {
                let object = b.object.map(|(number, place)| (number, place.line));
                (object, b.pixels, (100.0 * b.share).round() as u32)
            })
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn differences_are_put_down_to_what_is_seen_there() {
        check(&[], &[]);
        check(&[((0, 0), 1)], &[(Some((0, 4)), 1, 100)]);
        check(&[((7, 3), 9)], &[(None, 1, 100)]);
        check(
            &[((0, 0), 1), ((1, 3), 1), ((4, 0), 6), ((7, 0), 2)],
            &[(Some((1, 5)), 1, 60), (None, 1, 20), (Some((0, 4)), 2, 20)],
        );
    }

    #[test]
    fn nothing_is_blamed_for_another_size() {
        let fixture = Fixture::read("two", TWO, &NoAssets, Build::Bvh).unwrap();
        let actual = fixture.render().unwrap().encoded;
        let other = EncodedImage::from_fn(Size { width: 4, height: 8 }, |_, _| [0; 3]);
        assert_eq!(blame(&fixture, &other, &actual), []);
    }
}
