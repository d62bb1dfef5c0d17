//! Shapes, each in its own space, with the matrix to the world's.

use scene::format::{Object, Triple};
use tracer::glam::DVec3;
use tracer::shape::MeshUvs;

use super::{point, triple};
use crate::export::number;
use crate::export::plain::{Placed, Plain, Solid, Triangles};
use crate::export::text::{numbers, put, vector};

/// All of a shape but its matrix, its look and the closing brace.
pub(super) fn shape(plain: &Plain, object: &Placed) -> String {
    match &object.shape {
        Object::Sphere { center, radius, .. } => {
            format!("sphere {{ {}, {}", triple(*center), number(*radius))
        }
        Object::Box { min, max, .. } => format!("box {{ {}, {}", triple(*min), triple(*max)),
        Object::Plane { point, normal, .. } => {
            format!("plane {{ {}, 0 translate {}", unit(*normal), triple(*point))
        }
        Object::Disk { center, normal, radius, .. } => {
            format!("disc {{ {}, {}, {}", triple(*center), unit(*normal), number(*radius))
        }
        Object::Torus { center, axis, major_radius, minor_radius, .. } => {
            torus(*center, *axis, [*major_radius, *minor_radius])
        }
        // The front is where the corners go around clockwise.
        Object::Triangle { a, b, c, .. } => {
            format!("triangle {{ {}, {}, {}", triple(*a), triple(*c), triple(*b))
        }
        Object::Cylinder { a, b, radius, open, .. } => {
            let open = if *open { " open" } else { "" };
            format!("cylinder {{ {}, {}, {}{open}", triple(*a), triple(*b), number(*radius))
        }
        Object::Cone { apex, base, radius, open, .. } => {
            let open = if *open { " open" } else { "" };
            format!("cone {{ {}, {}, {}, 0{open}", triple(*base), number(*radius), triple(*apex))
        }
        // In its own space: what stretches a mesh must not stretch its normals first.
        Object::Mesh { .. } => match object.in_own_space().solid(plain) {
            Solid::Triangles(triangles) => mesh(&triangles, uvs(plain, object)),
            _ => String::new(),
        },
        // `Placed` is none.
        Object::Group { .. } => String::new(),
    }
}

/// The map to the world, unless it is none. A vector is a row here, so that the
/// rows of the matrix are the columns of ours.
pub(super) fn matrix(object: &Placed) -> String {
    if object.is_in_place() {
        return String::new();
    }
    format!("\n  matrix <{}>", numbers(object.world_from_object.to_cols_array(), ","))
}

fn unit(v: Triple) -> String {
    point(vector(v).normalize_or_zero())
}

/// POV-Ray's torus goes around the y axis at the origin.
fn torus(center: Triple, axis: Triple, radii: [f64; 2]) -> String {
    let torus = format!("torus {{ {}", numbers(radii, ", "));
    let y = vector(axis).normalize_or_zero();
    if y == DVec3::Y {
        return format!("{torus} translate {}", triple(center));
    }
    let x = y.any_orthonormal_vector();
    let z = x.cross(y);
    let rows = [x, y, z, vector(center)].into_iter().flat_map(|v| v.to_array());
    format!("{torus} matrix <{}>", numbers(rows, ","))
}

/// Texture coordinates of a mesh that has a texture.
fn uvs<'a>(plain: &'a Plain, object: &Placed) -> Option<&'a MeshUvs> {
    let Object::Mesh { file, .. } = &object.shape else { return None };
    object.texture.as_ref()?;
    plain.meshes.get(file)?.uvs.as_ref().ok()
}

fn mesh(Triangles { corners, normals, faces }: &Triangles, uvs: Option<&MeshUvs>) -> String {
    let vectors = |name: &str, all: &[DVec3]| {
        let list: Vec<_> = all.iter().map(|v| point(*v)).collect();
        format!("\n  {name} {{ {}, {} }}", all.len(), list.join(","))
    };
    let mut text = "mesh2 {".to_owned();
    text += &vectors("vertex_vectors", corners);
    if !normals.is_empty() {
        text += &vectors("normal_vectors", normals);
    }
    let indices = |name: &str, faces: &[[u32; 3]]| {
        let list: Vec<_> = faces.iter().map(|[a, b, c]| format!("<{a},{c},{b}>")).collect();
        format!("\n  {name} {{ {}, {} }}", faces.len(), list.join(","))
    };
    if let Some(MeshUvs { uvs, .. }) = uvs {
        let list: Vec<_> = uvs.iter().map(|uv| format!("<{}>", numbers(*uv, ","))).collect();
        put(&mut text, format_args!("\n  uv_vectors {{ {}, {} }}", uvs.len(), list.join(",")));
    }
    text += &indices("face_indices", faces);
    if let Some(MeshUvs { faces, .. }) = uvs {
        text += &indices("uv_indices", faces);
    }
    text
}
