//! Meshes of the course: OBJ files, and the `.msh` files of its older years.

use std::collections::BTreeMap;

use scene::format::{Material, Object};

use super::element::Element;
use super::msh;
use super::reader::Reader;
use crate::import::files::fetch;
use crate::import::text::shown;

impl Reader<'_> {
    /// A mesh from the file that `data` names; `None` with a problem.
    pub(super) fn mesh(
        &mut self,
        node: Element<'_>,
        data: Option<Element<'_>>,
        material: Option<Material>,
    ) -> Option<Object> {
        let Some(data) = data else {
            let what = "expected an element data with the name of a mesh file, found none";
            self.notes.unreadable(node, what, None);
            return None;
        };
        let written = self.notes.text_of(data);
        let (name, bytes) = match self.mesh_file(&written) {
            Ok(found) => found,
            Err(why) => {
                let what = format!("the mesh \"{}\" {why}", shown(&written));
                let help = "name a folder that holds both, with --assets-from DIR";
                self.notes.unreadable(data, &what, written.contains("..").then_some(help));
                return None;
            }
        };
        let file = self.files.add(&name, bytes.clone());
        let mesh = Object::Mesh { file: file.clone(), flat: false, material };
        // Judged with its file, while its place is known.
        let alone = BTreeMap::from([(file, bytes)]);
        let mut scene = self.sense.blank();
        scene.objects = vec![mesh.clone()];
        if let Some(material) = scene.objects.first_mut().map(Object::material_mut) {
            *material = None;
        }
        let judged = scene::recompile(&scene, &alone, tracer::accel::Build::default());
        self.judge(data, judged.err().unwrap_or_default()).then_some(mesh)
    }

    /// A mesh file as scenes may name it.
    fn mesh_file(&self, written: &str) -> Result<(String, Vec<u8>), String> {
        let (name, bytes) = fetch(written, self.assets)?;
        match name.rsplit_once('.') {
            Some((stem, ending)) if ending.eq_ignore_ascii_case("msh") => {
                let obj = msh::to_obj(&bytes)?;
                Ok((format!("{stem}.obj"), obj.into_bytes()))
            }
            _ => Ok((name, bytes)),
        }
    }
}
