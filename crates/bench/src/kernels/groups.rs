//! Groups of a few and of many shapes, for rays from all around.

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{AxisBox, Cone, Cylinder, Disk, Shape, Sphere, Torus};
use tracer::{Group, Interval, Material, Member, Object, Ray, Refused, Rgb, Transform};

use super::{CASES, Kernel};
use crate::inputs;
use crate::random::Random;

/// Spheres, and houses.
const MANY: usize = 1024;

pub(super) fn all() -> Result<Vec<Kernel>, String> {
    let mut all = of_group("group of 1024 spheres", &inputs::spheres(MANY)?);
    let made = [
        ("group of 1024 boxes, floor", city()),
        ("group of 600 rods", rods()),
        ("group of 8 shapes", mixed()),
    ];
    for (name, shapes) in made {
        let shapes = shapes.map_err(|refused| format!("{name}: {refused}"))?;
        all.extend(of_group(name, &group(shapes)));
    }
    Ok(all)
}

fn group(shapes: Vec<Shape>) -> Group {
    let object = |shape| Member::Object(Object::new(shape, Material::Constant(Rgb::WHITE)));
    Group::new(Transform::IDENTITY, shapes.into_iter().map(object).collect(), Build::default())
}

/// Houses side by side on a wide disk.
fn city() -> Result<Vec<Shape>, Refused> {
    /// Along each side of the city: as many as [`MANY`] in all.
    const HOUSES: usize = 32;
    let mut random = Random::new(8);
    let mut shapes: Vec<Shape> = vec![Disk::new(-DVec3::Y, DVec3::Y, 3.0)?.into()];
    for i in 0..HOUSES * HOUSES {
        let place = |k: usize| (k as f64 + 0.5) / HOUSES as f64 * 2.0 - 1.0;
        let (x, z) = (place(i % HOUSES), place(i / HOUSES));
        let mut half = || random.between(0.25, 0.42) * 2.0 / HOUSES as f64;
        let (width, depth) = (half(), half());
        let top = random.between(-0.95, -0.6);
        let corner = |side: f64, y: f64| DVec3::new(x + side * width, y, z + side * depth);
        shapes.push(AxisBox::new(corner(-1.0, -0.999), corner(1.0, top))?.into());
    }
    Ok(shapes)
}

/// Thin and across, so that their boxes are much larger than they.
fn rods() -> Result<Vec<Shape>, Refused> {
    const RODS: usize = 600;
    const RADIUS: f64 = 0.02;
    let mut random = Random::new(9);
    let mut rod = || {
        let end = random.point();
        Ok(Cylinder::new(end, end + random.direction() * 0.3, RADIUS, true)?.into())
    };
    (0..RODS).map(|_| rod()).collect()
}

/// Of all kinds that are not flat.
fn mixed() -> Result<Vec<Shape>, Refused> {
    const SIZE: f64 = 0.3;
    let mut random = Random::new(10);
    let mut shapes = Vec::new();
    for _ in 0..2 {
        let [a, b, c, d, e] = [(); 5].map(|()| random.point() * 0.7);
        let up = DVec3::Y * SIZE;
        shapes.extend([
            Shape::from(Sphere::new(a, SIZE)?),
            AxisBox::new(b - SIZE, b + SIZE)?.into(),
            Cylinder::new(c - up, c + up, SIZE, true)?.into(),
            if shapes.is_empty() {
                Cone::new(d + up, d - up, SIZE, true)?.into()
            } else {
                Torus::new(e, DVec3::Y, SIZE, SIZE / 4.0)?.into()
            },
        ]);
    }
    Ok(shapes)
}

/// The closest hit, and whether there is any.
fn of_group(name: &'static str, group: &Group) -> Vec<Kernel> {
    let rays = inputs::rays(CASES);
    let closest = {
        let (group, rays) = (group.clone(), rays.clone());
        let t = move |ray: &Ray| group.intersect(ray, Interval::AHEAD).map_or(0.0, |hit| hit.t);
        Box::new(move || rays.iter().map(&t).sum())
    };
    let group = group.clone();
    let any = move || rays.iter().filter(|ray| group.occludes(ray, Interval::AHEAD)).count() as f64;
    vec![
        Kernel { group: name, name: "closest", tests: CASES, pass: closest },
        Kernel { group: name, name: "any", tests: CASES, pass: Box::new(any) },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_hit_and_miss_every_group() {
        for (shapes, count) in [(city(), MANY + 1), (rods(), 600), (mixed(), 8)] {
            let shapes = shapes.unwrap();
            assert_eq!(shapes.len(), count);
            let group = group(shapes);
            let rays = inputs::rays(CASES);
            let hits = rays.iter().filter(|ray| group.occludes(ray, Interval::AHEAD)).count();
            assert!((CASES / 10..CASES).contains(&hits), "{hits}");
        }
    }
}
