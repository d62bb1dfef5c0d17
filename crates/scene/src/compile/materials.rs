//! Materials by name, each followed to what it really is.

use std::collections::{BTreeMap, BTreeSet};

use tracer::{Convention, Material, Rgb};

use super::{Findings, Path};
use crate::{format, nearest};

/// The file's materials by name; `None` for one that has a finding.
pub(super) type Materials = BTreeMap<String, Option<Material>>;

/// Follows every name to its material.
pub(super) fn resolve(
    written: &BTreeMap<String, format::Material>,
    convention: Convention,
    findings: &mut Findings,
) -> Materials {
    let root = Path::root().field("materials");
    let resolve = |(name, material): (&String, &format::Material)| {
        let path = root.key(name);
        let resolved = match follow(name, material, written) {
            Ok(material) => in_place(material, convention, &path, findings),
            Err(Dangling::Unknown(missing)) => {
                unknown(&missing, written.keys(), &path, findings);
                None
            }
            Err(Dangling::Circle(circle)) => {
                let message = format!("materials name each other in a circle: {circle}");
                findings.add(&path, message);
                None
            }
        };
        (name.clone(), resolved)
    };
    written.iter().map(resolve).collect()
}

/// The material of an object; `None` with a finding.
pub(super) fn of_object(
    written: &format::Material,
    materials: &Materials,
    convention: Convention,
    path: &Path,
    findings: &mut Findings,
) -> Option<Material> {
    match written {
        format::Material::Named(name) => {
            let found = materials.get(name);
            if found.is_none() {
                unknown(name, materials.keys(), path, findings);
            }
            found.copied().flatten()
        }
        in_file => in_place(in_file, convention, path, findings),
    }
}

/// Why a name leads to no material.
enum Dangling {
    Unknown(String),
    Circle(String),
}

fn follow<'a>(
    name: &'a str,
    mut material: &'a format::Material,
    written: &'a BTreeMap<String, format::Material>,
) -> Result<&'a format::Material, Dangling> {
    /// The most names of a circle that are told.
    const TOLD: usize = 6;
    let mut way = vec![name];
    let mut seen = BTreeSet::from([name]);
    while let format::Material::Named(next) = material {
        material = written.get(next).ok_or_else(|| Dangling::Unknown(next.clone()))?;
        way.push(next);
        if !seen.insert(next) {
            if way.len() > TOLD {
                way.splice(TOLD / 2..way.len() - TOLD / 2, ["..."]);
            }
            return Err(Dangling::Circle(way.join(" -> ")));
        }
    }
    Ok(material)
}

/// A material that is not a name.
fn in_place(
    written: &format::Material,
    convention: Convention,
    path: &Path,
    findings: &mut Findings,
) -> Option<Material> {
    let diffuse_or_default =
        |diffuse: Option<_>| diffuse.map_or(convention.default_diffuse(), Rgb::from);
    let material = match *written {
        format::Material::Named(_) => return None,
        format::Material::Constant { color } => Material::Constant(Rgb::from(color)),
        format::Material::Normal => Material::Normal,
        format::Material::Lambert { diffuse } => {
            Material::Lambert { diffuse: diffuse_or_default(diffuse) }
        }
        format::Material::BlinnPhong { diffuse, specular, exponent } => Material::BlinnPhong {
            diffuse: diffuse_or_default(diffuse),
            specular: Rgb::from(specular),
            exponent,
        },
        format::Material::Mirror { reflectance, schlick } => {
            Material::Mirror { reflectance: Rgb::from(reflectance), schlick }
        }
        format::Material::Dielectric { ior, tint, schlick } => {
            Material::Dielectric { ior, tint: Rgb::from(tint), schlick }
        }
        format::Material::Whitted {
            diffuse,
            specular,
            exponent,
            reflect,
            transmit,
            ior,
            schlick,
        } => Material::Whitted {
            diffuse: diffuse_or_default(diffuse),
            specular: Rgb::from(specular),
            exponent,
            reflect: Rgb::from(reflect),
            transmit: Rgb::from(transmit),
            ior,
            schlick,
        },
        format::Material::Glazed { ior, schlick, diffuse, specular, exponent } => {
            Material::Glazed {
                ior,
                schlick,
                diffuse: diffuse_or_default(diffuse),
                specular: Rgb::from(specular),
                exponent,
            }
        }
    };
    findings.accept(path, material.checked())
}

fn unknown<'a>(
    name: &str,
    known: impl Iterator<Item = &'a String>,
    path: &Path,
    findings: &mut Findings,
) {
    let known: Vec<_> = known.map(String::as_str).collect();
    let message = format!("no material is named \"{name}\"");
    let help = match (nearest(name, known.iter().copied()), known.is_empty()) {
        (Some(meant), _) => format!("did you mean \"{meant}\"?"),
        (None, false) => format!("known here: \"{}\"", known.join("\", \"")),
        (None, true) => "name it under `materials`".to_owned(),
    };
    findings.add_with_help(path, message, help);
}
