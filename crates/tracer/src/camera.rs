//! `Camera`: the assignment's eye rays, perspective and parallel, straight
//! and oblique.
//!
//! Source: "Ray Tracing Basics" (Cornell CS4620/5620, 2011), slides
//! "Generating eye rays" to "PA1 camera".

use glam::DVec3;

use crate::fault::{Fault, seeded};
use crate::math::tan;
use crate::refused::{direction, length, point, refuse_unless, show};
use crate::{Ray, Refusal, Refused, UnitVec};

/// The assignment's description of a view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// The eye `e` of a perspective view, the center of the view window of a
    /// parallel one.
    pub view_point: DVec3,
    /// Where the camera looks; any length.
    pub view_dir: DVec3,
    /// What is up in the picture; any length, not parallel to the window's
    /// normal.
    pub view_up: DVec3,
    /// The window's normal `w`, pointing back towards the viewer; any length.
    /// `None` is `-view_dir`: a straight view. Anything else makes it oblique.
    pub proj_normal: Option<DVec3>,
    /// Width of the window.
    pub view_width: f64,
    /// Height of the window; its ratio to the width need not be the picture's.
    pub view_height: f64,
}

/// How eye rays leave the view window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Projection {
    /// All from the eye, through the window.
    Perspective {
        /// The distance `d` of the window from the eye, measured along
        /// `view_dir` and not along the window's normal; the two differ in an
        /// oblique view.
        proj_distance: f64,
    },
    /// All along `view_dir`, from points of the window.
    Parallel,
}

/// Makes the eye ray of any point of the view window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// The lecture's `e`.
    e: DVec3,
    /// The window's axis to the right.
    u: UnitVec,
    /// The window's axis upwards.
    v: UnitVec,
    /// `view_dir` of length 1.
    forward: UnitVec,
    view_width: f64,
    view_height: f64,
    projection: Projection,
}

impl Camera {
    /// The camera of a view: `w = normalize(proj_normal)`,
    /// `u = normalize(view_up x w)`, `v = w x u`.
    ///
    /// # Errors
    /// Refuses numbers that are not finite, directions of no length, a window
    /// without an area, an up that is parallel to the window's normal, and a
    /// normal that does not point back towards the viewer.
    pub fn new(view: &View, projection: Projection) -> Result<Self, Refused> {
        let distance = match projection {
            Projection::Perspective { proj_distance } => length("proj_distance", proj_distance),
            Projection::Parallel => None,
        };
        Refused::unless([
            point("view_point", view.view_point),
            direction("view_dir", view.view_dir),
            direction("view_up", view.view_up),
            view.proj_normal.and_then(|n| direction("proj_normal", n)),
            length("view_width", view.view_width),
            length("view_height", view.view_height),
            distance,
        ])?;
        let proj_normal = view.proj_normal.filter(|_| !seeded(Fault::ProjNormalIgnored));
        let w = proj_normal.unwrap_or(-view.view_dir);
        let towards_viewer = refuse_unless(
            w.dot(view.view_dir) < 0.0,
            "proj_normal",
            "a direction that points back towards the viewer, against `view_dir`",
            || show(w),
        );
        Refused::unless([towards_viewer])?;
        let axes = UnitVec::new(view.view_dir).zip(UnitVec::new(w)).and_then(|(forward, w)| {
            let u = to_the_right(view.view_up, w)?;
            let v = if seeded(Fault::UpNotUpright) { view.view_up } else { w.cross(*u) };
            let u = if seeded(Fault::LeftHandedCamera) { -u } else { u };
            Some((forward, u, UnitVec::new(v)?))
        });
        let (forward, u, v) = axes.ok_or_else(|| Refusal {
            field: "view_up",
            expected: "a direction that is not parallel to the window's normal".to_owned(),
            found: show(view.view_up),
        })?;
        Ok(Self {
            e: view.view_point,
            u,
            v,
            forward,
            view_width: view.view_width,
            view_height: view.view_height,
            projection,
        })
    }

    /// A straight perspective camera at `eye` that looks at `at`.
    ///
    /// `fov_deg` is the angle between the window's bottom and top edge, in
    /// degrees; `aspect` is the picture's width over its height.
    ///
    /// # Errors
    /// As [`Camera::new`], in these arguments' names; `fov_deg` must lie
    /// between 1e-9 and 179.999.
    pub fn look_at(
        eye: DVec3,
        at: DVec3,
        up: DVec3,
        fov_deg: f64,
        aspect: f64,
    ) -> Result<Self, Refused> {
        Refused::unless([
            point("eye", eye),
            point("at", at),
            direction("up", up),
            refuse_unless(
                FOV_DEG.contains(&fov_deg),
                "fov_deg",
                format!("an angle from {:e} to {} degrees", FOV_DEG.start(), FOV_DEG.end()),
                || fov_deg.to_string(),
            ),
            length("aspect", aspect),
        ])?;
        let long_enough = direction("at", eye - at).is_none();
        let w = UnitVec::new(eye - at).filter(|_| long_enough).ok_or_else(|| Refusal {
            field: "at",
            expected: "a point other than `eye`".to_owned(),
            found: show(at),
        })?;
        Refused::unless([refuse_unless(
            to_the_right(up, w).is_some(),
            "up",
            "a direction that is not parallel to the line from `eye` to `at`",
            || show(up),
        )])?;
        let half = if seeded(Fault::FovNotHalved) { 1.0 } else { 0.5 };
        let aspect = if seeded(Fault::AspectIgnored) { 1.0 } else { aspect };
        let view_height = 2.0 * tan(half * fov_deg.to_radians());
        let view = View {
            view_point: eye,
            view_dir: at - eye,
            view_up: up,
            proj_normal: None,
            view_width: view_height * aspect,
            view_height,
        };
        Self::new(&view, Projection::Perspective { proj_distance: 1.0 })
    }

    /// The lecture's `e`: the eye of a perspective view, the middle of the window
    /// of a parallel one.
    pub fn eye(&self) -> DVec3 {
        self.e
    }

    /// The window's axes of length 1: to the right, and upwards.
    pub fn axes(&self) -> [UnitVec; 2] {
        [self.u, self.v]
    }

    /// The view's direction, of length 1.
    pub fn forward(&self) -> UnitVec {
        self.forward
    }

    /// How its rays leave the window.
    pub fn projection(&self) -> Projection {
        self.projection
    }

    /// Width of the view window.
    pub fn view_width(&self) -> f64 {
        self.view_width
    }

    /// Height of the view window.
    pub fn view_height(&self) -> f64 {
        self.view_height
    }

    /// The eye ray through the window's point `a u + b v`, where `a` and `b`
    /// are the lecture's pixel coordinates `u` and `v`, from the window's
    /// center. The direction is not normalized.
    ///
    /// - perspective: `p = e`, `d = s - e` with `s = e + a u + b v + d view_dir`;
    ///   in a straight view `view_dir = -w`, which is the slide's `- d w`;
    /// - parallel: `p = e + a u + b v`, `d = view_dir`.
    pub fn ray(&self, a: f64, b: f64) -> Ray {
        let (a, b) = if seeded(Fault::SwappedUAndV) { (b, a) } else { (a, b) };
        let in_window = a * *self.u + b * *self.v;
        match self.projection {
            Projection::Perspective { proj_distance } => {
                let along = seeded(Fault::DistanceAlongNormal).then(|| self.v.cross(*self.u));
                let d = if seeded(Fault::ProjDistanceIgnored) { 1.0 } else { proj_distance };
                Ray::new(self.e, d * along.unwrap_or(*self.forward) + in_window)
            }
            Projection::Parallel if seeded(Fault::ParallelFromTheEye) => {
                Ray::new(self.e, *self.forward + in_window)
            }
            Projection::Parallel => Ray::new(self.e + in_window, *self.forward),
        }
    }
}

/// The angles of a perspective camera, in degrees: beyond them its window has
/// no size to compute with.
const FOV_DEG: std::ops::RangeInclusive<f64> = 1e-9..=179.999;

/// The window's axis to the right, `up x w`; `None` where `up` is parallel to
/// `w` but for rounding, which would turn the picture at random.
fn to_the_right(up: DVec3, w: UnitVec) -> Option<UnitVec> {
    /// The sine of the smallest angle between them: far above rounding.
    const NOT_PARALLEL: f64 = 1e-12;
    let up = *UnitVec::new(up)?;
    let across = up.cross(*w);
    UnitVec::new(across).filter(|_| across.length() > NOT_PARALLEL)
}

/// Where the center of pixel `i` of `n` lies on a window of this extent,
/// from the window's center: the lecture's `l + (r - l)(i + 0.5)/n` with
/// `r = -l = extent/2`.
///
/// Written with the integers first, `extent (2i + 1 - n) / 2n`, so that pixels
/// `i` and `n - 1 - i` are exact negatives of each other.
///
/// ```
/// use tracer::pixel_center;
/// assert_eq!(pixel_center(0, 4, 2.0), -0.75);
/// assert_eq!(pixel_center(3, 4, 2.0), 0.75);
/// assert_eq!(pixel_center(1, 3, 2.0), 0.0);
/// ```
pub fn pixel_center(i: u32, n: u32, extent: f64) -> f64 {
    let middle = i64::from(!seeded(Fault::HalfPixelShift));
    let from_center = 2 * i64::from(i) + middle - i64::from(n);
    extent * from_center as f64 / (2 * i64::from(n)) as f64
}

mod window;
pub(crate) use window::Seen;

#[cfg(test)]
mod tests;
