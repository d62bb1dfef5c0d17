//! Shaders of the course that send rays on: mirrors, glass, and what is glazed.
//!
//! Source: the program that was handed out with the assignments: "Ray 2" of 2015
//! and 2017 has `Glass` and `Glazed` by Fresnel's equations, the classic years
//! have them by Schlick's law, "Ray 1" of 2018 and 2019 has `mirrorCoefficient`,
//! which grows by Schlick's law. All follow a ray over eleven surfaces.

use scene::format::{Material, Shading};

use super::element::{Element, Fields, attribute, name_of, written_name};
use super::reader::Reader;
use crate::import::text::shown;

/// How many surfaces a ray is followed over: twelve rays, that from the eye
/// among them.
pub(super) const BOUNCES: u32 = 11;

impl Reader<'_> {
    /// Clear glass; its index is 1 where it does not say.
    pub(super) fn glass(&mut self, node: Element<'_>) -> Material {
        let fields = Fields::of(node, &["refractiveindex"], &[], &mut self.notes);
        let ior = fields.number("refractiveindex", &mut self.notes).unwrap_or(1.0);
        Material::Dielectric { ior, tint: [1.0; 3], schlick: self.is_schlick() }
    }

    /// A clear coat over a substrate; `None` with a problem, or for a substrate
    /// that is lost, which is then all that there is.
    pub(super) fn glazed(&mut self, node: Element<'_>) -> Option<Material> {
        let fields = Fields::of(node, &["refractiveindex", "substrate"], &[], &mut self.notes);
        let mut required = |name: &str, what: &str| {
            let found = fields.get(name);
            if found.is_none() {
                let what = format!("expected an element {what}, found none");
                self.notes.unreadable(node, &what, None);
            }
            found
        };
        let ior = required("refractiveindex", "refractiveIndex");
        let under = required("substrate", "substrate")?;
        // Not looked into: they could stand in each other without end.
        let is_glazed = attribute(under, "type").is_some_and(|k| k.eq_ignore_ascii_case("glazed"));
        let substrate = if is_glazed {
            Material::Lambert { diffuse: None, texture: None }
        } else {
            self.material(under)?
        };
        let [ior] = self.notes.numbers(ior?)?;
        let schlick = self.is_schlick();
        let mut seen = Some(&substrate);
        // A shader of the scene names none itself.
        if let Material::Named(name) = &substrate {
            seen = self.materials.get(name);
        }
        match seen {
            Some(&Material::Lambert { diffuse, .. }) if !is_glazed => Some(Material::Glazed {
                ior,
                schlick,
                diffuse,
                specular: [0.0; 3],
                exponent: 1.0,
                texture: None,
            }),
            Some(&Material::BlinnPhong { diffuse, specular, exponent, .. }) => {
                Some(Material::Glazed { ior, schlick, diffuse, specular, exponent, texture: None })
            }
            _ => {
                let kind = attribute(under, "type").or(attribute(under, "ref"));
                let what = format!(
                    "a glaze over {} is not known: what has it is shown without",
                    shown(kind.unwrap_or_default())
                );
                self.notes.lost(under, what);
                Some(substrate)
            }
        }
    }

    /// The same material with what it mirrors, if its shader says so and not 0.
    pub(super) fn mirroring(&mut self, lit: Material, fields: &Fields<'_>) -> Material {
        let reflect = fields.triple("mirrorcoefficient", &mut self.notes).unwrap_or_default();
        if reflect == [0.0; 3] {
            return lit;
        }
        let (diffuse, specular, exponent) = match lit {
            Material::Lambert { diffuse, .. } => (diffuse, [0.0; 3], 1.0),
            Material::BlinnPhong { diffuse, specular, exponent, .. } => {
                (diffuse, specular, exponent)
            }
            other => return other,
        };
        self.sends(
            "what a mirrorCoefficient reflects grows along the surface by Schlick's law, as in the \
             course's years 2018 and 2019",
        );
        Material::Whitted {
            diffuse,
            specular,
            exponent,
            reflect,
            transmit: [0.0; 3],
            ior: 1.0,
            schlick: true,
            texture: None,
        }
    }

    /// Whether glass follows Schlick's law, which is said.
    fn is_schlick(&mut self) -> bool {
        let is_schlick = self.shading == Shading::Classic;
        self.sends(if is_schlick {
            "Glass and Glazed reflect by Schlick's law, as in the course's classic years"
        } else {
            "Glass and Glazed reflect by Fresnel's equations, as in the course's years 2015 and 2017"
        });
        is_schlick
    }

    /// Says so, and how far rays are followed.
    fn sends(&mut self, what: &str) {
        self.bounces = BOUNCES;
        self.notes.report.chose(what);
        self.notes.report.chose(format!(
            "rays are followed over {BOUNCES} surfaces, as in the course's programs"
        ));
    }

    /// A shader whose kind is not known is lost, and what would show it is white,
    /// or gray by the later conventions.
    pub(super) fn unknown_shader(&mut self, node: Element<'_>) -> Material {
        let kind = attribute(node, "type").unwrap_or_default();
        let what = format!(
            "the type {} is not known: what has this {} is shown as plain Lambert",
            shown(kind),
            written_name(node)
        );
        self.notes.lost(node, what);
        Material::Lambert { diffuse: None, texture: None }
    }
}

/// Shaders of a scene that stand on another of it come after that.
pub(super) fn stands_on_another(node: &Element<'_>) -> bool {
    node.children().any(|child| name_of(child) == "substrate" && attribute(child, "ref").is_some())
}
