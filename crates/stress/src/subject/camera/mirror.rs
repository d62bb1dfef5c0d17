//! Mirrored cameras: pixels `i` and `n - 1 - i` have rays that are exact
//! mirror images, in both directions of the picture.
//!
//! Negating one world axis of a camera's vectors mirrors its picture from left
//! to right. If the up direction is negated as well, left stays left and the
//! picture is mirrored from top to bottom. Zeros of both signs are one number.

use tracer::glam::DVec3;
use tracer::{Camera, Ray, View};

use super::{EYES, Eye, VOLUME, make, pixel_of, view_case, view_of};
use crate::family::Family;
use crate::truth::camera::Pixel;
use crate::{Case, Metric, Random};

pub(super) fn family() -> Family {
    Family {
        primitive: "camera",
        name: "mirror".to_owned(),
        kernels: EYES.iter().map(|(kernel, _)| *kernel).collect(),
        targets: vec![(Metric::FalseMisses, Some(0.0)), (Metric::MirrorFlaws, Some(0.0))],
        volume: VOLUME,
        generate: Box::new(generate),
        judge: Box::new(|case, tallies| {
            let axis = case.number(AXIS_AT) as usize;
            for ((_, eye), tally) in EYES.iter().zip(tallies) {
                tally.case();
                match is_mirrored(case, *eye, axis) {
                    None => tally.count(Metric::FalseMisses),
                    Some(false) => tally.count(Metric::MirrorFlaws),
                    Some(true) => {}
                }
            }
        }),
    }
}

/// Where in a case the negated axis is, behind pixel and view.
const AXIS_AT: usize = 19;

fn generate(random: &mut Random) -> Case {
    let kind = make::any_kind(random);
    let case = make::view(random, &kind);
    let (view, projection) = view_of(&case);
    // Also views along the axes, where most products vanish.
    let view = if random.below(4) == 0 { along_axes(random, view) } else { view };
    view_case(pixel_of(&case), &view, projection).with(random.below(3) as f64)
}

fn along_axes(random: &mut Random, view: View) -> View {
    let first = random.below(3);
    let mut signed = |k: usize| DVec3::AXES[(first + k) % 3] * random.sign();
    View { view_dir: signed(0), view_up: signed(1), proj_normal: None, ..view }
}

/// `None` if a camera is refused.
fn is_mirrored(case: &Case, eye: Eye, axis: usize) -> Option<bool> {
    let (view, projection) = view_of(case);
    let mirror = |mut p: DVec3| {
        p[axis] = -p[axis];
        p
    };
    let left_right = View {
        view_point: mirror(view.view_point),
        view_dir: mirror(view.view_dir),
        view_up: mirror(view.view_up),
        proj_normal: view.proj_normal.map(mirror),
        ..view
    };
    let top_bottom = View { view_up: -left_right.view_up, ..left_right };
    let pixel = pixel_of(case);
    let ray_of = |view: &View, pixel: Pixel| -> Option<Ray> {
        Some(eye(&Camera::new(view, projection).ok()?, pixel))
    };
    let original = ray_of(&view, pixel)?;
    let mirrored = Ray::new(mirror(original.origin), mirror(original.direction));
    let across = ray_of(&left_right, Pixel { i: pixel.nx - 1 - pixel.i, ..pixel })?;
    let below = ray_of(&top_bottom, Pixel { j: pixel.ny - 1 - pixel.j, ..pixel })?;
    // A NaN is no mirror image.
    Some(across == mirrored && below == mirrored)
}
