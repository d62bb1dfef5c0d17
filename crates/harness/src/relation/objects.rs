//! The tree of a scene's objects, walked and rebuilt.

use scene::format::{Material, Object};

use crate::check::File;

/// Every object and group, groups before what is in them.
pub(super) fn all(objects: &[Object]) -> Vec<&Object> {
    let mut found = Vec::new();
    for object in objects {
        found.push(object);
        if let Object::Group { objects, .. } = object {
            found.extend(all(objects));
        }
    }
    found
}

/// The same tree with something else in each surface's place, its groups kept.
pub(super) fn replaced(objects: Vec<Object>, by: &impl Fn(Object) -> Vec<Object>) -> Vec<Object> {
    let replace = |object| match object {
        Object::Group { transform, objects, material } => {
            vec![Object::Group { transform, objects: replaced(objects, by), material }]
        }
        surface => by(surface),
    };
    objects.into_iter().flat_map(replace).collect()
}

/// Whether a material has a texture, whose coordinates are of the object's own
/// space.
pub(super) fn is_textured(file: &File, material: Option<&Material>) -> bool {
    let found = material.and_then(|material| file.resolved(material));
    found.is_some_and(|material| material.texture().is_some())
}

/// Whether any surface may show its normal as a color.
pub(super) fn any_shows_normals(file: &File) -> bool {
    let is_normal = |material: &Material| matches!(material, Material::Normal);
    let own = all(&file.objects).into_iter().filter_map(Object::material);
    own.chain(file.materials.values()).any(is_normal)
}
