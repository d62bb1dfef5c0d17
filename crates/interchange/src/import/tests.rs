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

/// A PNG file of pixels with this many channels, which are the last 3 or 4 bytes.
pub(in crate::import) fn png<const N: usize>(width: u32, pixels: &[[u8; N]]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, pixels.len() as u32 / width);
    encoder.set_color(if N == 3 { png::ColorType::Rgb } else { png::ColorType::Rgba });
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(pixels.as_flattened()).unwrap();
    writer.finish().unwrap();
    bytes
}

/// Red and green above, blue and white below.
pub(in crate::import) fn four_colors() -> Vec<u8> {
    png(2, &[[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]])
}

/// Straight at the square from 0 to 1, on whose four texels of that picture the
/// pixels are.
pub(in crate::import) fn at_unit_square() -> Wishes {
    let camera = Wishes::camera("Parallel(view_point: (0.5, 0.5, 1))").unwrap();
    Wishes { camera: Some(camera), image: Some((2, 2)), shading: None }
}

/// The picture of an imported scene after its files were moved and its text was
/// read again; each pixel's colors that are 1 as letters, row by row.
#[track_caller]
pub(in crate::import) fn letters(imported: &Imported) -> String {
    let mut moved = imported.clone();
    moved.move_files("assets");
    let text = moved.text("a").unwrap();
    let loaded = scene::load::<Unchecked>(&text, &moved.files, Build::Bvh).unwrap();
    let picture = tracer::render(&loaded.scene);
    let letter = |(x, letter): (f64, char)| {
        assert!(x == 0.0 || (x - 1.0).abs() < 1e-9, "{x}");
        if x > 0.5 { letter } else { '-' }
    };
    let pixel = |p: &tracer::Rgb| p.channels().into_iter().zip("rgb".chars()).map(letter).collect();
    picture.pixels().iter().map(pixel).collect::<Vec<String>>().join(" ")
}
