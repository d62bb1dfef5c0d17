//! What the tests of mesh readers have in common: a body, pictures, messages.

mod hostile;
mod round_trip;

use tracer::LinearImage;
use tracer::accel::Build;

use super::*;

/// The faces of a tetrahedron, seen from outside, in numbers of `f32`.
pub(in crate::import) const TETRAHEDRON: [[[f64; 3]; 3]; 4] = {
    const O: [f64; 3] = [0.0, 0.0, 0.0];
    const A: [f64; 3] = [1.5, 0.0, 0.0];
    const B: [f64; 3] = [0.0, 1.25, 0.0];
    const C: [f64; 3] = [0.0, 0.0, 0.8125];
    [[O, C, B], [O, A, C], [O, B, A], [A, B, C]]
};

/// The picture of an imported scene, which is read as a user would.
#[track_caller]
pub(in crate::import) fn picture(imported: &Imported) -> LinearImage {
    let mut file = imported.scene.clone();
    file.image = (24, 24);
    let text = scene::write(&file).unwrap();
    let loaded = scene::load::<Unchecked>(&text, &imported.files, Build::Bvh);
    let picture = tracer::render(&loaded.unwrap_or_else(|e| panic!("{e:?}: {text}")).scene);
    let is_lit = picture.pixels().iter().any(|p| p.channels() != [0.0; 3]);
    assert!(is_lit, "nothing is seen: {text}");
    picture
}

/// Everything that is lost, one to a line.
pub(in crate::import) fn lost(imported: &Imported) -> String {
    let place = |lost: &Lost| lost.place.map_or(String::new(), |(l, c)| format!("{l}:{c}: "));
    let line = |lost: &Lost| format!("{}{}: {}\n", place(lost), lost.element, lost.what);
    imported.lost.iter().map(line).collect()
}

/// It is refused, with this among the reasons.
#[track_caller]
pub(in crate::import) fn check_refused(result: &Result<Imported, Vec<Unreadable>>, expected: &str) {
    let errors = result.as_ref().expect_err(expected);
    let place = |e: &Unreadable| e.place.map_or(String::new(), |(l, c)| format!("{l}:{c}: "));
    let line = |e: &Unreadable| format!("{}{}\n", place(e), e.message);
    let all: String = errors.iter().map(line).collect();
    assert!(all.contains(expected), "{expected:?} is not in {all:?}");
}
