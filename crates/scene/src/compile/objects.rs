//! Objects, meshes and groups.

use tracer::accel::Build;
use tracer::fault::{Fault, seeded};
use tracer::glam::DVec3;
use tracer::shape::{Mesh, Shape};
use tracer::{Convention, Group, Material, Member, Object, Transform};

use super::materials::{Materials, Surface, of_object};
use super::textures::Textures;
use super::{Findings, Path};
use crate::{Assets, check_path, format, mesh};

/// What making objects needs.
pub(super) struct Objects<'a> {
    pub(super) assets: &'a dyn Assets,
    pub(super) build: Build,
    pub(super) materials: Materials,
    pub(super) textures: Textures<'a>,
    pub(super) convention: Convention,
    pub(super) findings: &'a mut Findings,
}

impl Objects<'_> {
    /// The scene's objects; those with a finding are left out.
    pub(super) fn all(mut self, path: &Path, written: &[format::Object]) -> Vec<Member> {
        let default = self.default_surface();
        self.members(path, written, &default)
    }

    /// What an object is made of that does not say, outside of all groups.
    fn default_surface(&self) -> Surface {
        let material = Material::Lambert { diffuse: self.convention.default_diffuse() };
        Surface { material, texture: None }
    }

    fn members(
        &mut self,
        path: &Path,
        written: &[format::Object],
        inherited: &Surface,
    ) -> Vec<Member> {
        let member = |(i, object)| self.member(&path.index(i), object, inherited);
        written.iter().enumerate().filter_map(member).collect()
    }

    fn member(
        &mut self,
        path: &Path,
        written: &format::Object,
        inherited: &Surface,
    ) -> Option<Member> {
        let own_path = path.field("material");
        let surface = match written.material() {
            None if seeded(Fault::GroupMaterialIgnored) => Some(self.default_surface()),
            None => Some(inherited.clone()),
            Some(own) => {
                let Self { materials, textures, convention, findings, .. } = self;
                of_object(own, materials, *convention, textures, &own_path, findings)
            }
        };
        let shape = match written {
            format::Object::Group { transform, objects, .. } => {
                // Members are judged although the group's material may be wrong.
                let inner = surface.as_ref().unwrap_or(inherited);
                let members = self.members(&path.field("objects"), objects, inner);
                let transform = self.transform(&path.field("transform"), transform)?;
                return surface.map(|_| Member::Group(Group::new(transform, members, self.build)));
            }
            format::Object::Mesh { file, flat, .. } => {
                let is_textured = surface.as_ref().is_some_and(|surface| surface.texture.is_some());
                self.mesh(&path.field("file"), file, (*flat, is_textured)).map(Shape::from)
            }
            simple => simple.shape().and_then(|made| self.findings.accept(path, made)),
        };
        let (shape, Surface { material, texture }) = (shape?, surface?);
        let object = match texture {
            None => Object::new(shape, material),
            Some(texture) => {
                let made = Object::textured(shape, material, texture);
                self.findings.accept(&own_path, made)?
            }
        };
        Some(Member::Object(object))
    }

    /// The steps, first to last, as one transform.
    fn transform(&mut self, path: &Path, steps: &[format::Transform]) -> Option<Transform> {
        let mut all = Some(Transform::IDENTITY);
        for (i, &step) in steps.iter().enumerate() {
            let made = match step {
                format::Transform::Translate(x, y, z) => {
                    Transform::translation(DVec3::new(x, y, z))
                }
                format::Transform::RotateDeg(x, y, z) => {
                    Transform::rotation_deg(DVec3::new(x, y, z))
                }
                format::Transform::Scale(x, y, z) => Transform::scale(DVec3::new(x, y, z)),
            };
            let step = self.findings.accept(&path.index(i), made);
            all = all
                .zip(step)
                .and_then(|(all, step)| self.findings.accept(&path.index(i), all.then(step)));
        }
        all
    }

    /// A mesh, whose file must have texture coordinates if it is textured.
    fn mesh(&mut self, path: &Path, file: &str, (flat, is_textured): (bool, bool)) -> Option<Mesh> {
        let read = || -> Result<_, String> {
            check_path(file)
                .map_err(|expected| format!("expected {expected}, found \"{file}\""))?;
            mesh::check_ending(file).map_err(|why| format!("mesh \"{file}\" {why}"))?;
            let bytes = self.assets.read(file).map_err(|why| format!("mesh \"{file}\" {why}"))?;
            mesh::read(file, &bytes).map_err(|why| format!("mesh \"{file}\" {why}"))
        };
        let mesh::MeshData { vertices, faces, normals, uvs } =
            read().map_err(|message| self.findings.add(path, message)).ok()?;
        let normals = normals.filter(|_| !flat);
        let made = Mesh::new(vertices, faces, normals, self.build);
        let made = if is_textured {
            let uvs = uvs.map_err(|why| {
                let message = format!("mesh \"{file}\" {why}, which the material's texture needs");
                self.findings.add(path, message);
            });
            let uvs = uvs.ok()?;
            made.and_then(|mesh| mesh.with_uvs(uvs))
        } else {
            made
        };
        made.map_err(|refused| {
            self.findings.add(path, format!("mesh \"{file}\" makes no shape: {refused}"));
        })
        .ok()
    }
}
