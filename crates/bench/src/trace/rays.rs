//! The rays that are measured: eye rays, one diffuse bounce from where they
//! hit, the same in a random order, and shadow rays from there to a small lamp.
//!
//! Origins and directions are `f32` numbers, so that every engine has the very
//! same rays, and every tracer of this run gets them in one order or another.

use tracer::glam::DVec3;
use tracer::shape::{Geometry, Mesh};
use tracer::{Interval, Ray};

use crate::meshes::{SceneMesh, Viewpoint};

/// A ray leaves a surface this part of the scene's diagonal beside it.
const OFFSET: f64 = 1e-5;
/// From outside, the eye stands this many diagonals from the box's center,
/// in this direction, and looks up and down by this tangent.
const EYE_DISTANCE: f64 = 0.9;
const EYE_SIDE: DVec3 = DVec3::new(0.35, 0.25, 1.0);
const OUTSIDE_TANGENT: f64 = 0.36;
/// From inside, it looks as wide as this.
const INSIDE_TANGENT: f64 = 0.75;
/// The lamp of a scene seen from outside: this many diagonals from the center,
/// in this direction.
const LIGHT_DISTANCE: f64 = 1.5;
const LIGHT_SIDE: DVec3 = DVec3::new(-0.5, 1.0, 0.7);
/// Half the lamp's width, in diagonals.
const LIGHT_RADIUS: f64 = 0.02;
/// What starts the random numbers.
const SEED: u64 = 0x5eed;

/// Which rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Kind {
    /// One through each pixel of a pinhole camera
    Primary,
    /// A cosine-weighted bounce from each primary hit, in the pixels' order
    Diffuse,
    /// The same bounces in a random order
    Shuffled,
    /// From each primary hit to a place on a small lamp
    Shadow,
}

impl Kind {
    pub(crate) const ALL: [Self; 4] = [Self::Primary, Self::Diffuse, Self::Shuffled, Self::Shadow];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::Diffuse => "diffuse",
            Self::Shuffled => "shuffled",
            Self::Shadow => "shadow",
        }
    }
}

/// What is asked of a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Query {
    /// Where it meets the mesh first.
    Closest,
    /// Whether it meets it.
    Any,
}

impl Query {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Closest => "closest",
            Self::Any => "any",
        }
    }
}

/// A ray as every engine takes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RayF32 {
    pub(crate) origin: [f32; 3],
    pub(crate) direction: [f32; 3],
}

impl RayF32 {
    fn rounded(origin: DVec3, direction: DVec3) -> Self {
        Self { origin: origin.as_vec3().to_array(), direction: direction.as_vec3().to_array() }
    }

    /// The same ray for goldray, exactly.
    pub(crate) fn exact(&self) -> Ray {
        let [origin, direction] =
            [self.origin, self.direction].map(|v| DVec3::from_array(v.map(f64::from)));
        Ray::new(origin, direction)
    }
}

/// Rays of one kind, and what is asked of them.
#[derive(Debug, Clone)]
pub(crate) struct RaySet {
    pub(crate) name: String,
    pub(crate) query: Query,
    pub(crate) rays: Vec<RayF32>,
    /// Where hits count: from 0 to here.
    pub(crate) far: f32,
    /// For rays that run beside their neighbors: the pixel of each, and the
    /// picture's width.
    pub(crate) pixels: Option<(Vec<u32>, u32)>,
}

impl RaySet {
    /// The range of `t` in which hits count.
    pub(crate) fn range(&self) -> Interval {
        Interval::new(0.0, self.far.into())
    }

    /// In which order to take the rays so that the picture's tiles of
    /// `edge` x `edge` pixels come one after the other; the given order for rays that have
    /// no pixels.
    pub(crate) fn tiled(&self, edge: u32) -> Vec<u32> {
        let mut order: Vec<u32> = (0..self.rays.len() as u32).collect();
        if let Some((pixels, width)) = &self.pixels {
            order.sort_by_key(|&ray| {
                let (x, y) = (pixels[ray as usize] % width, pixels[ray as usize] / width);
                (y / edge, x / edge, y % edge, x % edge)
            });
        }
        order
    }
}

/// The camera and the lamp of a scene.
struct Setting {
    eye: DVec3,
    /// To the picture's center, and half its width and height from there.
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    light: DVec3,
    diagonal: f64,
}

impl Setting {
    fn of(scene: &SceneMesh) -> Self {
        let [lo, hi] = scene.mesh.bounds().map(DVec3::from_array);
        let (center, diagonal) = (DVec3::midpoint(lo, hi), (hi - lo).length());
        let (eye, at, light, tangent) = match scene.view {
            Viewpoint::Outside => (
                center + EYE_SIDE.normalize() * (EYE_DISTANCE * diagonal),
                center,
                center + LIGHT_SIDE.normalize() * (LIGHT_DISTANCE * diagonal),
                OUTSIDE_TANGENT,
            ),
            Viewpoint::Inside { eye, at, light } => {
                let [eye, at, light] = [eye, at, light].map(DVec3::from_array);
                (eye, at, light, INSIDE_TANGENT)
            }
        };
        let forward = (at - eye).normalize();
        let right = forward.cross(DVec3::Y).normalize() * tangent;
        let up = right.cross(forward);
        Self { eye, forward, right, up, light, diagonal }
    }

    /// The ray through the center of a pixel of a square picture.
    fn eye_ray(&self, pixel: u32, size: u32) -> RayF32 {
        let place = |i: u32| (2.0 * f64::from(i) + 1.0) / f64::from(size) - 1.0;
        let (x, y) = (place(pixel % size), place(pixel / size));
        let direction = self.forward + x * self.right - y * self.up;
        RayF32::rounded(self.eye, direction.normalize())
    }
}

/// The sets of the kinds asked for, of a picture of `size` x `size` pixels. A
/// set may be empty, where no eye ray hits.
pub(crate) fn sets(scene: &SceneMesh, exact: &Mesh, size: u32, kinds: &[Kind]) -> Vec<RaySet> {
    let setting = Setting::of(scene);
    let primary: Vec<_> = (0..size * size).map(|pixel| setting.eye_ray(pixel, size)).collect();
    let needs_hits = kinds.iter().any(|kind| *kind != Kind::Primary);
    let starts = if needs_hits { starts(&primary, exact, &setting) } else { Vec::new() };
    let pixels: Vec<u32> = starts.iter().map(|start| start.pixel).collect();

    let set = |kind: &Kind| {
        // Each kind has random numbers of its own, so that leaving one out
        // changes no other.
        let mut random = fastrand::Rng::with_seed(SEED);
        let name = kind.name().to_owned();
        let (far, query) = (f32::INFINITY, Query::Closest);
        match kind {
            Kind::Primary => {
                let pixels = Some(((0..size * size).collect(), size));
                RaySet { name, query, rays: primary.clone(), far, pixels }
            }
            Kind::Diffuse | Kind::Shuffled => {
                let bounce = |start: &Start| {
                    RayF32::rounded(start.point, cosine_around(start.normal, &mut random))
                };
                let mut rays: Vec<_> = starts.iter().map(bounce).collect();
                if *kind == Kind::Shuffled {
                    random.shuffle(&mut rays);
                }
                RaySet { name, query, rays, far, pixels: None }
            }
            Kind::Shadow => {
                let to_lamp = |start: &Start| {
                    let lamp =
                        setting.light + in_ball(&mut random) * LIGHT_RADIUS * setting.diagonal;
                    RayF32::rounded(start.point, lamp - start.point)
                };
                let rays = starts.iter().map(to_lamp).collect();
                let pixels = Some((pixels.clone(), size));
                // The lamp is at 1.
                RaySet { name, query: Query::Any, rays, far: 1.0, pixels }
            }
        }
    };
    kinds.iter().map(set).collect()
}

/// Where a ray starts again: beside the surface, on the side that it came from.
struct Start {
    pixel: u32,
    point: DVec3,
    normal: DVec3,
}

fn starts(primary: &[RayF32], exact: &Mesh, setting: &Setting) -> Vec<Start> {
    let start = |(pixel, ray): (usize, &RayF32)| {
        let ray = ray.exact();
        let contact = exact.intersect(&ray, Interval::AHEAD)?;
        let surface = exact.surface(&ray, &contact);
        let outward = *surface.geometric_normal;
        let normal = if outward.dot(ray.direction) > 0.0 { -outward } else { outward };
        let point = surface.point + normal * (OFFSET * setting.diagonal);
        Some(Start { pixel: pixel as u32, point, normal })
    };
    primary.iter().enumerate().filter_map(start).collect()
}

/// A direction around `normal`, as likely as its cosine: the normal and a point
/// of the unit sphere added up.
fn cosine_around(normal: DVec3, random: &mut fastrand::Rng) -> DVec3 {
    loop {
        let point = in_ball(random);
        // Shorter ones would round, and the sum of opposite ones has no direction.
        let sum = (point.length_squared() > 1e-4).then(|| normal + point.normalize());
        if let Some(direction) = sum.and_then(DVec3::try_normalize) {
            return direction;
        }
    }
}

/// A point of the unit ball, each as likely as any.
fn in_ball(random: &mut fastrand::Rng) -> DVec3 {
    loop {
        let point = DVec3::from_array([(); 3].map(|()| 2.0 * random.f64() - 1.0));
        if point.length_squared() <= 1.0 {
            return point;
        }
    }
}

#[cfg(test)]
mod tests;
