//! Objects, meshes and groups.

use tracer::accel::Build;
use tracer::fault::{Fault, seeded};
use tracer::glam::DVec3;
use tracer::shape::{Mesh, Shape};
use tracer::{Convention, Group, Material, Member, Object, Transform};

use super::materials::{Materials, of_object};
use super::{Findings, Path};
use crate::{Assets, check_path, format, mesh};

/// What making objects needs.
pub(super) struct Objects<'a> {
    pub(super) assets: &'a dyn Assets,
    pub(super) build: Build,
    pub(super) materials: Materials,
    pub(super) convention: Convention,
    pub(super) findings: &'a mut Findings,
}

impl Objects<'_> {
    /// The scene's objects; those with a finding are left out.
    pub(super) fn all(mut self, path: &Path, written: &[format::Object]) -> Vec<Member> {
        let default = self.default_material();
        self.members(path, written, default)
    }

    /// What an object is made of that does not say, outside of all groups.
    fn default_material(&self) -> Material {
        Material::Lambert { diffuse: self.convention.default_diffuse() }
    }

    fn members(
        &mut self,
        path: &Path,
        written: &[format::Object],
        inherited: Material,
    ) -> Vec<Member> {
        let member = |(i, object)| self.member(&path.index(i), object, inherited);
        written.iter().enumerate().filter_map(member).collect()
    }

    fn member(
        &mut self,
        path: &Path,
        written: &format::Object,
        inherited: Material,
    ) -> Option<Member> {
        let material = match written.material() {
            None if seeded(Fault::GroupMaterialIgnored) => Some(self.default_material()),
            None => Some(inherited),
            Some(own) => {
                let path = path.field("material");
                of_object(own, &self.materials, self.convention, &path, self.findings)
            }
        };
        let shape = match written {
            format::Object::Group { transform, objects, .. } => {
                // Members are judged although the group's material may be wrong.
                let members =
                    self.members(&path.field("objects"), objects, material.unwrap_or(inherited));
                let transform = self.transform(&path.field("transform"), transform)?;
                return material.map(|_| Member::Group(Group::new(transform, members, self.build)));
            }
            format::Object::Mesh { file, flat, .. } => {
                self.mesh(&path.field("file"), file, *flat).map(Shape::from)
            }
            simple => simple.shape().and_then(|made| self.findings.accept(path, made)),
        };
        Some(Member::Object(Object::new(shape?, material?)))
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

    fn mesh(&mut self, path: &Path, file: &str, flat: bool) -> Option<Mesh> {
        let read = || -> Result<_, String> {
            check_path(file)
                .map_err(|expected| format!("expected {expected}, found \"{file}\""))?;
            mesh::check_ending(file).map_err(|why| format!("mesh \"{file}\" {why}"))?;
            let bytes = self.assets.read(file).map_err(|why| format!("mesh \"{file}\" {why}"))?;
            mesh::read(file, &bytes).map_err(|why| format!("mesh \"{file}\" {why}"))
        };
        let mesh::MeshData { vertices, faces, normals } =
            read().map_err(|message| self.findings.add(path, message)).ok()?;
        let normals = normals.filter(|_| !flat);
        let made = Mesh::new(vertices, faces, normals, self.build);
        made.map_err(|refused| {
            self.findings.add(path, format!("mesh \"{file}\" makes no shape: {refused}"));
        })
        .ok()
    }
}
