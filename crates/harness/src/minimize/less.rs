//! Parts taken out of a scene, the most at a time that can be.
//!
//! Source: A. Zeller, R. Hildebrandt, "Simplifying and Isolating Failure-Inducing
//! Input", IEEE Transactions on Software Engineering 28(2), 2002: chunks of half
//! of what is there, then of half of that.

use std::ops::Range;

use scene::format::Object;

use super::Search;
use crate::check::File;

/// How many objects and groups there are, at any depth.
pub(super) fn count(objects: &[Object]) -> usize {
    objects.iter().map(with_all_in_it).sum()
}

fn with_all_in_it(object: &Object) -> usize {
    match object {
        Object::Group { objects, .. } => 1 + count(objects),
        _ => 1,
    }
}

/// Takes objects out, then groups apart.
pub(super) fn objects(search: &mut Search<'_>) {
    in_chunks(
        search,
        |file| count(&file.objects),
        |file, gone| file.objects = without(&file.objects, &mut 0, gone),
    );
    let mut place = 0;
    while place < count(&search.best.objects) {
        let is_apart = search.take_with(|file| file.objects = apart(&file.objects, &mut 0, place));
        place += usize::from(!is_apart);
    }
}

/// Takes lights out.
pub(super) fn lights(search: &mut Search<'_>) {
    in_chunks(
        search,
        |file| file.lights.len(),
        |file, gone| {
            file.lights.drain(gone.start..gone.end.min(file.lights.len()));
        },
    );
}

/// Takes the names of materials out that nobody uses, and the materials of
/// objects.
pub(super) fn materials(search: &mut Search<'_>) {
    for name in search.best.materials.keys().cloned().collect::<Vec<_>>() {
        search.take_with(|file| drop(file.materials.remove(&name)));
    }
    for place in 0..count(&search.best.objects) {
        search.take_with(|file| {
            if let Some(object) = at(&mut file.objects, &mut 0, place) {
                *object.material_mut() = None;
            }
        });
    }
}

/// Takes chunks out of `count(file)` parts, the larger ones first.
fn in_chunks(
    search: &mut Search<'_>,
    count: impl Fn(&File) -> usize,
    take_out: impl Fn(&mut File, &Range<usize>),
) {
    let mut chunk = count(&search.best);
    while chunk > 0 {
        let mut start = 0;
        while start < count(&search.best) {
            let is_gone = search.take_with(|file| take_out(file, &(start..start + chunk)));
            // What follows has moved up.
            start += if is_gone { 0 } else { chunk };
        }
        chunk /= 2;
    }
}

/// The objects but those of these places, counted from `next`, each group before
/// what is in it; with a group goes all that is in it.
pub(super) fn without(objects: &[Object], next: &mut usize, gone: &Range<usize>) -> Vec<Object> {
    let mut kept = Vec::new();
    for object in objects {
        let place = *next;
        if gone.contains(&place) {
            *next += with_all_in_it(object);
            continue;
        }
        *next += 1;
        let mut object = object.clone();
        if let Object::Group { objects, .. } = &mut object {
            *objects = without(objects, next, gone);
        }
        kept.push(object);
    }
    kept
}

/// The objects, the group at a place replaced by what is in it.
fn apart(objects: &[Object], next: &mut usize, group: usize) -> Vec<Object> {
    let mut all = Vec::new();
    for object in objects {
        let place = *next;
        *next += 1;
        match object {
            Object::Group { objects, .. } if place == group => {
                *next += count(objects);
                all.extend(objects.iter().cloned());
            }
            Object::Group { transform, objects, material } => all.push(Object::Group {
                transform: transform.clone(),
                objects: apart(objects, next, group),
                material: material.clone(),
            }),
            other => all.push(other.clone()),
        }
    }
    all
}

/// The object or group at a place.
fn at<'a>(objects: &'a mut [Object], next: &mut usize, place: usize) -> Option<&'a mut Object> {
    for object in objects {
        let all = with_all_in_it(object);
        if place >= *next + all {
            *next += all;
            continue;
        }
        if place == *next {
            return Some(object);
        }
        *next += 1;
        return match object {
            Object::Group { objects, .. } => at(objects, next, place),
            _ => None,
        };
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `a`, a group of `b` and a group of `c`, and `d`, as their radii.
    fn objects() -> Vec<Object> {
        let ball = |radius| Object::Sphere { center: [0.0; 3], radius, material: None };
        let group = |objects| Object::Group { transform: vec![], objects, material: None };
        vec![ball(1.0), group(vec![ball(2.0), group(vec![ball(3.0)])]), ball(4.0)]
    }

    /// Radii, groups in brackets.
    fn words(objects: &[Object]) -> String {
        let word = |object: &Object| match object {
            Object::Sphere { radius, .. } => format!("{radius}"),
            Object::Group { objects, .. } => format!("[{}]", words(objects)),
            _ => "?".to_owned(),
        };
        objects.iter().map(word).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn places_count_groups_before_what_is_in_them() {
        assert_eq!(count(&objects()), 6);
        let gone = |gone| words(&without(&objects(), &mut 0, &gone));
        assert_eq!(gone(0..0), "1 [2 [3]] 4");
        assert_eq!(gone(0..1), "[2 [3]] 4");
        assert_eq!(gone(1..2), "1 4");
        assert_eq!(gone(2..3), "1 [[3]] 4");
        assert_eq!(gone(3..4), "1 [2] 4");
        assert_eq!(gone(4..6), "1 [2 []]");
        let apart = |group| words(&apart(&objects(), &mut 0, group));
        assert_eq!(apart(0), "1 [2 [3]] 4");
        assert_eq!(apart(1), "1 2 [3] 4");
        assert_eq!(apart(3), "1 [2 3] 4");
        let mut objects = objects();
        let all: Vec<_> = (0..7)
            .map(|place| at(&mut objects, &mut 0, place).map(|o| words(std::slice::from_ref(o))))
            .collect();
        let expected = ["1", "[2 [3]]", "2", "[3]", "3", "4"].map(|word| Some(word.to_owned()));
        assert_eq!(all[..6], expected);
        assert_eq!(all[6], None);
    }
}
