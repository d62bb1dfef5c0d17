//! What else is done for a ray: made by a camera, taken into a group and back,
//! shaded.

use std::hint::black_box;

use tracer::glam::{DAffine3, DMat3, DVec3};
use tracer::shape::{Shape, Sphere};
use tracer::{
    Camera, Convention, Group, Hit, Interval, Material, Member, Object, Projection, Ray, Refused,
    Rgb, Transform, UnitVec, View, pixel_center,
};

use super::{CASES, Kernel};
use crate::inputs;
use crate::random::Random;

/// A side of the picture whose rays are made: [`CASES`] pixels.
const SIDE: u32 = 64;

pub(super) fn all() -> Result<Vec<Kernel>, String> {
    let mut all = cameras().map_err(|refused| refused.to_string())?;
    all.extend(transforms().map_err(|refused| refused.to_string())?);
    all.extend(shading());
    Ok(all)
}

fn cameras() -> Result<Vec<Kernel>, Refused> {
    let view = View {
        view_point: DVec3::new(1.0, 2.0, 5.0),
        view_dir: DVec3::new(-0.1, -0.4, -1.0),
        view_up: DVec3::Y,
        proj_normal: None,
        view_width: 2.0,
        view_height: 1.5,
    };
    let kernel = |name, projection| -> Result<Kernel, Refused> {
        let camera = Camera::new(&view, projection)?;
        let pass = move || {
            let mut sum = 0.0;
            for j in 0..SIDE {
                let b = pixel_center(j, SIDE, camera.view_height());
                for i in 0..SIDE {
                    let a = pixel_center(i, SIDE, camera.view_width());
                    // All of the ray is made, as one that is traced must be.
                    sum += black_box(camera.ray(a, b)).direction.x;
                }
            }
            sum
        };
        let tests = (SIDE * SIDE) as usize;
        Ok(Kernel { group: "camera", name, tests, pass: Box::new(pass) })
    };
    Ok(vec![
        kernel("perspective", Projection::Perspective { proj_distance: 2.0 })?,
        kernel("parallel", Projection::Parallel)?,
    ])
}

fn transforms() -> Result<Vec<Kernel>, Refused> {
    let columns =
        [DVec3::new(0.8, 0.1, -0.3), DVec3::new(-0.2, 1.3, 0.1), DVec3::new(0.4, 0.0, 0.9)];
    let transform = Transform::new(DAffine3 {
        matrix3: DMat3::from_cols(columns[0], columns[1], columns[2]),
        translation: DVec3::new(0.2, -0.1, 0.3),
    })?;
    let ball = || -> Result<Vec<Member>, Refused> {
        let ball = Shape::Sphere(Sphere::new(DVec3::ZERO, 1.2)?);
        Ok(vec![Member::Object(Object::new(ball, Material::Constant(Rgb::WHITE)))])
    };
    let plain = Group::world(ball()?);
    let placed = Group::new(transform, ball()?, tracer::accel::Build::default());
    let rays = inputs::rays(CASES);
    let hits: Vec<Hit> =
        rays.iter().filter_map(|ray| plain.intersect(ray, Interval::AHEAD)).collect();
    let closest = |name, group: Group, rays: Vec<Ray>| Kernel {
        group: "group of one sphere",
        name,
        tests: rays.len(),
        pass: Box::new(move || {
            let t = |ray| group.intersect(ray, Interval::AHEAD).map_or(0.0, |hit| hit.t);
            rays.iter().map(t).sum()
        }),
    };
    let matrices = Random::new(6);
    Ok(vec![
        made(matrices),
        Kernel {
            group: "transform",
            name: "ray in",
            tests: rays.len(),
            pass: {
                let rays = rays.clone();
                Box::new(move || {
                    let inside = |ray| black_box(transform.object_from_parent(ray)).direction.x;
                    rays.iter().map(inside).sum()
                })
            },
        },
        Kernel {
            group: "transform",
            name: "hit out",
            tests: hits.len(),
            pass: Box::new(move || {
                let outside = |hit: &Hit| black_box(transform.parent_from_object(*hit)).point.x;
                hits.iter().map(outside).sum()
            }),
        },
        closest("plain", plain, rays.clone()),
        closest("placed", placed, rays),
    ])
}

/// Transforms made from their matrices.
fn made(mut random: Random) -> Kernel {
    let mut matrix = || DAffine3 {
        // Near the identity: each has an inverse.
        matrix3: DMat3::IDENTITY
            + DMat3::from_cols(random.point() * 0.2, random.point() * 0.2, random.point() * 0.2),
        translation: random.point(),
    };
    let matrices: Vec<_> = (0..CASES).map(|_| matrix()).collect();
    let is_made = |matrix: &DAffine3| Transform::new(*matrix).is_ok();
    Kernel {
        group: "transform",
        name: "made",
        tests: matrices.len(),
        pass: Box::new(move || matrices.iter().filter(|matrix| is_made(matrix)).count() as f64),
    }
}

/// The reflection of light on the glossy material.
fn shading() -> Vec<Kernel> {
    let material = Material::BlinnPhong {
        diffuse: Rgb::new(0.6, 0.4, 0.2),
        specular: Rgb::new(0.5, 0.5, 0.5),
        exponent: 40.0,
    };
    let mut random = Random::new(7);
    // In the same half space, as all of a lit surface's are.
    let mut around = || UnitVec::new(random.direction() + DVec3::Y * 1.5).unwrap_or(UnitVec::Y);
    let directions: Vec<[UnitVec; 3]> =
        (0..CASES).map(|_| [around(), around(), around()]).collect();
    let kernel = |name, convention: Convention| {
        let directions = directions.clone();
        let reflected =
            move |&[n, l, v]: &[UnitVec; 3]| material.reflect(convention, n, l, v).channels()[0];
        let pass = move || directions.iter().map(reflected).sum();
        Kernel { group: "Blinn-Phong", name, tests: CASES, pass: Box::new(pass) }
    };
    vec![kernel("classic", Convention::Classic), kernel("radiometric", Convention::Radiometric)]
}
