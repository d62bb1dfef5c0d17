//! `FlattenGroups`: a shape in a group looks like one that lies where the group
//! puts it.

use scene::format::{Material, Object, Show, Transform, Triple};
use serde::{Deserialize, Serialize};
use tracer::glam::{DAffine3, DMat3, DVec3};

use super::alike::few_roundings;
use super::split_boxes::{is_thick, triangles};
use super::{Alike, Broken, Problem, Relate, Today, objects, problem_if, problem_of_error};
use crate::check::File;

/// The picture stays when shapes are taken out of their groups and put where
/// these would: triangles and planes out of any, boxes too, as their triangles,
/// and all others out of groups that keep their form. What stays has a group of
/// its own, as has what is textured: its texture lies in the group's space.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlattenGroups {
    /// How far each channel may be off, relative to the brightest of the
    /// picture.
    #[serde(default = "few_roundings")]
    pub within: f64,
    /// How many pixels may be off by more.
    #[serde(default)]
    pub edge_pixels: u32,
}

impl FlattenGroups {
    /// The scene without groups where they can be done without, and how many
    /// shapes were taken out.
    pub(super) fn related(file: &File) -> (File, usize) {
        let mut flat = Flat { file, objects: Vec::new(), taken_out: 0 };
        flat.add_all(&file.objects, None);
        (File { objects: flat.objects, ..file.clone() }, flat.taken_out)
    }
}

impl Relate for FlattenGroups {
    fn words(&self) -> String {
        "FlattenGroups()".to_owned()
    }

    fn alike(&self) -> Alike {
        Alike { within: self.within, edge_pixels: self.edge_pixels }
    }

    fn problems(&self, file: &File) -> Vec<Problem> {
        let mut problems = problem_if(
            Self::related(file).1 == 0,
            "expected a shape in a group that can be put where it is without, found none",
        );
        problems.extend(problem_if(
            file.show == Show::ObjectIds,
            "expected a picture that does not show numbers of objects, as triangles have their own",
        ));
        problems.extend(problem_of_error(file));
        problems
    }

    fn holds(&self, today: &Today<'_>) -> Result<(), Broken> {
        let found = today.fixture.render_related(&Self::related(&today.fixture.file).0)?;
        self.alike().compare(today.picture, &found)
    }
}

/// Where a group is, and what it is made of.
struct Place {
    /// Its steps, then those of the groups around it.
    steps: Vec<Transform>,
    material: Option<Material>,
}

struct Flat<'a> {
    file: &'a File,
    objects: Vec<Object>,
    taken_out: usize,
}

impl Flat<'_> {
    /// Adds what is in a group, or in none.
    fn add_all(&mut self, objects: &[Object], group: Option<&Place>) {
        for object in objects {
            let inherited = group.and_then(|group| group.material.as_ref());
            let material = object.material().or(inherited).cloned();
            if let Object::Group { transform, objects, .. } = object {
                let outer = group.map_or(&[][..], |group| &group.steps);
                let steps = transform.iter().chain(outer).copied().collect();
                self.add_all(objects, Some(&Place { steps, material }));
            } else {
                let mut shape = object.clone();
                *shape.material_mut() = material;
                self.add(shape, group);
            }
        }
    }

    fn add(&mut self, shape: Object, group: Option<&Place>) {
        let Some(Place { steps, .. }) = group else {
            self.objects.push(shape);
            return;
        };
        let map = steps.iter().fold(DAffine3::IDENTITY, |map, step| affine(step) * map);
        let is_textured = objects::is_textured(self.file, shape.material());
        if let Some(there) = put(&shape, map).filter(|_| !is_textured) {
            self.objects.extend(there);
            self.taken_out += 1;
        } else {
            let (transform, objects) = (steps.clone(), vec![shape]);
            self.objects.push(Object::Group { transform, objects, material: None });
        }
    }
}

/// The shape where the map puts it; `None` where that is no shape of the format.
fn put(shape: &Object, map: DAffine3) -> Option<Vec<Object>> {
    let linear = map.matrix3;
    let to = |p: &mut Triple| *p = map.transform_point3(DVec3::from_array(*p)).to_array();
    let turn = |d: &mut Triple| *d = (linear * DVec3::from_array(*d)).to_array();
    let mut there = shape.clone();
    match &mut there {
        Object::Triangle { a, b, c, .. } => {
            [a, b, c].into_iter().for_each(to);
            return Some(vec![facing(there, linear)]);
        }
        Object::Box { min, max, material } if is_thick(*min, *max) => {
            let triangle = |corners: [Triple; 3]| {
                let [a, b, c] = corners.map(|mut corner| {
                    to(&mut corner);
                    corner
                });
                facing(Object::Triangle { a, b, c, material: material.clone() }, linear)
            };
            return Some(triangles(*min, *max).into_iter().map(triangle).collect());
        }
        Object::Plane { point, normal, .. } => {
            to(point);
            let across = linear.inverse().transpose() * DVec3::from_array(*normal);
            *normal = across.to_array();
            return Some(vec![there]);
        }
        _ => {}
    }
    let scale = scale_of(linear)?;
    match &mut there {
        Object::Sphere { center, radius, .. } => {
            to(center);
            *radius *= scale;
        }
        Object::Disk { center, normal, radius, .. } => {
            to(center);
            turn(normal);
            *radius *= scale;
        }
        Object::Torus { center, axis, major_radius, minor_radius, .. } => {
            to(center);
            turn(axis);
            *major_radius *= scale;
            *minor_radius *= scale;
        }
        Object::Cylinder { a, b, radius, .. } | Object::Cone { apex: a, base: b, radius, .. } => {
            [a, b].into_iter().for_each(to);
            *radius *= scale;
        }
        _ => return None,
    }
    Some(vec![there])
}

/// A triangle whose front is where it was before the map: one that mirrors
/// turns the way around it.
fn facing(mut triangle: Object, linear: DMat3) -> Object {
    if let Object::Triangle { b, c, .. } = &mut triangle
        && linear.determinant() < 0.0
    {
        std::mem::swap(b, c);
    }
    triangle
}

/// How many times longer everything becomes; `None` if that depends on its
/// direction.
fn scale_of(linear: DMat3) -> Option<f64> {
    /// Far above what roundings leave of right angles, far below what is seen.
    const SQUARE: f64 = 1e-13;
    let square = linear.transpose() * linear;
    let mean = (square.x_axis.x + square.y_axis.y + square.z_axis.z) / 3.0;
    let rest = square - DMat3::from_diagonal(DVec3::splat(mean));
    let keeps_forms = rest.to_cols_array().iter().all(|off| off.abs() <= SQUARE * mean);
    keeps_forms.then(|| mean.sqrt())
}

/// One step as a map of points.
fn affine(step: &Transform) -> DAffine3 {
    match *step {
        Transform::Translate(x, y, z) => DAffine3::from_translation(DVec3::new(x, y, z)),
        Transform::Scale(x, y, z) => DAffine3::from_scale(DVec3::new(x, y, z)),
        Transform::RotateDeg(x, y, z) => {
            let about = |axis: DVec3, degrees: f64| {
                let turned = |v: DVec3| rotated(v, axis, degrees.to_radians());
                DMat3::from_cols(turned(DVec3::X), turned(DVec3::Y), turned(DVec3::Z))
            };
            let turn = about(DVec3::Z, z) * about(DVec3::Y, y) * about(DVec3::X, x);
            DAffine3::from_mat3(turn)
        }
    }
}

/// The vector turned counter-clockwise about an axis of length 1.
///
/// Source: Rodrigues' rotation formula.
fn rotated(v: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(angle);
    v * cos + axis.cross(v) * sin + axis * axis.dot(v) * (1.0 - cos)
}
