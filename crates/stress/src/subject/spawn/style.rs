//! The kinds of places that rays are spawned at: how large the object is, how
//! far from the origin, from how far it is seen and how flatly it is left.

use tracer::glam::DVec3;

use super::super::chain::Limits;
use super::object::Object;
use crate::Random;
use crate::meshes::Place;

/// One kind of place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Style {
    /// The family's name.
    pub(super) name: &'static str,
    /// The object's size.
    sizes: (f64, f64),
    /// How far its center is from the origin, in sizes.
    center: f64,
    /// From how far it is seen, in sizes.
    distances: (f64, f64),
    /// The least cosine between the normal and what leaves.
    flattest: f64,
    /// Corners with coordinates of any size between 1e-8 and 1e8, as in
    /// pbrt-v4's test.
    pub(super) any_coordinates: bool,
    /// Inside transforms that do no more than this.
    pub(super) instances: Option<Limits>,
}

const UNIT: Style = Style {
    name: "unit-scale",
    sizes: (0.1, 10.0),
    center: 1.0,
    distances: (2.0, 10.0),
    flattest: 1e-3,
    any_coordinates: false,
    instances: None,
};

/// Every kind.
pub(super) const STYLES: [Style; 9] = [
    UNIT,
    Style { name: "world-1e4", sizes: (1.0, 1.0), center: 1e4, ..UNIT },
    Style { name: "small-1e-4", sizes: (1e-4, 1e-4), center: 1e4, ..UNIT },
    Style { name: "coordinates-1e8", any_coordinates: true, ..UNIT },
    Style { name: "grazing", flattest: 1e-6, ..UNIT },
    Style { name: "center-1e3", sizes: (1e-6, 1e12), center: 1e3, ..UNIT },
    Style { name: "center-1e5", sizes: (1e-6, 1e12), center: 1e5, ..UNIT },
    Style { name: "seen-from-1e4", distances: (1e4, 1e4), ..UNIT },
    Style {
        name: "instances",
        sizes: (1.0, 1.0),
        instances: Some(Limits { scale: 1e6, translation: 1e8, sizes: 1e4 }),
        ..UNIT
    },
];

/// How many meshes a family has.
const BALLS: usize = 16;

impl Style {
    /// The places of the family's meshes.
    pub(super) fn balls(&self) -> Vec<Place> {
        let mut random = Random::of_chunk(0, self.name, 0);
        (0..BALLS).map(|_| self.place(&mut random)).collect()
    }

    fn place(&self, random: &mut Random) -> Place {
        let scale = self.size(random);
        Place { scale, offset: random.direction() * (scale * self.center), single: false }
    }

    fn size(&self, random: &mut Random) -> f64 {
        random.decades(self.sizes.0, self.sizes.1)
    }

    /// From how far the object is seen, in sizes.
    pub(super) fn distance(&self, random: &mut Random) -> f64 {
        random.decades(self.distances.0, self.distances.1)
    }

    /// Between the normal and what leaves.
    pub(super) fn cosine(&self, random: &mut Random) -> f64 {
        if random.coin() {
            random.decades(self.flattest, 1.0)
        } else {
            random.unit().max(self.flattest)
        }
    }

    /// An object, a point on or in it, and its size.
    pub(super) fn object(&self, random: &mut Random) -> (Object, DVec3, f64) {
        if self.any_coordinates {
            return any_coordinates(random);
        }
        let kind = random.below(9);
        if kind == 5 {
            let number = random.below(BALLS);
            let Place { scale, offset, .. } = self.balls()[number];
            return (Object::Mesh { number }, offset + 0.5 * scale * random.direction(), scale);
        }
        let Place { scale: size, offset: center, .. } = self.place(random);
        let (object, target) = match kind {
            0 => {
                let target = center + random.direction() * (0.9 * size * random.unit());
                (Object::Sphere { center, radius: size }, target)
            }
            1 => {
                let corners = [random.point(), random.point(), random.point()];
                let corners = corners.map(|p| center + size * p);
                (Object::Triangle(corners), within(corners, random))
            }
            2 => {
                let half = 0.5 * size * (DVec3::splat(0.1) + random.point().abs());
                let target = center + 0.9 * half * random.point();
                (Object::Box { min: center - half, max: center + half }, target)
            }
            3 | 4 => flat(kind, center, size, random),
            _ => round(kind, center, size, random),
        };
        (object, target, size)
    }
}

/// A cylinder, a cone or a torus, about any direction or an axis, and a point
/// in it.
fn round(kind: usize, center: DVec3, size: f64, random: &mut Random) -> (Object, DVec3) {
    let any = random.direction();
    let axis = size * random.one_of(&[any, any, DVec3::X, DVec3::Y, DVec3::Z]);
    let (radius, out) = (size * random.between(0.1, 1.0), random.across(axis));
    let (ends, share) = ([center - axis, center + axis], random.unit());
    match kind {
        6 => {
            let inside = center + axis * random.between(-0.9, 0.9) + out * (0.9 * radius * share);
            (Object::Cylinder { ends, radius }, inside)
        }
        7 => {
            let part = random.between(0.05, 0.95);
            let inside = ends[0] + (2.0 * axis + out * (0.9 * radius * share)) * part;
            (Object::Cone { ends, radius }, inside)
        }
        _ => {
            let minor = 0.9 * radius;
            let inside = center + out * (size + 0.9 * minor * random.between(-1.0, 1.0));
            (Object::Torus { center, axis, major: size, minor }, inside)
        }
    }
}

/// A disk or a plane, across any direction or an axis.
fn flat(kind: usize, center: DVec3, radius: f64, random: &mut Random) -> (Object, DVec3) {
    let any = random.direction();
    let normal = random.one_of(&[any, any, DVec3::X, DVec3::Y, DVec3::Z]);
    let target = center + random.across(normal) * (0.9 * radius * random.unit());
    match kind {
        3 => (Object::Disk { center, normal, radius }, target),
        _ => (Object::Plane { point: center, normal }, target),
    }
}

/// A point inside a triangle.
fn within([a, b, c]: [DVec3; 3], random: &mut Random) -> DVec3 {
    let (s, t) = (random.unit(), random.unit());
    let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
    a + s * (b - a) + t * (c - a)
}

/// Objects whose coordinates are of any size, each on its own.
fn any_coordinates(random: &mut Random) -> (Object, DVec3, f64) {
    let point = |random: &mut Random| {
        let mut number = || random.sign() * random.decades(1e-8, 1e8);
        DVec3::new(number(), number(), number())
    };
    let center = point(random);
    let size = center.length() * random.decades(1e-3, 1e3);
    match random.below(6) {
        0 => {
            let target = center + random.direction() * (0.9 * size * random.unit());
            (Object::Sphere { center, radius: size }, target, size)
        }
        1 => {
            let other = point(random);
            let (min, max) = (center.min(other), center.max(other));
            let share = DVec3::new(random.unit(), random.unit(), random.unit());
            (Object::Box { min, max }, min + share * (max - min), (max - min).length())
        }
        kind @ (3 | 4) => {
            let (object, target) = flat(kind, center, size, random);
            (object, target, size)
        }
        _ => {
            let corners = [center, point(random), point(random)];
            let [a, b, c] = corners;
            let size = (b - a).length().max((c - a).length());
            (Object::Triangle(corners), within(corners, random), size)
        }
    }
}
