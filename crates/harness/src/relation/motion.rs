//! `Motion`: a map of the world that leaves spheres spheres and boxes boxes,
//! done to a scene as it is written.

use scene::format::{Camera, Falloff, Light, Object, Shading, Show, Transform, Triple};
use serde::{Deserialize, Serialize};
use tracer::{LinearImage, Rgb};

use super::{Problem, objects, problem_if};
use crate::check::File;

/// An axis of the world.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

/// Coordinate `i` goes to `sign[i] * scale * p[from[i]] + by[i]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    from: [usize; 3],
    sign: Triple,
    scale: f64,
    by: Triple,
    /// The same as a step of a group.
    step: Transform,
}

impl Motion {
    /// Moves along the axes.
    pub(super) fn translation(by: Triple) -> Self {
        let [x, y, z] = by;
        Self { by, ..Self::by_step(Transform::Translate(x, y, z)) }
    }

    /// Turns by 90 degrees about a world axis.
    pub(super) fn quarter_turn(axis: Axis) -> Self {
        const TURN: f64 = 90.0;
        let (from, sign, step) = match axis {
            Axis::X => ([0, 2, 1], [1.0, -1.0, 1.0], Transform::RotateDeg(TURN, 0.0, 0.0)),
            Axis::Y => ([2, 1, 0], [1.0, 1.0, -1.0], Transform::RotateDeg(0.0, TURN, 0.0)),
            Axis::Z => ([1, 0, 2], [-1.0, 1.0, 1.0], Transform::RotateDeg(0.0, 0.0, TURN)),
        };
        Self { from, sign, ..Self::by_step(step) }
    }

    /// Turns an axis around.
    pub(super) fn mirror(axis: Axis) -> Self {
        let mut sign = [1.0; 3];
        sign[axis as usize] = -1.0;
        let [x, y, z] = sign;
        Self { sign, ..Self::by_step(Transform::Scale(x, y, z)) }
    }

    /// Makes all lengths this many times longer.
    pub(super) fn scale(scale: f64) -> Self {
        Self { scale, ..Self::by_step(Transform::Scale(scale, scale, scale)) }
    }

    fn by_step(step: Transform) -> Self {
        Self { from: [0, 1, 2], sign: [1.0; 3], scale: 1.0, by: [0.0; 3], step }
    }

    /// Whether left becomes right.
    pub(super) fn is_mirror(&self) -> bool {
        // Two axes that change places mirror as well.
        let swaps = self.from != [0, 1, 2];
        let sign: f64 = self.sign.iter().product();
        (sign < 0.0) != swaps
    }

    fn is_translation(&self) -> bool {
        self.from == [0, 1, 2] && self.sign == [1.0; 3] && self.scale == 1.0
    }

    /// The scene with its lights and its camera moved together.
    pub(super) fn file(&self, file: &File) -> File {
        let mut moved = file.clone();
        moved.camera = self.camera(file.camera);
        moved.objects = file.objects.iter().map(|object| self.object(file, object)).collect();
        let falls_off = file.shading != Shading::Classic;
        moved.lights = file.lights.iter().map(|light| self.light(light, falls_off)).collect();
        match &mut moved.show {
            Show::Depth { near, far } => {
                (*near, *far) = (self.length(*near), self.length(*far));
            }
            // A pixel on an outline is a mean of both, so the background has to
            // turn as normals do.
            Show::Normals => moved.background = self.color(file.background),
            _ => {}
        }
        moved
    }

    /// The picture that the moved scene has, if this is the scene's.
    pub(super) fn picture(&self, file: &File, picture: &LinearImage) -> LinearImage {
        let width = picture.size().width;
        let (is_mirror, shows_normals) = (self.is_mirror(), file.show == Show::Normals);
        LinearImage::from_fn(picture.size(), |x, y| {
            let x = if is_mirror { width - 1 - x } else { x };
            let color = picture.get(x, y).unwrap_or_default();
            if shows_normals { Rgb::from(self.color(color.channels())) } else { color }
        })
    }

    /// What a scene has that cannot be moved, or that it has nothing to move.
    pub(super) fn problems(&self, file: &File) -> Vec<Problem> {
        let turns = self.sign != [1.0; 3];
        let shows_materials = matches!(file.show, Show::Shaded | Show::SurfaceColor);
        let mut problems = problem_if(file.objects.is_empty(), "expected an object, found none");
        problems.extend(problem_if(
            turns && shows_materials && objects::any_shows_normals(file),
            "expected no material `Normal`, as its colors turn with the scene",
        ));
        problems.extend(problem_if(
            turns && file.show == Show::Normals && file.background.iter().any(|&c| c > 1.0),
            "expected a background of at most 1, as colors of normals turn with the scene",
        ));
        problems
    }

    fn point(&self, p: Triple) -> Triple {
        let v = self.vector(p);
        std::array::from_fn(|i| self.scale * v[i] + self.by[i])
    }

    /// A direction, whose length says nothing.
    fn vector(&self, d: Triple) -> Triple {
        std::array::from_fn(|i| self.sign[i] * d[self.from[i]])
    }

    fn length(&self, length: f64) -> f64 {
        self.scale * length
    }

    /// The color `(n + 1) / 2` of a normal.
    fn color(&self, color: Triple) -> Triple {
        std::array::from_fn(|i| {
            let c = color[self.from[i]];
            if self.sign[i] < 0.0 { 1.0 - c } else { c }
        })
    }

    fn camera(&self, camera: Camera) -> Camera {
        let mut moved = camera;
        match &mut moved {
            Camera::Perspective {
                view_point,
                view_dir,
                view_up,
                proj_normal,
                view_width,
                view_height,
                proj_distance,
            } => {
                self.view(view_point, [view_dir, view_up], proj_normal, [view_width, view_height]);
                *proj_distance = self.length(*proj_distance);
            }
            Camera::Parallel {
                view_point,
                view_dir,
                view_up,
                proj_normal,
                view_width,
                view_height,
            } => {
                self.view(view_point, [view_dir, view_up], proj_normal, [view_width, view_height]);
            }
            Camera::LookAt { eye, at, up, .. } => {
                (*eye, *at, *up) = (self.point(*eye), self.point(*at), self.vector(*up));
            }
        }
        moved
    }

    fn view(
        &self,
        view_point: &mut Triple,
        directions: [&mut Triple; 2],
        proj_normal: &mut Option<Triple>,
        sizes: [&mut f64; 2],
    ) {
        *view_point = self.point(*view_point);
        for direction in directions {
            *direction = self.vector(*direction);
        }
        *proj_normal = proj_normal.map(|n| self.vector(n));
        for size in sizes {
            *size = self.length(*size);
        }
    }

    /// `falls_off` is what a point light does that does not say.
    fn light(&self, light: &Light, falls_off: bool) -> Light {
        let mut moved = *light;
        match &mut moved {
            Light::Point { position, intensity, falloff } => {
                *position = self.point(*position);
                if falloff.map_or(falls_off, |falloff| falloff == Falloff::InverseSquare) {
                    // What is farther away needs more light to be as bright.
                    *intensity = intensity.map(|i| self.scale * self.scale * i);
                }
            }
            Light::Directional { direction, .. } => *direction = self.vector(*direction),
            Light::Ambient { .. } => {}
        }
        moved
    }

    fn object(&self, file: &File, object: &Object) -> Object {
        let mut moved = object.clone();
        let in_group = |moved: Object| {
            let (transform, objects) = (vec![self.step], vec![moved]);
            Object::Group { transform, objects, material: None }
        };
        match &mut moved {
            // A texture stays with a center or a point, but does not turn or grow.
            Object::Sphere { material, .. } | Object::Plane { material, .. }
                if !self.is_translation() && objects::is_textured(file, material.as_ref()) =>
            {
                return in_group(moved);
            }
            Object::Sphere { center, radius, .. } => {
                (*center, *radius) = (self.point(*center), self.length(*radius));
            }
            Object::Triangle { a, b, c, .. } => {
                (*a, *b, *c) = (self.point(*a), self.point(*b), self.point(*c));
                if self.is_mirror() {
                    // Its front is where it goes around counter-clockwise.
                    std::mem::swap(b, c);
                }
            }
            Object::Box { min, max, .. } => {
                let (p, q) = (self.point(*min), self.point(*max));
                *min = std::array::from_fn(|i| p[i].min(q[i]));
                *max = std::array::from_fn(|i| p[i].max(q[i]));
            }
            Object::Plane { point, normal, .. } => {
                (*point, *normal) = (self.point(*point), self.vector(*normal));
            }
            Object::Disk { center, normal, radius, .. } => {
                (*center, *normal) = (self.point(*center), self.vector(*normal));
                *radius = self.length(*radius);
            }
            Object::Torus { center, axis, major_radius, minor_radius, .. } => {
                (*center, *axis) = (self.point(*center), self.vector(*axis));
                *major_radius = self.length(*major_radius);
                *minor_radius = self.length(*minor_radius);
            }
            Object::Cylinder { a, b, radius, .. }
            | Object::Cone { apex: a, base: b, radius, .. } => {
                (*a, *b, *radius) = (self.point(*a), self.point(*b), self.length(*radius));
            }
            Object::Group { transform, .. } => transform.push(self.step),
            // Its file stays as it is.
            Object::Mesh { .. } => return in_group(moved),
        }
        moved
    }
}
