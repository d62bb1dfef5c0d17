//! `object_places`: where in a file each object of its scene stands.

use crate::diagnose::Tree;
use crate::format::Object;
use crate::{SceneFile, Step};

/// Where an object is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Its name in the format, such as `Sphere`.
    pub kind: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
}

/// Where the objects of the file of this text are, in the order of their numbers
/// ([`tracer::ObjectId`]): that of the file, groups opened in place.
pub fn object_places<C>(text: &str, file: &SceneFile<C>) -> Vec<Place> {
    let (tree, _) = Tree::read(text);
    let newlines = text.match_indices('\n').map(|(byte, _)| byte + 1);
    let line_starts: Vec<usize> = std::iter::once(0).chain(newlines).collect();
    let mut places = Vec::new();
    each_object(&mut vec!["objects".into()], &file.objects, &mut |path| {
        let start = tree.locate(path).start;
        let line = line_starts.partition_point(|&line_start| line_start <= start);
        let before = text.get(line_starts[line - 1]..start).unwrap_or_default();
        let here = text.get(start..).unwrap_or_default();
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let kind = here.chars().take_while(|&c| is_name(c)).collect();
        places.push(Place { kind, line, column: before.chars().count() + 1 });
    });
    places
}

/// Calls `visit` with the path of every object that is no group.
fn each_object(path: &mut Vec<Step>, objects: &[Object], visit: &mut dyn FnMut(&[Step])) {
    for (i, object) in objects.iter().enumerate() {
        path.push(i.into());
        if let Object::Group { objects, .. } = object {
            path.push("objects".into());
            each_object(path, objects, visit);
            path.pop();
        } else {
            visit(path);
        }
        path.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NoAssets, Unchecked, load};

    const TEXT: &str = "(version: 1, image: (4, 4), camera: Parallel(view_point: (0, 0, 5)),
    objects: [
        Sphere(center: (0, 0, 0), radius: 1), /* ä */ Plane(point: (0, 0, 0), normal: (0, 1, 0)),
        Group(objects: [
            Group(transform: [Translate(1, 0, 0)], objects: [Box(min: (0, 0, 0), max: (1, 1, 1))]),
            Disk(center: (0, 0, 0), normal: (0, 0, 1), radius: 1),
        ]),
        // Sphere
        Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 1, 0)),
    ])";

    #[test]
    fn every_object_has_its_place_in_the_order_of_numbers() {
        let file = load::<Unchecked>(TEXT, &NoAssets, tracer::accel::Build::Bvh).unwrap().file;
        let places = object_places(TEXT, &file);
        let found: Vec<_> = places.iter().map(|p| (p.kind.as_str(), p.line, p.column)).collect();
        assert_eq!(
            found,
            [
                ("Sphere", 3, 9),
                ("Plane", 3, 55),
                ("Box", 5, 62),
                ("Disk", 6, 13),
                ("Triangle", 9, 9),
            ]
        );
    }
}
