//! The textures that the fixtures use, and the mesh that they lie on, made by code.

use font8x8::legacy::BASIC_LEGACY;
use tracer::Size;

use crate::encode::EncodedImage;
use crate::golden::to_png;

/// The files and their bytes, by path relative to the suite.
///
/// # Errors
/// What the encoder of PNG files says.
pub fn sample_textures() -> Result<Vec<(&'static str, Vec<u8>)>, String> {
    let png = |size, texel: &dyn Fn(u32, u32) -> [u8; 3]| {
        let picture = EncodedImage::from_fn(size, texel);
        to_png(&picture, None)
    };
    Ok(vec![
        ("fixtures/texture/assets/square.obj", SQUARE.as_bytes().to_vec()),
        ("fixtures/texture/assets/steps.png", png(STEPS, &step)?),
        ("fixtures/texture/assets/letters.png", png(LETTERS, &letter)?),
    ])
}

/// The square from 0 to 1 in x and y, whose texture coordinates are its own.
const SQUARE: &str = "\
# made by cargo xtask meshes
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3
f 1/1 3/3 4/4
";

const STEPS: Size = Size { width: 4, height: 4 };

/// Texels that all differ: red by 51 to the right, green by 51 downwards, and a
/// blue that is in the upper left only.
fn step(x: u32, y: u32) -> [u8; 3] {
    const STEP: u32 = 51;
    [(STEP * x) as u8, (STEP * y) as u8, if (x, y) == (0, 0) { 255 } else { 0 }]
}

/// Two letters of eight by eight texels.
const LETTERS: Size = Size { width: 16, height: 8 };

/// `FR`, which no turn and no mirror makes the same again, in white on two colors.
fn letter(x: u32, y: u32) -> [u8; 3] {
    let (letter, ground) = if x < 8 { ('F', [200, 60, 20]) } else { ('R', [20, 90, 180]) };
    let is_ink = BASIC_LEGACY[letter as usize][y as usize % 8] >> (x % 8) & 1 == 1;
    if is_ink { [255; 3] } else { ground }
}
