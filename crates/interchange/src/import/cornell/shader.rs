//! Shaders of the course, as materials.

use scene::format::{Material, Shading};

use super::element::{Element, Fields, attribute};
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

    /// A shader in place; `None` with a problem.
    fn shader(&mut self, node: Element<'_>) -> Option<Material> {
        self.notes.only_attributes(node, &["name", "type"]);
        let material = match &*self.kind(node, None)? {
            "lambertian" => {
                let known = ["diffusecolor", "mirrorcoefficient"];
                let fields = Fields::of(node, &known, &[], &mut self.notes);
                let diffuse = fields.triple("diffusecolor", &mut self.notes);
                self.mirroring(Material::Lambert { diffuse, texture: None }, &fields)
            }
            "phong" => self.phong(node),
            "constant" => {
                let fields = Fields::of(node, &["color"], &[], &mut self.notes);
                if fields.get("color").is_none() {
                    self.notes.unreadable(node, "expected an element color, found none", None);
                }
                let color = fields.triple("color", &mut self.notes)?;
                Material::Constant { color, texture: None }
            }
            "normal" | "rgbnormals" | "shownormal" => {
                Fields::of(node, &[], &[], &mut self.notes);
                Material::Normal
            }
            "glass" => self.glass(node),
            "glazed" => self.glazed(node)?,
            _ => self.unknown_shader(node),
        };
        let problems = self.sense.of_material(&material);
        self.judge(node, problems).then_some(material)
    }

    /// Lambert with a highlight about the half vector. Its diffuse color is
    /// white where it does not say, in every year.
    fn phong(&mut self, node: Element<'_>) -> Material {
        let known = ["diffusecolor", "specularcolor", "exponent", "mirrorcoefficient"];
        let fields = Fields::of(node, &known, &[], &mut self.notes);
        let notes = &mut self.notes;
        let white = match self.shading {
            // What a scene gets that says nothing.
            Shading::Classic | Shading::Attenuated => None,
            Shading::Radiometric => Some([1.0; 3]),
        };
        let lit = Material::BlinnPhong {
            texture: None,
            diffuse: fields.triple("diffusecolor", notes).or(white),
            specular: fields.triple("specularcolor", notes).unwrap_or([1.0; 3]),
            exponent: fields.number("exponent", notes).unwrap_or(1.0),
        };
        self.mirroring(lit, &fields)
    }
}
