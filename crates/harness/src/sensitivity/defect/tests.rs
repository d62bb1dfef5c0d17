//! What holds for every kind of defect.

use std::collections::BTreeSet;

use tracer::Size;

use super::*;
use crate::metric::{Pair, difference};

/// Colors, edges and a ramp.
fn busy(size: Size) -> EncodedImage {
    EncodedImage::from_fn(size, |x, y| {
        [(7 * x) as u8, (40 * (y % 5)) as u8, if x > y { 200 } else { 90 }]
    })
}

#[test]
fn names_are_told_apart_and_numbers_make_sense() {
    let names: BTreeSet<_> = DEFECTS.iter().map(|defect| defect.name).collect();
    assert_eq!(names.len(), DEFECTS.len());
    for Defect { name, strengths: Strengths { least, most, whole }, visible, .. } in DEFECTS {
        assert!(0.0 < *least && least <= visible && visible <= most, "{name}");
        assert!(!whole || [least, most, visible].iter().all(|s| s.fract() == 0.0), "{name}");
    }
}

#[test]
fn the_strongest_is_seen_and_the_size_stays() {
    for size in [Size { width: 33, height: 21 }, Size { width: 5, height: 1 }] {
        let picture = busy(size);
        for defect in DEFECTS.iter().filter(|d| size.height > 1 || d.name != "shift-down") {
            for place in (defect.places)(&picture) {
                let damaged = (defect.inject)(&picture, place, defect.strengths.most);
                let found = difference(&Pair::new(&picture, &damaged).unwrap()).max_abs;
                assert!(found > 4, "{} {place} {found}", defect.name);
            }
        }
    }
}

#[test]
fn a_place_is_inside_and_damage_is_the_same_each_time() {
    let picture = busy(Size { width: 20, height: 9 });
    for defect in DEFECTS {
        for place in (defect.places)(&picture) {
            let inside = match place {
                Place::Whole => true,
                Place::Row(y) => y < 9,
                Place::At(x, y) => x < 20 && y < 9,
            };
            assert!(inside, "{} {place}", defect.name);
            let damaged = || (defect.inject)(&picture, place, defect.visible);
            assert_eq!(damaged(), damaged());
        }
    }
}
