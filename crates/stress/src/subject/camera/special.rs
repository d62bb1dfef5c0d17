//! Special numbers in every argument of both constructors: refused, or a
//! camera whose rays are finite and lead somewhere.

use std::panic::catch_unwind;

use tracer::{Camera, Refused, UnitVec};

use super::{CAMERA_AT, eye, look_at_of, make, new_look_at, pixel_of, view_of};
use crate::family::{Family, Kernel, Volume};
use crate::subject::closest::SPECIAL;
use crate::{Case, Metric, Random};

const VOLUME: Volume = Volume { quick: 200_000, full: 5_000_000 };

/// The largest and the smallest lengths that are accepted, with their
/// neighbors.
const LIMITS: [f64; 6] = [-1.0, 1e60, 1e60_f64.next_up(), -1e60, 1e-60, 1e-60_f64.next_down()];

/// The numbers of a view, behind the pixel.
const VIEW_NUMBERS: usize = 15;

/// The numbers of [`Camera::look_at`], behind the pixel.
const LOOK_AT_NUMBERS: usize = 11;

pub(super) fn view() -> Family {
    let generate = |random: &mut Random| {
        let kind = make::any_kind(random);
        make::view(random, &kind)
    };
    family("special-values", VIEW_NUMBERS, generate, |case| {
        let (view, projection) = view_of(case);
        Camera::new(&view, projection)
    })
}

pub(super) fn look_at() -> Family {
    family("look-at-special-values", LOOK_AT_NUMBERS, make::look_at, |case| {
        new_look_at(&look_at_of(case))
    })
}

fn family(
    name: &str,
    numbers: usize,
    generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
    new: fn(&Case) -> Result<Camera, Refused>,
) -> Family {
    Family {
        primitive: "camera",
        name: name.to_owned(),
        kernels: vec![Kernel::GOLDRAY],
        targets: vec![(Metric::NotFinite, Some(0.0)), (Metric::Panics, Some(0.0))],
        volume: VOLUME,
        generate: Box::new(move |random| {
            let case = generate(random);
            let mut all = case.numbers().to_vec();
            for _ in 0..=random.below(4) {
                let slot = CAMERA_AT + random.below(numbers);
                if let Some(number) = all.get_mut(slot) {
                    let all = SPECIAL.len() + LIMITS.len();
                    *number =
                        SPECIAL.into_iter().chain(LIMITS).nth(random.below(all)).unwrap_or(0.0);
                }
            }
            Case::of(&all).unwrap_or(case)
        }),
        judge: Box::new(move |case, tallies| {
            for tally in tallies {
                tally.case();
                match catch_unwind(|| is_good(case, new)) {
                    Ok(true) => {}
                    Ok(false) => tally.count(Metric::NotFinite),
                    Err(_) => tally.count(Metric::Panics),
                }
            }
        }),
    }
}

/// Whether the camera is refused, or was asked for in finite numbers and its
/// rays have a finite origin and a direction.
fn is_good(case: &Case, new: fn(&Case) -> Result<Camera, Refused>) -> bool {
    let Ok(camera) = new(case) else { return true };
    let ray = eye(&camera, pixel_of(case));
    let finite = case.numbers().iter().all(|x| x.is_finite());
    finite && ray.origin.is_finite() && UnitVec::new(ray.direction).is_some()
}
