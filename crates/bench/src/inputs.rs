//! Generated inputs of any size: meshes, clouds of spheres, rays, scenes and
//! pictures, the same on every machine.

use std::fmt::Write as _;

use harness::encode::EncodedImage;
use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{Mesh, Shape, Sphere};
use tracer::{Group, LinearImage, Material, Member, Object, Ray, Rgb, Scene, Size, Transform};

use crate::random::Random;

/// How many faces a cube has, and triangles a square.
const TRIANGLES_PER_CELL: usize = 6 * 2;

/// How far from the middle rays start, where everything is within 2.
const FAR: f64 = 5.0;

/// A closed bumpy ball of about this many triangles: the faces of a cube cut
/// into squares and drawn onto a sphere whose radius waves.
///
/// # Errors
/// What the mesh refuses.
pub(crate) fn bumpy_ball(triangles: usize, build: Build) -> Result<Mesh, String> {
    let (vertices, faces) = bumpy_ball_parts(triangles);
    Mesh::new(vertices, faces, None, build).map_err(|refused| refused.to_string())
}

/// The corners of [`bumpy_ball`], and the three of each triangle.
pub(crate) fn bumpy_ball_parts(triangles: usize) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let side = (triangles as f64 / TRIANGLES_PER_CELL as f64).sqrt().round().max(1.0) as u32;
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for face in 0..6 {
        let first = vertices.len() as u32;
        for row in 0..=side {
            for column in 0..=side {
                let at = |k: u32| f64::from(k) / f64::from(side) * 2.0 - 1.0;
                let p = on_cube(face, at(column), at(row)).normalize();
                vertices.push(p * radius(p));
            }
        }
        for row in 0..side {
            for column in 0..side {
                let a = first + row * (side + 1) + column;
                let (b, c, d) = (a + 1, a + side + 1, a + side + 2);
                faces.extend([[a, b, d], [a, d, c]]);
            }
        }
    }
    (vertices, faces)
}

/// The point of a cube's face, counter-clockwise seen from outside.
fn on_cube(face: u32, x: f64, y: f64) -> DVec3 {
    match face {
        0 => DVec3::new(1.0, x, y),
        1 => DVec3::new(-1.0, y, x),
        2 => DVec3::new(y, 1.0, x),
        3 => DVec3::new(x, -1.0, y),
        4 => DVec3::new(x, y, 1.0),
        _ => DVec3::new(y, x, -1.0),
    }
}

/// From 0.7 to 1.3, in waves of a few sizes made without a sine.
fn radius(p: DVec3) -> f64 {
    let wave = |x: f64| {
        let part = x - x.floor();
        16.0 * part * part * (1.0 - part) * (1.0 - part)
    };
    let waves = |k: f64| (wave(k * p.x) + wave(k * p.y) + wave(k * p.z)) / 3.0;
    0.7 + 0.4 * waves(1.5) + 0.2 * waves(7.0)
}

/// A group of this many spheres in a cube, of which about the same share is
/// full however many there are.
///
/// # Errors
/// What a sphere refuses.
pub(crate) fn spheres(count: usize) -> Result<Group, String> {
    /// A sphere's radius in the room that each has.
    const SHARE: f64 = 0.4;
    let mut random = Random::new(count as u64);
    let room = 2.0 / (count as f64).cbrt();
    let mut member = || {
        let radius = SHARE * room * random.between(0.5, 1.0);
        let sphere = Sphere::new(random.point(), radius).map_err(|refused| refused.to_string())?;
        Ok(Member::Object(Object::new(Shape::Sphere(sphere), Material::Constant(Rgb::WHITE))))
    };
    let members = (0..count).map(|_| member()).collect::<Result<_, String>>()?;
    Ok(Group::new(Transform::IDENTITY, members, Build::default()))
}

/// Rays from all around at points of the cube of half side 1.
pub(crate) fn rays(count: usize) -> Vec<Ray> {
    let mut random = Random::new(1);
    let mut ray = || {
        let origin = random.direction() * FAR;
        Ray::new(origin, (random.point() - origin) * random.between(0.5, 2.0))
    };
    (0..count).map(|_| ray()).collect()
}

/// Eye rays of a square picture of `side` pixels a side, in tiles of 8 by 8.
pub(crate) fn eye_rays(side: u32) -> Vec<Ray> {
    const TILE: u32 = 8;
    let tiles = side.div_ceil(TILE);
    let eye = DVec3::new(0.4, 0.9, FAR);
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(side) * 2.0 - 1.0;
    let mut rays = Vec::new();
    for tile in 0..tiles * tiles {
        for pixel in 0..TILE * TILE {
            let x = tile % tiles * TILE + pixel % TILE;
            let y = tile / tiles * TILE + pixel / TILE;
            if x < side && y < side {
                rays.push(Ray::new(eye, DVec3::new(at(x), at(y), 0.0) * 1.4 - eye));
            }
        }
    }
    rays
}

/// The text of a scene of every analytic kind of thing, under this many lights.
pub(crate) fn scene_text((width, height): (u32, u32), lights: usize) -> String {
    let mut random = Random::new(2);
    let mut objects = String::new();
    for k in 0..12 {
        let (x, z) = (f64::from(k % 4) * 1.4 - 2.1, f64::from(k / 4) * 1.6 - 1.6);
        let material = ["clay", "glaze", "chalk"][k as usize % 3];
        let shape = match k % 4 {
            0 => format!("Sphere(center: ({x}, 0.1, {z}), radius: 0.6"),
            1 => format!("Box(min: ({}, -0.5, {z}), max: ({}, 0.5, {})", x - 0.4, x + 0.4, z + 0.8),
            2 => format!("Cylinder(a: ({x}, -0.5, {z}), b: ({x}, 0.6, {z}), radius: 0.4"),
            _ => format!("Cone(apex: ({x}, 0.8, {z}), base: ({x}, -0.5, {z}), radius: 0.5"),
        };
        // Writing into a string does not fail.
        let _ = writeln!(objects, "        {shape}, material: Named(\"{material}\")),");
    }
    let mut lamps = String::new();
    for _ in 0..lights {
        let (x, y, z) = (random.between(-6.0, 6.0), random.between(3.0, 8.0), random.unit() * 8.0);
        let share = 1.0 / lights as f64;
        let _ = writeln!(
            lamps,
            "        Point(position: ({x:.3}, {y:.3}, {z:.3}), intensity: ({share}, {share}, {share})),"
        );
    }
    format!(
        "(
    version: 1,
    image: ({width}, {height}),
    camera: LookAt(eye: (1.5, 3.2, 9), at: (0, 0, 0), fov_deg: 32),
    background: (0.2, 0.25, 0.3),
    materials: {{
        \"clay\": Lambert(diffuse: (0.8, 0.45, 0.3)),
        \"glaze\": BlinnPhong(diffuse: (0.1, 0.4, 0.42), specular: (0.5, 0.5, 0.5), exponent: 30),
        \"chalk\": Lambert(diffuse: (0.8, 0.8, 0.75)),
    }},
    objects: [
        Plane(point: (0, -0.5, 0), normal: (0, 1, 0), material: Named(\"chalk\")),
{objects}    ],
    lights: [
{lamps}    ],
)
"
    )
}

/// The scene of [`scene_text`].
///
/// # Errors
/// The text of its problems, of which it has none.
pub(crate) fn scene(size: (u32, u32), lights: usize) -> Result<Scene, String> {
    parse(&scene_text(size, lights))
}

/// The scene of a text that names no files.
///
/// # Errors
/// The text's problems, for people.
pub(crate) fn parse(text: &str) -> Result<Scene, String> {
    match scene::load::<scene::Unchecked>(text, &scene::NoAssets, Build::default()) {
        Ok(loaded) => Ok(loaded.scene),
        Err(problems) => Err(scene::report("generated", text, &problems)),
    }
}

/// A smooth picture of this size, its colors from 0 to a little above 1.
pub(crate) fn linear_picture(width: u32, height: u32) -> LinearImage {
    LinearImage::from_fn(Size { width, height }, |x, y| {
        let (x, y) = (f64::from(x) / f64::from(width), f64::from(y) / f64::from(height));
        Rgb::new(1.1 * x, x * y, (1.0 - y) * (1.0 - y))
    })
}

/// Two 8-bit pictures of this size that differ by up to 3 in each channel.
pub(crate) fn unlike_pictures(width: u32, height: u32) -> [EncodedImage; 2] {
    /// The mask of the differences.
    const FEW: u8 = 3;
    let mut random = Random::new(3);
    let wave = |x: u32, y: u32| [(x ^ y) as u8 / 2, (x / 3 + y) as u8 / 2, (x * y / 64) as u8 / 2];
    let size = Size { width, height };
    let golden = EncodedImage::from_fn(size, wave);
    let actual = EncodedImage::from_fn(size, |x, y| wave(x, y).map(|v| v + (random.byte() & FEW)));
    [golden, actual]
}

#[cfg(test)]
mod tests {
    use tracer::Interval;
    use tracer::shape::Geometry;

    use super::*;

    #[test]
    fn the_ball_is_closed_and_of_the_size_asked_for() {
        for triangles in [12, 1_000, 20_000] {
            let ball = bumpy_ball(triangles, Build::Bvh).unwrap();
            let found = ball.triangle_count() as f64;
            assert!((found / triangles as f64 - 1.0).abs() < 0.1, "{found} for {triangles}");
            let rays = rays(200);
            assert!(rays.iter().any(|ray| ball.intersect(ray, Interval::AHEAD).is_some()));
            for ray in &rays {
                assert_eq!(ball.crossings(ray, Interval::AHEAD) % 2, 0, "{ray:?}");
                let inside = Ray::new(DVec3::ZERO, ray.direction);
                assert_eq!(ball.crossings(&inside, Interval::AHEAD), 1, "{ray:?}");
                let hit = ball.intersect(&inside, Interval::AHEAD).unwrap();
                let normal = *ball.surface(&inside, &hit).geometric_normal;
                assert!(normal.dot(inside.direction) > 0.0, "faces outward");
            }
        }
    }

    #[test]
    fn the_scene_is_valid_and_has_its_lights() {
        for lights in [1, 32] {
            let scene = scene((8, 6), lights).unwrap();
            assert_eq!(scene.parts().lights.len(), lights);
            assert!(scene_text((8, 6), lights).contains("Cone"));
        }
    }

    #[test]
    fn eye_rays_are_one_a_pixel() {
        assert_eq!(eye_rays(20).len(), 400);
    }
}
