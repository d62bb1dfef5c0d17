//! glTF 2.0, as JSON with its buffers or as GLB: meshes where their nodes are,
//! base colors, one camera, and lights.
//!
//! Meshes of one material become one, in the world's space: a map of a node may
//! shear, which a group here cannot, and so it goes into the vertices.

mod accessor;
mod buffer;
mod container;
mod document;
mod material;
mod node;
mod primitive;
mod texture;
mod view;

#[cfg(test)]
pub(super) mod tests;

use std::collections::BTreeMap;

use scene::Assets;
use scene::format::{self, Shading};

use super::mesh::stage::Stage;
use super::mesh::unreadable_at_all;
use super::{Imported, Source, Unreadable, Wishes};
use buffer::{Buffers, none};
use document::Document;
use node::Placed;
use primitive::Parts;

/// Extensions that are read.
const KNOWN: [&str; 6] = [
    "KHR_lights_punctual",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
];

/// The most materials that are read.
const MOST_MATERIALS: usize = 10_000;

/// Reads a glTF file, and of `assets` the buffers that it names.
///
/// # Errors
/// The first thing that is not as the specification has it.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    assets: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let mut stage = Stage { shading: Shading::Radiometric, ..Stage::default() };
    build(source.bytes, wishes, assets, &mut stage).map_err(|error| vec![error])?;
    stage.imported(source.name, wishes)
}

fn build(
    bytes: &[u8],
    wishes: &Wishes,
    assets: &dyn Assets,
    stage: &mut Stage,
) -> Result<(), Unreadable> {
    let (document, own) = container::open(bytes)?;
    examine(&document, stage)?;
    let placed = node::placed(&document, stage)?;
    let mut buffers = Buffers::new(&document, own, assets);
    let mut parts = Parts::default();
    let mut cameras = 0;
    for Placed { node: number, world } in placed {
        let node = &document.nodes[number];
        let within = |why: String| unreadable_at_all(format!("nodes[{number}]: {why}"));
        if let Some(mesh) = node.mesh {
            let meshes = &document.meshes;
            let found =
                meshes.get(mesh).ok_or_else(|| within(none("meshes", meshes.len(), mesh)))?;
            if [&found.weights, &node.weights].iter().any(|all| all.iter().any(|&w| w != 0.0)) {
                let what = "weights of morph targets are left out";
                stage.lost.add(None, format!("meshes[{mesh}]"), what);
            }
            for (i, primitive) in found.primitives.iter().enumerate() {
                let place = format!("meshes[{mesh}].primitives[{i}]");
                if !primitive.targets.is_empty() {
                    stage.lost.add(None, &place, "morph targets are left out");
                }
                for name in &primitive.extensions.others.0 {
                    let what = "this extension is not read";
                    stage.lost.add(None, format!("{place}: {name}"), what);
                }
                parts
                    .add((&document, &mut buffers), primitive, &world, &place, &mut stage.lost)
                    .map_err(|why| unreadable_at_all(format!("{place}: {why}")))?;
            }
        }
        if node.skin.is_some() {
            let what = "the skin is left out: the mesh stays as it is in its node";
            stage.lost.add(None, format!("nodes[{number}]"), what);
        }
        for name in &node.extensions.others.0 {
            let what = "this extension is not read";
            stage.lost.add(None, format!("nodes[{number}]: {name}"), what);
        }
        if let Some(camera) = node.camera.filter(|_| wishes.camera.is_none()) {
            cameras += 1;
            let all = &document.cameras;
            let found =
                all.get(camera).ok_or_else(|| within(none("cameras", all.len(), camera)))?;
            let place = format!("cameras[{camera}]");
            let shot = view::shot(found, &world, &place, &mut stage.lost)
                .map_err(|why| within(format!("{place}: {why}")))?;
            stage.shot.get_or_insert(shot);
        }
        if let Some(light) = node.extensions.lights.as_ref().and_then(|lights| lights.light) {
            let all = document.extensions.lights.as_ref().map_or(&[][..], |all| &all.lights);
            let found = all.get(light).ok_or_else(|| within(none("lights", all.len(), light)))?;
            let place = format!("lights[{light}]");
            let light = view::light(found, &world, &place, &mut stage.lost)
                .map_err(|why| within(format!("{place}: {why}")))?;
            stage.lights.extend(light);
        }
    }
    if stage.shot.is_some() {
        let which = if cameras > 1 {
            format!("the first of {cameras} cameras")
        } else {
            "the file's camera".to_owned()
        };
        stage
            .chosen
            .push(format!("the view is that of {which}; its znear and zfar cut nothing off"));
    }
    dress((&document, &mut buffers), parts, stage)
}

/// Gives each mesh its material.
fn dress(
    (document, buffers): (&Document, &mut Buffers<'_>),
    parts: Parts,
    stage: &mut Stage,
) -> Result<(), Unreadable> {
    let materials = &document.materials;
    let mut names: BTreeMap<Option<usize>, String> = BTreeMap::new();
    let mut is_culled = false;
    for (part, number) in parts.all {
        if let Some(name) = names.get(&number) {
            stage.parts.push((part, Some(name.clone())));
            continue;
        }
        if names.len() >= MOST_MATERIALS {
            let message = format!("expected at most {MOST_MATERIALS} materials, found more");
            return Err(unreadable_at_all(message));
        }
        let (wanted, material) = match number {
            None => {
                stage.chosen.push("what has no material is white".to_owned());
                is_culled = true;
                let white = format::Material::Lambert { diffuse: Some([1.0; 3]), texture: None };
                ("default".to_owned(), white)
            }
            Some(number) => {
                let found = materials
                    .get(number)
                    .ok_or_else(|| unreadable_at_all(none("materials", materials.len(), number)))?;
                let place = format!("materials[{number}]");
                is_culled |= !found.double_sided;
                let material = material::of(found, &place, (document, buffers), stage)
                    .map_err(|why| unreadable_at_all(format!("{place}: {why}")))?;
                (found.name.clone().unwrap_or_else(|| format!("material {number}")), material)
            }
        };
        let mut name = wanted.clone();
        if stage.materials.contains_key(&name) {
            // The number alone is not another's, but a name may look like it.
            let mut tries = 1..;
            while stage.materials.contains_key(&name) {
                name = format!("{wanted} ({})", tries.next().unwrap_or_default());
            }
        }
        stage.materials.insert(name.clone(), material);
        names.insert(number, name.clone());
        stage.parts.push((part, Some(name)));
    }
    if is_culled {
        stage
            .chosen
            .push("back faces are seen, also of materials that are not doubleSided".to_owned());
    }
    Ok(())
}

/// What the document as a whole asks for.
fn examine(document: &Document, stage: &mut Stage) -> Result<(), Unreadable> {
    let shown = |text: &str| text.chars().take(40).collect::<String>().escape_debug().to_string();
    let version = document.asset.min_version.as_ref().unwrap_or(&document.asset.version);
    // Later versions of 2 can be read by what reads 2.0, unless they say not.
    let is_known = if document.asset.min_version.is_some() {
        version == "2.0"
    } else {
        version.starts_with("2.")
    };
    if !is_known {
        let found = shown(version);
        let message = format!("expected glTF of version 2.0 in `asset`, found \"{found}\"");
        return Err(unreadable_at_all(message));
    }
    let unknown = |name: &&String| !KNOWN.contains(&&name[..]);
    if let Some(required) = document.extensions_required.iter().find(unknown) {
        return Err(Unreadable {
            place: None,
            message: format!(
                "expected no extensionsRequired but {}, found \"{}\"",
                KNOWN.join(", "),
                shown(required)
            ),
            help: Some("write the file again without this extension".to_owned()),
        });
    }
    for used in document.extensions_used.iter().filter(unknown) {
        let what = "this extension is used and not read";
        stage.lost.add(None, format!("extensionsUsed: {}", shown(used)), what);
    }
    if !document.animations.is_empty() {
        let what = format!("{} of them are left out", document.animations.len());
        stage.lost.add(None, "animations", what);
    }
    Ok(())
}
