//! The camera's families: eye rays of pictures of up to 65,536 pixels a side,
//! from near and far, straight and oblique, and their mirror images.

use tracer::glam::DVec3;
use tracer::{Camera, Projection, Ray, Refused, View, pixel_center};

use crate::family::{Family, Kernel, Volume};
use crate::number::Dd;
use crate::random::f32_point;
use crate::truth::camera::{ExactCamera, LookAt, Pixel, pi};
use crate::{Case, Metric, Random};

mod make;
mod mirror;
mod special;

/// The largest error of an eye ray, in pixels.
const PIXEL_ERROR: f64 = 1e-9;

/// The largest error of an eye ray, in units of what one rounding of its
/// camera's numbers may do.
const CONDITION_ERROR: f64 = 4.0;

const VOLUME: Volume = Volume { quick: 100_000, full: 10_000_000 };

/// Every family of the camera.
pub(super) fn families() -> Vec<Family> {
    let pixel = Some(PIXEL_ERROR);
    vec![
        of_view("perspective", pixel, |random| make::view(random, &make::PERSPECTIVE)),
        of_view("perspective-oblique", pixel, |random| {
            make::view(random, &make::Kind { oblique: true, ..make::PERSPECTIVE })
        }),
        of_view("parallel", pixel, |random| make::view(random, &make::PARALLEL)),
        of_view("parallel-oblique", pixel, |random| {
            make::view(random, &make::Kind { oblique: true, ..make::PARALLEL })
        }),
        // A far window's points are `f64`s and so off by more than a pixel's
        // billionth, whoever computes them: shown in pixels, held to rounding.
        of_view("parallel-far", None, |random| {
            let kind = make::Kind { oblique: random.coin(), far: true, ..make::PARALLEL };
            make::view(random, &kind)
        }),
        // The picture's turn about the view is then as uncertain as the up.
        of_view("up-along-the-view", None, |random| {
            make::view(random, &make::Kind { up_along: true, ..make::PERSPECTIVE })
        }),
        look_at(),
        mirror::family(),
        special::view(),
        special::look_at(),
    ]
}

/// Makes the eye ray of a pixel.
type Eye = fn(&Camera, Pixel) -> Ray;

/// The eye rays, of which the textbook's differ in the pixel's center.
const EYES: [(Kernel, Eye); 3] = [
    (Kernel::GOLDRAY, eye),
    (Kernel::textbook("slide's formula"), |camera, pixel| through(camera, pixel, slide)),
    (Kernel::textbook("slide's formula, f32"), |camera, pixel| {
        let ray = through(camera, pixel, slide_f32);
        Ray::new(f32_point(ray.origin), f32_point(ray.direction))
    }),
];

/// As `render` makes it.
fn eye(camera: &Camera, pixel: Pixel) -> Ray {
    through(camera, pixel, pixel_center)
}

fn through(camera: &Camera, pixel: Pixel, center: fn(u32, u32, f64) -> f64) -> Ray {
    let a = center(pixel.i, pixel.nx, camera.view_width());
    let b = center(pixel.j, pixel.ny, camera.view_height());
    camera.ray(a, b)
}

/// `l + (r - l)(i + 0.5)/n` as it stands on the slide.
fn slide(i: u32, n: u32, extent: f64) -> f64 {
    let (l, r) = (-0.5 * extent, 0.5 * extent);
    l + (r - l) * (f64::from(i) + 0.5) / f64::from(n)
}

/// The same in `f32`, as the lecture's program would have it.
fn slide_f32(i: u32, n: u32, extent: f64) -> f64 {
    let extent = extent as f32;
    let (l, r) = (-0.5 * extent, 0.5 * extent);
    f64::from(l + (r - l) * (i as f32 + 0.5) / n as f32)
}

fn of_view(
    name: &str,
    pixel_error: Option<f64>,
    generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
) -> Family {
    family(name, pixel_error, generate, |case| {
        let (view, projection) = view_of(case);
        (Camera::new(&view, projection), ExactCamera::of_view(&view, projection))
    })
}

fn look_at() -> Family {
    let pi: Dd = pi();
    family("look-at", Some(PIXEL_ERROR), make::look_at, move |case| {
        let view = look_at_of(case);
        (new_look_at(&view), ExactCamera::of_look_at(&view, &pi))
    })
}

fn family(
    name: &str,
    pixel_error: Option<f64>,
    generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
    cameras: impl Fn(&Case) -> (Result<Camera, Refused>, ExactCamera<Dd>) + Send + Sync + 'static,
) -> Family {
    Family {
        primitive: "camera",
        name: name.to_owned(),
        kernels: EYES.iter().map(|(kernel, _)| *kernel).collect(),
        targets: vec![
            (Metric::FalseMisses, Some(0.0)),
            (Metric::PixelError, pixel_error),
            (Metric::ConditionError, Some(CONDITION_ERROR)),
        ],
        volume: VOLUME,
        generate: Box::new(generate),
        judge: Box::new(move |case, tallies| {
            let (camera, exact) = cameras(case);
            let pixel = pixel_of(case);
            for ((_, eye), tally) in EYES.iter().zip(tallies) {
                tally.case();
                // These families ask for no camera that may be refused.
                let Ok(camera) = &camera else {
                    tally.count(Metric::FalseMisses);
                    continue;
                };
                let miss = exact.miss(pixel, &eye(camera, pixel));
                tally.most(Metric::PixelError, miss.pixels);
                tally.most(Metric::ConditionError, miss.condition_error);
            }
        }),
    }
}

/// A case's numbers: the pixel first, then the camera's arguments in their
/// order. No normal is the zero vector, no distance of projection is zero.
fn view_case(pixel: Pixel, view: &View, projection: Projection) -> Case {
    let distance = match projection {
        Projection::Perspective { proj_distance } => proj_distance,
        Projection::Parallel => 0.0,
    };
    with_pixel(pixel)
        .with_point(view.view_point)
        .with_point(view.view_dir)
        .with_point(view.view_up)
        .with_point(view.proj_normal.unwrap_or(DVec3::ZERO))
        .with(view.view_width)
        .with(view.view_height)
        .with(distance)
}

/// Where a case's camera begins, behind the pixel.
const CAMERA_AT: usize = 4;

fn view_of(case: &Case) -> (View, Projection) {
    let at = CAMERA_AT;
    let normal = case.point(at + 9);
    let view = View {
        view_point: case.point(at),
        view_dir: case.point(at + 3),
        view_up: case.point(at + 6),
        proj_normal: (normal != DVec3::ZERO).then_some(normal),
        view_width: case.number(at + 12),
        view_height: case.number(at + 13),
    };
    let projection = match case.number(at + 14) {
        0.0 => Projection::Parallel,
        proj_distance => Projection::Perspective { proj_distance },
    };
    (view, projection)
}

fn look_at_case(pixel: Pixel, view: &LookAt) -> Case {
    let LookAt { eye, at, up, fov_deg, aspect } = *view;
    with_pixel(pixel).with_point(eye).with_point(at).with_point(up).with(fov_deg).with(aspect)
}

fn look_at_of(case: &Case) -> LookAt {
    let at = CAMERA_AT;
    LookAt {
        eye: case.point(at),
        at: case.point(at + 3),
        up: case.point(at + 6),
        fov_deg: case.number(at + 9),
        aspect: case.number(at + 10),
    }
}

fn new_look_at(view: &LookAt) -> Result<Camera, Refused> {
    Camera::look_at(view.eye, view.at, view.up, view.fov_deg, view.aspect)
}

fn with_pixel(Pixel { i, j, nx, ny }: Pixel) -> Case {
    [i, j, nx, ny].into_iter().fold(Case::EMPTY, |case, n| case.with(f64::from(n)))
}

fn pixel_of(case: &Case) -> Pixel {
    let whole = |i: usize| case.number(i) as u32;
    Pixel { i: whole(0), j: whole(1), nx: whole(2), ny: whole(3) }
}
