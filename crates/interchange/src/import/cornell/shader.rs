//! Shaders of the course, as materials.

use scene::format::{Material, Shading};

use super::element::{Element, Fields, attribute, written_name};
use super::reader::Reader;
use crate::import::text::shown;

impl Reader<'_> {
    /// Keeps a shader of the scene under its name.
    pub(super) fn named_shader(&mut self, node: Element<'_>) {
        let Some(name) = attribute(node, "name") else {
            self.notes.lost(node, "has no name, so that no surface can use it: it is left out");
            return;
        };
        let Some(material) = self.shader(node) else { return };
        if self.materials.insert(name.to_owned(), material).is_some() {
            let name = shown(name);
            let what =
                format!("\"{name}\" is the name of a shader before it: only the last one counts");
            self.notes.lost(node, what);
        }
    }

    /// The material of a surface or group: a shader that it names, or one in
    /// place.
    pub(super) fn material(&mut self, node: Element<'_>) -> Option<Material> {
        let Some(name) = attribute(node, "ref") else {
            return self.shader(node);
        };
        self.notes.only_attributes(node, &["ref"]);
        Fields::of(node, &[], &[], &mut self.notes);
        if self.materials.contains_key(name) {
            return Some(Material::Named(name.to_owned()));
        }
        let meant = scene::nearest(name, self.materials.keys().map(String::as_str));
        let help = meant.map(|meant| format!("did you mean \"{}\"?", shown(meant)));
        let what = format!("no shader of the scene is named \"{}\"", shown(name));
        self.notes.unreadable(node, &what, help.as_deref());
        None
    }

    /// A shader in place. One of a kind that is not known is lost, and what
    /// would show it is white, or gray by the later conventions.
    fn shader(&mut self, node: Element<'_>) -> Option<Material> {
        self.notes.only_attributes(node, &["name", "type"]);
        let material = match &*self.kind(node, None)? {
            "lambertian" => {
                let fields = Fields::of(node, &["diffusecolor"], &[], &mut self.notes);
                Material::Lambert { diffuse: fields.triple("diffusecolor", &mut self.notes) }
            }
            "phong" => self.phong(node),
            "constant" => {
                let fields = Fields::of(node, &["color"], &[], &mut self.notes);
                if fields.get("color").is_none() {
                    self.notes.unreadable(node, "expected an element color, found none", None);
                }
                let color = fields.triple("color", &mut self.notes)?;
                Material::Constant { color }
            }
            "normal" | "rgbnormals" | "shownormal" => {
                Fields::of(node, &[], &[], &mut self.notes);
                Material::Normal
            }
            _ => {
                let kind = attribute(node, "type").unwrap_or_default();
                let what = format!(
                    "the type {} is not known: what has this {} is shown as plain Lambert",
                    shown(kind),
                    written_name(node)
                );
                self.notes.lost(node, what);
                Material::Lambert { diffuse: None }
            }
        };
        let problems = self.sense.of_material(&material);
        self.judge(node, problems).then_some(material)
    }

    /// Lambert with a highlight about the half vector. Its diffuse color is
    /// white where it does not say, in every year.
    fn phong(&mut self, node: Element<'_>) -> Material {
        let known = ["diffusecolor", "specularcolor", "exponent"];
        let fields = Fields::of(node, &known, &[], &mut self.notes);
        let notes = &mut self.notes;
        let white = match self.shading {
            // What a scene gets that says nothing.
            Shading::Classic | Shading::Attenuated => None,
            Shading::Radiometric => Some([1.0; 3]),
        };
        Material::BlinnPhong {
            diffuse: fields.triple("diffusecolor", notes).or(white),
            specular: fields.triple("specularcolor", notes).unwrap_or([1.0; 3]),
            exponent: fields.number("exponent", notes).unwrap_or(1.0),
        }
    }
}
