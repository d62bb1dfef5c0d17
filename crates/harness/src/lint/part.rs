//! `Part`: an object or a light of a scene, by its place in the file.

use std::fmt;

use scene::format::Object;
use scene::{SceneFile, Step};

/// An object, one inside a group, or a light; written as `objects[2]`,
/// `objects[2].objects[0]` or `lights[0]`, counted from 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Part {
    /// The object at these numbers, from the outermost group in.
    Object(Vec<usize>),
    /// The light of this number.
    Light(usize),
}

impl Part {
    /// Its path in the file.
    pub fn path(&self) -> Vec<Step> {
        match self {
            Self::Object(numbers) => {
                numbers.iter().flat_map(|&i| [Step::from("objects"), Step::from(i)]).collect()
            }
            Self::Light(i) => vec!["lights".into(), (*i).into()],
        }
    }

    /// Whether it is the other one or inside it.
    pub fn is_in(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Object(inner), Self::Object(outer)) => inner.starts_with(outer),
            _ => self == other,
        }
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Object(numbers) => {
                for (depth, i) in numbers.iter().enumerate() {
                    write!(f, "{}objects[{i}]", if depth == 0 { "" } else { "." })?;
                }
                Ok(())
            }
            Self::Light(i) => write!(f, "lights[{i}]"),
        }
    }
}

/// All parts of a scene: objects first, each group before what is in it.
pub fn parts<C>(file: &SceneFile<C>) -> Vec<Part> {
    fn visit(objects: &[Object], outer: &[usize], found: &mut Vec<Part>) {
        for (i, object) in objects.iter().enumerate() {
            let numbers = [outer, &[i]].concat();
            found.push(Part::Object(numbers.clone()));
            if let Object::Group { objects, .. } = object {
                visit(objects, &numbers, found);
            }
        }
    }
    let mut found = Vec::new();
    visit(&file.objects, &[], &mut found);
    found.extend((0..file.lights.len()).map(Part::Light));
    found
}

/// The same scene less this part; the very same where there is no such part.
pub fn without<C: Clone>(file: &SceneFile<C>, part: &Part) -> SceneFile<C> {
    fn remove(objects: &mut Vec<Object>, numbers: &[usize]) {
        match numbers {
            [i] if *i < objects.len() => _ = objects.remove(*i),
            [i, rest @ ..] => {
                if let Some(Object::Group { objects, .. }) = objects.get_mut(*i) {
                    remove(objects, rest);
                }
            }
            [] => {}
        }
    }
    let mut file = file.clone();
    match part {
        Part::Object(numbers) => remove(&mut file.objects, numbers),
        Part::Light(i) if *i < file.lights.len() => _ = file.lights.remove(*i),
        Part::Light(_) => {}
    }
    file
}

#[cfg(test)]
mod tests {
    use scene::{NoAssets, Unchecked, load};

    use super::*;

    const SCENE: &str = "(
        version: 1, image: (8, 6), camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40),
        objects: [
            Sphere(center: (0, 0, 0), radius: 1),
            Group(objects: [
                Sphere(center: (1, 0, 0), radius: 2),
                Group(objects: [Sphere(center: (2, 0, 0), radius: 3)]),
            ]),
        ],
        lights: [Ambient(intensity: (1, 1, 1))],
    )";

    #[test]
    fn every_part_is_named_found_in_the_text_and_taken_out() {
        let file = load::<Unchecked>(SCENE, &NoAssets, tracer::accel::Build::List).unwrap().file;
        let expected = [
            ("objects[0]", "Sphere(center: (0, 0, 0), radius: 1)"),
            ("objects[1]", "Group(objects: [\n"),
            ("objects[1].objects[0]", "Sphere(center: (1, 0, 0), radius: 2)"),
            ("objects[1].objects[1]", "Group(objects: [Sphere"),
            ("objects[1].objects[1].objects[0]", "Sphere(center: (2, 0, 0), radius: 3)"),
            ("lights[0]", "Ambient("),
        ];
        let all = parts(&file);
        assert_eq!(all.len(), expected.len());
        for (part, (name, text)) in all.iter().zip(expected) {
            assert_eq!(part.to_string(), name);
            let span = scene::span_of(SCENE, &part.path());
            assert!(SCENE[span.start..].starts_with(text), "{name}: {:?}", &SCENE[span.start..]);
            let left = parts(&without(&file, part));
            let gone = all.iter().filter(|other| other.is_in(part)).count();
            assert_eq!(left.len(), all.len() - gone, "{name}");
        }
        assert_eq!(without(&file, &Part::Light(7)), file);
        assert_eq!(without(&file, &Part::Object(vec![0, 0])), file);
    }
}
