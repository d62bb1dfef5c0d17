//! A scene for every whole number: all shapes, materials, lights, conventions
//! and kinds of view, in groups of all kinds of transform.

use tracer::accel::Build;
use tracer::glam::{DAffine3, DMat3, DVec3};
use tracer::shape::{
    AxisBox, Cone, Cylinder, Disk, Mesh, MeshNormals, Plane, Shape, Sphere, Torus, Triangle,
};
use tracer::{
    Camera, Convention, Falloff, Filter, Group, Light, Material, Member, Object, Projection,
    Refused, Rgb, Samples, Scene, SceneParts, Show, Size, Transform, View,
};

use crate::Random;

/// Small: there are many. No side is a multiple of another or of a vector's
/// lanes.
const SIZE: Size = Size { width: 37, height: 29 };

/// What a ray sees that hits nothing.
pub(super) const BACKGROUND: Rgb = Rgb::new(0.013, 0.027, 0.051);

/// Half the width of the space with things in it.
const REACH: f64 = 3.0;

/// How deep groups are nested at most.
const DEEPEST: u32 = 3;

/// The scene of this number, the same on every system.
///
/// # Errors
/// None that is known: a refusal of one of the tracer's constructors, whose
/// numbers are all within what they take.
pub(super) fn random_scene(number: u64, build: Build) -> Result<Scene, Refused> {
    let random = &mut Random::of_chunk(number, "image/random-scene", 0);
    let mut members = vec![group(random, build, DEEPEST)?];
    for _ in 0..4 + random.below(8) {
        members.push(object(random, build)?);
    }
    // Ground to stand on, in most.
    if random.below(4) > 0 {
        let ground = Plane::new(DVec3::new(0.0, -REACH, 0.0), around(random, DVec3::Y, 0.1))?;
        members.push(Member::Object(Object::new(ground.into(), material(random)?)));
    }
    let mut lights = vec![Light::ambient(color(random) * 0.2)?];
    for _ in 0..=random.below(3) {
        lights.push(light(random)?);
    }
    Scene::new(SceneParts {
        camera: camera(random)?,
        size: SIZE,
        samples: Samples::grid(random.one_of(&[1, 1, 1, 4, 9]))?,
        filter: Filter::BOX,
        error: None,
        world: Group::new(Transform::IDENTITY, members, build),
        lights,
        convention: random.one_of(&[
            Convention::Classic,
            Convention::Attenuated,
            Convention::Radiometric,
        ]),
        shadows: random.below(8) > 0,
        bounces: Scene::DEFAULT_BOUNCES,
        background: BACKGROUND,
        exposure: 1.0,
        show: show(random),
    })
}

fn show(random: &mut Random) -> Show {
    match random.below(12) {
        0 => Show::Normals,
        1 => Show::Depth { near: 2.0, far: 20.0 },
        2 => Show::SurfaceColor,
        _ => Show::Shaded,
    }
}

fn camera(random: &mut Random) -> Result<Camera, Refused> {
    let aspect = f64::from(SIZE.width) / f64::from(SIZE.height);
    let eye = random.direction() * random.between(1.5, 3.0) * REACH;
    let up = random.across(eye);
    if random.coin() {
        let fov_deg = random.between(35.0, 70.0);
        return Camera::look_at(eye, random.point(), up, fov_deg, aspect);
    }
    let view_height = random.between(0.6, 1.4) * REACH;
    let proj_normal = random.coin().then(|| around(random, eye, 0.5));
    let view = View {
        view_point: eye,
        view_dir: -eye,
        view_up: up,
        proj_normal,
        view_width: view_height * aspect,
        view_height,
    };
    let perspective = Projection::Perspective { proj_distance: random.between(2.5, 5.0) };
    Camera::new(&view, if random.coin() { perspective } else { Projection::Parallel })
}

fn light(random: &mut Random) -> Result<Light, Refused> {
    let place = random.direction() * random.between(2.0, 4.0) * REACH;
    let intensity = color(random);
    match random.below(3) {
        0 => Light::directional(-place, intensity),
        1 => Light::point(place, intensity, Falloff::Constant),
        _ => Light::point(place, intensity * place.length_squared(), Falloff::InverseSquare),
    }
}

fn group(random: &mut Random, build: Build, depth: u32) -> Result<Member, Refused> {
    let mut members = Vec::new();
    for _ in 0..2 + random.below(4) {
        members.push(object(random, build)?);
    }
    if depth > 1 && random.below(4) > 0 {
        members.push(group(random, build, depth - 1)?);
    }
    Ok(Member::Group(Group::new(transform(random)?, members, build)))
}

/// The sparse scene of this number: a thing or a few, seen from among them or
/// from their very surfaces, so that much of the picture shows none and some are
/// behind; now and then very many. For all that a plan may leave out.
///
/// # Errors
/// As [`random_scene`].
pub(super) fn sparse_scene(number: u64) -> Result<Scene, Refused> {
    let random = &mut Random::of_chunk(number, "image/sparse-scene", 0);
    let size = Size { width: 67, height: 53 };
    let is_many = random.below(10) == 0;
    // A list of many would take all the time there is.
    let build = if is_many || random.coin() { Build::Bvh } else { Build::List };
    let mut members = Vec::new();
    // Many: around the most that a plan tells apart.
    let count =
        if is_many { random.one_of(&[61, 62, 63, 64, 65, 90]) } else { 1 + random.below(8) };
    for _ in 0..count {
        members.push(object(random, build)?);
    }
    match random.below(6) {
        0 => members.push(group(random, build, 2)?),
        1 => {
            let ground = Plane::new(random.point() * REACH, random.direction())?;
            let ground = Member::Object(Object::new(ground.into(), material(random)?));
            // A group of nothing beside it.
            members.push(Member::Group(Group::new(transform(random)?, vec![], build)));
            members.push(ground);
        }
        2 => {
            let ground = Plane::new(random.point() * REACH, random.direction())?;
            let ground = Member::Object(Object::new(ground.into(), material(random)?));
            members.push(Member::Group(Group::new(transform(random)?, vec![ground], build)));
        }
        _ => {}
    }
    let samples = random.one_of(&[1, 4]);
    Scene::new(SceneParts {
        camera: sparse_camera(random, size)?,
        size,
        samples: Samples::grid(samples)?,
        filter: Filter::BOX,
        error: (samples == 1 && !is_many && random.coin()).then_some(0.1),
        world: Group::new(Transform::IDENTITY, members, build),
        lights: vec![light(random)?, light(random)?],
        convention: random.one_of(&[
            Convention::Classic,
            Convention::Attenuated,
            Convention::Radiometric,
        ]),
        shadows: random.below(8) > 0,
        bounces: Scene::DEFAULT_BOUNCES,
        background: BACKGROUND,
        exposure: 1.3,
        show: show(random),
    })
}

/// Wide or narrow, oblique or straight, along an axis or not.
fn sparse_camera(random: &mut Random, size: Size) -> Result<Camera, Refused> {
    let aspect = f64::from(size.width) / f64::from(size.height);
    let any = random.direction();
    let away = random.one_of(&[any, any, DVec3::X, -DVec3::Y, DVec3::Z]);
    let up = random.across(away);
    let eye = random.direction() * random.between(0.0, 4.0) * REACH;
    if random.coin() {
        return Camera::look_at(eye, eye + away, up, random.between(5.0, 170.0), aspect);
    }
    let view_height = random.decades(0.1, 10.0);
    let view = View {
        view_point: eye,
        view_dir: away,
        view_up: up,
        // Up to flat against the view.
        proj_normal: random.coin().then(|| around(random, -away, 0.999)),
        view_width: view_height * aspect,
        view_height,
    };
    let perspective = Projection::Perspective { proj_distance: random.decades(0.05, 5.0) };
    Camera::new(&view, if random.coin() { perspective } else { Projection::Parallel })
}

/// Turned, stretched, sheared or mirrored, and moved.
fn transform(random: &mut Random) -> Result<Transform, Refused> {
    let turn = Transform::rotation_deg(random.point() * 180.0)?;
    let mut stretch = || random.sign() * random.between(0.6, 1.4);
    let scale = Transform::scale(DVec3::new(stretch(), stretch(), stretch()))?;
    let mut shear = DMat3::IDENTITY;
    shear.y_axis.x = random.between(-0.5, 0.5);
    let shear = Transform::new(DAffine3::from_mat3(shear))?;
    let moved = Transform::translation(random.point() * REACH * 0.5)?;
    match random.below(4) {
        0 => moved.then(turn),
        1 => turn.then(scale)?.then(moved),
        2 => turn.then(shear)?.then(scale)?.then(moved),
        _ => Ok(Transform::IDENTITY),
    }
}

fn object(random: &mut Random, build: Build) -> Result<Member, Refused> {
    let at = random.point() * REACH;
    let size = random.between(0.2, 1.1);
    let shape: Shape = match random.below(9) {
        0 => Sphere::new(at, size)?.into(),
        1 => {
            let half = (random.point().abs() + 0.1) * size;
            AxisBox::new(at - half, at + half)?.into()
        }
        2 => {
            let mut corner = || at + random.direction() * size * 1.5;
            Triangle::new(corner(), corner(), corner())?.into()
        }
        3 => Disk::new(at, random.direction(), size)?.into(),
        4 => Cylinder::new(at, at + random.direction() * size, 0.5 * size, random.coin())?.into(),
        5 => Cone::new(at, at + random.direction() * size, 0.7 * size, random.coin())?.into(),
        6 => Torus::new(at, random.direction(), size, size * random.between(0.1, 0.9))?.into(),
        _ => mesh(random, at, size, build)?.into(),
    };
    Ok(Member::Object(Object::new(shape, material(random)?)))
}

/// A bumpy patch or a bumpy ball's band: `SIDE` by `SIDE` squares of two
/// triangles, with smooth normals in half of them.
fn mesh(random: &mut Random, at: DVec3, size: f64, build: Build) -> Result<Mesh, Refused> {
    const SIDE: u32 = 5;
    let (x, bumps) = (random.direction(), random.between(0.05, 0.3));
    let y = random.across(x);
    let (z, bent) = (x.cross(y), random.coin());
    let mut vertices = Vec::new();
    let mut normals = Vec::new();
    for j in 0..=SIDE {
        for i in 0..=SIDE {
            let part = |k: u32| 2.0 * f64::from(k) / f64::from(SIDE) - 1.0;
            let flat = x * part(i) + y * part(j);
            let normal = if bent { (flat + z).normalize() } else { z };
            let base = if bent { normal } else { flat };
            vertices.push(at + size * (base + normal * bumps * random.unit()));
            normals.push(normal + random.point() * bumps);
        }
    }
    let corner = |i: u32, j: u32| j * (SIDE + 1) + i;
    let square = |(i, j): (u32, u32)| {
        let [a, b] = [corner(i, j), corner(i + 1, j)];
        let [c, d] = [corner(i + 1, j + 1), corner(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let squares = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
    let faces: Vec<_> = squares.flat_map(square).collect();
    let normals = random.coin().then(|| MeshNormals { normals, faces: faces.clone() });
    Mesh::new(vertices, faces, normals, build)
}

fn material(random: &mut Random) -> Result<Material, Refused> {
    match random.below(8) {
        0 => Material::Constant(color(random)),
        1 => Material::Normal,
        2..=4 => Material::Lambert { diffuse: color(random) },
        _ => Material::BlinnPhong {
            diffuse: color(random),
            specular: color(random) * 0.5,
            // Whole powers are the ones that a library might do differently.
            exponent: if random.coin() { 20.0 } else { random.decades(0.5, 500.0) },
        },
    }
    .checked()
}

fn color(random: &mut Random) -> Rgb {
    let mut channel = || random.between(0.05, 1.0);
    Rgb::new(channel(), channel(), channel())
}

/// A direction within some share of its length of this one.
fn around(random: &mut Random, axis: DVec3, share: f64) -> DVec3 {
    axis + random.direction() * axis.length() * share
}
