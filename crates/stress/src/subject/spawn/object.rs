//! The objects that rays are spawned from, and their surfaces exactly.

use tracer::glam::DVec3;
use tracer::shape::{AxisBox, Cone, Cylinder, Disk, Plane, Shape, Sphere, Torus, Triangle};

use crate::Case;
use crate::meshes::Solid;
use crate::number::{Dd, Number, V3};

/// How many numbers of a case are an object: its kind and up to nine more.
pub(super) const NUMBERS: usize = 10;

/// An object in its own space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Object {
    Sphere {
        center: DVec3,
        radius: f64,
    },
    Triangle([DVec3; 3]),
    Box {
        min: DVec3,
        max: DVec3,
    },
    Disk {
        center: DVec3,
        normal: DVec3,
        radius: f64,
    },
    Plane {
        point: DVec3,
        normal: DVec3,
    },
    /// With caps.
    Cylinder {
        ends: [DVec3; 2],
        radius: f64,
    },
    /// With its base; the apex first.
    Cone {
        ends: [DVec3; 2],
        radius: f64,
    },
    Torus {
        center: DVec3,
        axis: DVec3,
        major: f64,
        minor: f64,
    },
    /// One of a family's meshes, all of them convex.
    Mesh {
        number: usize,
    },
}

impl Object {
    /// The case that starts with this object.
    pub(super) fn case(&self) -> Case {
        let case = |kind: f64| Case::EMPTY.with(kind);
        let mut case = match *self {
            Self::Sphere { center, radius } => case(0.0).with_point(center).with(radius),
            Self::Triangle([a, b, c]) => case(1.0).with_point(a).with_point(b).with_point(c),
            Self::Box { min, max } => case(2.0).with_point(min).with_point(max),
            Self::Disk { center, normal, radius } => {
                case(3.0).with_point(center).with_point(normal).with(radius)
            }
            Self::Plane { point, normal } => case(4.0).with_point(point).with_point(normal),
            Self::Mesh { number } => case(5.0).with(number as f64),
            Self::Cylinder { ends: [a, b], radius } => {
                case(6.0).with_point(a).with_point(b).with(radius)
            }
            Self::Cone { ends: [a, b], radius } => {
                case(7.0).with_point(a).with_point(b).with(radius)
            }
            Self::Torus { center, axis, major, minor } => {
                case(8.0).with_point(center).with_point(axis).with(major).with(minor)
            }
        };
        while case.numbers().len() < NUMBERS {
            case = case.with(0.0);
        }
        case
    }

    /// The object that a case starts with.
    pub(super) fn of_case(case: &Case) -> Self {
        let point = |i| case.point(i);
        match case.number(0) as u32 {
            0 => Self::Sphere { center: point(1), radius: case.number(4) },
            1 => Self::Triangle([point(1), point(4), point(7)]),
            2 => Self::Box { min: point(1), max: point(4) },
            3 => Self::Disk { center: point(1), normal: point(4), radius: case.number(7) },
            4 => Self::Plane { point: point(1), normal: point(4) },
            6 => Self::Cylinder { ends: [point(1), point(4)], radius: case.number(7) },
            7 => Self::Cone { ends: [point(1), point(4)], radius: case.number(7) },
            8 => Self::Torus {
                center: point(1),
                axis: point(4),
                major: case.number(7),
                minor: case.number(8),
            },
            _ => Self::Mesh { number: case.number(1) as usize },
        }
    }

    /// The tracer's shape; `None` for a mesh, and if it is refused.
    pub(super) fn shape(&self) -> Option<Shape> {
        Some(match *self {
            Self::Sphere { center, radius } => Sphere::new(center, radius).ok()?.into(),
            Self::Triangle([a, b, c]) => Triangle::new(a, b, c).ok()?.into(),
            Self::Box { min, max } => AxisBox::new(min, max).ok()?.into(),
            Self::Disk { center, normal, radius } => Disk::new(center, normal, radius).ok()?.into(),
            Self::Plane { point, normal } => Plane::new(point, normal).ok()?.into(),
            Self::Cylinder { ends: [a, b], radius } => {
                Cylinder::new(a, b, radius, true).ok()?.into()
            }
            Self::Cone { ends: [a, b], radius } => Cone::new(a, b, radius, true).ok()?.into(),
            Self::Torus { center, axis, major, minor } => {
                Torus::new(center, axis, major, minor).ok()?.into()
            }
            Self::Mesh { .. } => return None,
        })
    }

    /// Whether a ray that leaves it outward may meet it again.
    pub(super) fn is_hollow(&self) -> bool {
        matches!(self, Self::Torus { .. })
    }

    /// Whether it has an inside.
    pub(super) fn is_closed(&self) -> bool {
        !matches!(self, Self::Triangle(_) | Self::Disk { .. } | Self::Plane { .. })
    }

    /// The largest of its own numbers: what its formulas round in proportion
    /// to.
    pub(super) fn extent(&self) -> f64 {
        match *self {
            Self::Sphere { center, radius } => center.length() + radius,
            Self::Box { min, max } => min.length().max(max.length()),
            _ => 0.0,
        }
    }

    /// How far `x` is outside of the surface on which `part` is, to first
    /// order, and the unit normal there.
    pub(super) fn gap(&self, part: u32, x: &V3<Dd>, solid: Option<&Solid>) -> (f64, DVec3) {
        match *self {
            Self::Sphere { center, radius } => {
                let from_center = *x - V3::of(center);
                let distance = from_center.length();
                let gap = distance - Dd::of(radius);
                (gap.to_f64(), from_center.to_f64() / distance.to_f64())
            }
            Self::Box { min, max } => {
                let (axis, higher) = (part as usize / 2 % 3, part % 2 == 1);
                let side = if higher { max[axis] } else { min[axis] };
                let sign = if higher { 1.0 } else { -1.0 };
                let along = [x.x, x.y, x.z][axis] - Dd::of(side);
                let mut normal = DVec3::ZERO;
                normal[axis] = sign;
                (sign * along.to_f64(), normal)
            }
            Self::Triangle(corners) => above(corners, x),
            Self::Disk { center: p, normal, .. } | Self::Plane { point: p, normal } => {
                height(p, &V3::of(normal), x)
            }
            Self::Cylinder { ends: [a, b], radius } => match part {
                0 => {
                    let (_, out, from_axis) = about(a, b - a, x);
                    (from_axis - radius, out)
                }
                1 => height(a, &V3::difference(a, b), x),
                _ => height(b, &V3::difference(b, a), x),
            },
            Self::Cone { ends: [apex, base], radius } => {
                if part != 0 {
                    return height(base, &V3::difference(base, apex), x);
                }
                // Across the side, which widens by the radius over the length.
                let axis = base - apex;
                let (length, (along, out, from_axis)) = (axis.length(), about(apex, axis, x));
                let side = length.hypot(radius);
                let normal = (out * length - axis * (radius / length)) / side;
                ((from_axis * length - along * radius) / side, normal)
            }
            Self::Torus { center, axis, major, minor } => {
                let (along, out, from_axis) = about(center, axis, x);
                let beyond = from_axis - major;
                let from_ring = beyond.hypot(along);
                let normal = (out * beyond + axis.normalize() * along) / from_ring;
                (from_ring - minor, normal)
            }
            Self::Mesh { .. } => solid
                .map_or((f64::INFINITY, DVec3::Z), |solid| above(solid.corners(part as usize), x)),
        }
    }

    /// The `t` at which a ray from `p`, on the surface, along `d`, inward, is
    /// at the other side, with how far rounding `p` by one unit of length
    /// moves that; `None` where the object has no inside or is a mesh.
    pub(super) fn chord(&self, p: &V3<Dd>, d: &V3<Dd>) -> Option<(f64, f64)> {
        let length = d.length().to_f64();
        match *self {
            Self::Sphere { center, radius } => {
                let toward = d.dot(&(*p - V3::of(center)));
                let t = -(toward + toward) / d.length_squared();
                let cosine = toward.to_f64().abs() / (length * radius);
                Some((t.to_f64(), 2.0 / (cosine * length)))
            }
            Self::Box { min, max } => {
                let mut first: Option<(f64, f64)> = None;
                for axis in 0..3 {
                    let along = [d.x, d.y, d.z][axis];
                    let side = if along.to_f64() > 0.0 { max[axis] } else { min[axis] };
                    let t = ((Dd::of(side) - [p.x, p.y, p.z][axis]) / along).to_f64();
                    if first.is_none_or(|(least, _)| t < least) {
                        first = Some((t, 1.0 / along.to_f64().abs()));
                    }
                }
                first
            }
            _ => None,
        }
    }
}

/// How far `x` is along the axis from `a`, the unit vector to it from the
/// axis, and how far that is.
fn about(a: DVec3, axis: DVec3, x: &V3<Dd>) -> (f64, DVec3, f64) {
    let (axis, from_a) = (V3::<Dd>::of(axis), *x - V3::of(a));
    let square = axis.length_squared();
    let along = from_a.dot(&axis);
    let across = from_a - axis.scale(&(along / square));
    let from_axis = across.length();
    let out = across.to_f64() / from_axis.to_f64();
    ((along / square.sqrt()).to_f64(), out, from_axis.to_f64())
}

/// How high `x` is above the plane of a triangle, and its normal.
fn above(corners: [DVec3; 3], x: &V3<Dd>) -> (f64, DVec3) {
    let [a, b, c] = corners;
    let normal = V3::difference(b, a).cross(&V3::difference(c, a));
    height(a, &normal, x)
}

/// How high `x` is above the plane through `p`, and its unit normal.
fn height(p: DVec3, normal: &V3<Dd>, x: &V3<Dd>) -> (f64, DVec3) {
    let length = normal.length();
    let height = (*x - V3::of(p)).dot(normal) / length;
    (height.to_f64(), normal.to_f64() / length.to_f64())
}
