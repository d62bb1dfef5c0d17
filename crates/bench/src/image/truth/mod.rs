//! The picture that a scene's pictures are held against.
//!
//! For a disk it is a formula. For all others every pixel is looked at on a
//! grid; where the looks bend, its mean is an integral, line by line, each line
//! cut at what it crosses: no sampling pattern of any renderer is in it.

mod disk;
mod integral;

use std::path::Path;

use rayon::prelude::*;
use tracer::{Interval, LinearImage, Rgb, Scene, Size};

pub(crate) use disk::disk;
use integral::integral;

use crate::files;

/// Counts up when the method below gives other numbers.
const METHOD: u32 = 1;

/// Looks along each side of a pixel before it is decided how to find its mean.
const GRID: u32 = 4;
/// The bend, a second difference of looks side by side, up to which their mean is
/// the pixel's: it is then off by at most a 24th of this for each axis.
const CALM: f64 = 3e-4;
/// How far an integral along a line may be off, and one over all lines of a pixel:
/// ten times below what the smallest error asked for could feel.
const ALONG: f64 = 1e-4;
const ACROSS: f64 = 3e-5;

/// The truth, from the file that it was kept in or found anew and kept.
///
/// # Errors
/// Says so if the file cannot be written, or the scene is brighter than 1, which
/// some renderers' files cannot hold.
pub(crate) fn kept(
    folder: &Path,
    name: &str,
    scene: &Scene,
    find: impl FnOnce() -> Result<LinearImage, String>,
) -> Result<LinearImage, String> {
    let path = folder.join(format!("truth-{METHOD}.f64"));
    let kept = files::read_kept(&path).and_then(|bytes| from_bytes(&bytes, scene.size()));
    let picture = if let Some(picture) = kept {
        picture
    } else {
        let picture = find()?;
        files::write(&path, &to_bytes(&picture))?;
        picture
    };
    let brightest = picture.pixels().iter().flat_map(|pixel| pixel.channels()).fold(0.0, f64::max);
    if brightest <= 1.0 {
        return Ok(picture);
    }
    Err(format!(
        "scene {name}: expected no channel above 1, which some renderers cut, found {brightest}; \
         make its lights weaker"
    ))
}

fn to_bytes(picture: &LinearImage) -> Vec<u8> {
    let channels = picture.pixels().iter().flat_map(|pixel| pixel.channels());
    channels.flat_map(f64::to_le_bytes).collect()
}

fn from_bytes(bytes: &[u8], size: Size) -> Option<LinearImage> {
    let (numbers, rest) = bytes.as_chunks::<8>();
    let numbers: Vec<_> = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let (pixels, more) = numbers.as_chunks::<3>();
    if !(rest.is_empty() && more.is_empty()) {
        return None;
    }
    LinearImage::from_pixels(size, pixels.iter().map(|pixel| Rgb::from(*pixel)).collect())
}

/// How far integrals may be off: along a line, and over all lines of a pixel.
#[derive(Debug, Clone, Copy)]
struct Tolerance {
    along: f64,
    across: f64,
}

/// The scene, continuous: what is seen at any place of the picture.
struct Plane<'a>(&'a Scene);

impl Plane<'_> {
    /// What is seen so many pixels to the right of the left border and below the
    /// upper one.
    fn look(&self, x: f64, y: f64) -> Rgb {
        let (scene, camera) = (self.0, self.0.camera());
        let Size { width, height } = scene.size();
        let a = (x / f64::from(width) - 0.5) * camera.view_width();
        let b = (0.5 - y / f64::from(height)) * camera.view_height();
        scene.trace(&camera.ray(a, b), Interval::AHEAD) * scene.exposure()
    }

    /// The looks in the middles of the cells of one row of the grid, one more at
    /// each end; row 0 is the one above the picture.
    fn row(&self, row: u32) -> Vec<Rgb> {
        let middle = |k: u32| (f64::from(k) - 0.5) / f64::from(GRID);
        let cells = self.0.size().width * GRID + 2;
        (0..cells).map(|k| self.look(middle(k), middle(row))).collect()
    }

    /// The mean over the pixel with this upper left corner.
    fn mean(&self, x: u32, y: u32, Tolerance { along, across }: Tolerance) -> Rgb {
        let (x, y) = (f64::from(x), f64::from(y));
        integral(&mut |v| integral(&mut |u| self.look(x + u, y + v), along), across)
    }
}

/// The mean of every pixel.
pub(crate) fn integrated(scene: &Scene) -> LinearImage {
    integrated_to(scene, Tolerance { along: ALONG, across: ACROSS })
}

fn integrated_to(scene: &Scene, tolerance: Tolerance) -> LinearImage {
    let plane = Plane(scene);
    let size = scene.size();
    let rows: Vec<Vec<Rgb>> = (0..size.height)
        .into_par_iter()
        .map(|y| {
            // The rows of this pixel row's cells, and the ones above and below.
            let rows: Vec<_> = (0..GRID + 2).map(|k| plane.row(y * GRID + k)).collect();
            (0..size.width)
                .map(|x| {
                    let looks =
                        |column: u32, row: u32| rows[row as usize][(x * GRID + column) as usize];
                    if is_calm(&looks) { mean_of(&looks) } else { plane.mean(x, y, tolerance) }
                })
                .collect()
        })
        .collect();
    LinearImage::from_fn(size, |x, y| rows[y as usize][x as usize])
}

/// Whether none of the cells, numbered from 1, bends against those beside it.
fn is_calm(looks: &impl Fn(u32, u32) -> Rgb) -> bool {
    let inside = || (1..=GRID).flat_map(|row| (1..=GRID).map(move |column| (column, row)));
    inside().all(|(column, row)| {
        let ends = [
            (looks(column - 1, row), looks(column + 1, row)),
            (looks(column, row - 1), looks(column, row + 1)),
            (looks(column - 1, row - 1), looks(column + 1, row + 1)),
            (looks(column - 1, row + 1), looks(column + 1, row - 1)),
        ];
        let here = looks(column, row);
        ends.into_iter().all(|(one, other)| integral::largest(one + other + here * -2.0) <= CALM)
    })
}

fn mean_of(looks: &impl Fn(u32, u32) -> Rgb) -> Rgb {
    let mut sum = Rgb::BLACK;
    for row in 1..=GRID {
        for column in 1..=GRID {
            sum += looks(column, row);
        }
    }
    sum * (1.0 / f64::from(GRID * GRID))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::picture::rmse;
    use crate::image::scenes;

    #[test]
    fn the_integral_of_a_disk_is_its_formula() {
        let source = &scenes::all()[0];
        let read = source.read(Some((80, 60))).unwrap();
        let formula = disk(&read).unwrap();
        let error = rmse(&integrated(&read.accurate), &formula);
        assert!(0.0 < error && error < 2e-5, "{error}");
    }

    /// Where nearly every pixel has edges in it, a quarter of the tolerance
    /// changes next to nothing.
    #[test]
    fn a_finer_integral_of_a_city_is_no_other() {
        let sources = scenes::all();
        let city = sources.iter().find(|source| source.name == "city").unwrap();
        let scene = city.read(Some((32, 24))).unwrap().accurate;
        let finer = Tolerance { along: ALONG / 4.0, across: ACROSS / 4.0 };
        let error = rmse(&integrated(&scene), &integrated_to(&scene, finer));
        assert!(0.0 < error && error < 3e-5, "{error}");
    }

    #[test]
    fn what_is_kept_is_found_again_and_nothing_else() {
        let size = Size { width: 2, height: 1 };
        let picture = LinearImage::from_fn(size, |x, _| Rgb::new(f64::from(x), 0.1, 0.7));
        let bytes = to_bytes(&picture);
        assert_eq!(from_bytes(&bytes, size), Some(picture));
        assert_eq!(from_bytes(&bytes[1..], size), None);
        assert_eq!(from_bytes(&bytes, Size { width: 3, height: 1 }), None);
    }
}
