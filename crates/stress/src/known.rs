//! `Known`: pictures of which every pixel is known by a formula, to hold samples
//! to.
//!
//! White things on black under a parallel camera that looks along z, a pixel
//! being a unit: what a pixel shows is how much of it is covered, which
//! [`coverage`] says.

use tracer::glam::{DVec3, dvec3};
use tracer::shape::{AxisBox, Shape, Sphere, Triangle};
use tracer::{
    Camera, Convention, Filter, Group, LinearImage, Material, Member, Object, Projection, Refused,
    Rgb, Samples, Scene, SceneParts, Show, Size, View,
};

use crate::Random;
use crate::truth::coverage::{self, Point};

/// A picture that is known.
pub struct Known {
    /// What it shows, in a word or two.
    pub name: &'static str,
    /// With one sample a pixel; sample it otherwise by the scene's own methods.
    pub scene: Scene,
    /// The exact value of every channel, row by row from the top.
    pub truth: Vec<f64>,
}

/// Odd and even, and no multiple of a tile.
const SIZE: Size = Size { width: 93, height: 70 };

/// The corners of "one box". No coordinate here is a short fraction, of which some
/// grid of samples would be exact.
pub const BOX: (Point, Point) = ([-31.317, -20.643], [30.829, 19.457]);

impl Known {
    /// A scene of these things, of which pixels show as much as `share` says of
    /// the unit square with this lower left corner, from the picture's middle.
    fn new(
        name: &'static str,
        shapes: Vec<Shape>,
        share: impl Fn(Point) -> f64,
    ) -> Result<Self, Refused> {
        const FAR: f64 = 100.0;
        let view = View {
            view_point: DVec3::Z * FAR,
            view_dir: -DVec3::Z,
            view_up: DVec3::Y,
            proj_normal: None,
            view_width: f64::from(SIZE.width),
            view_height: f64::from(SIZE.height),
        };
        let member = |shape| Member::Object(Object::new(shape, Material::Normal));
        let scene = Scene::new(SceneParts {
            camera: Camera::new(&view, Projection::Parallel)?,
            size: SIZE,
            samples: Samples::ONE,
            filter: Filter::BOX,
            error: None,
            world: Group::world(shapes.into_iter().map(member).collect()),
            lights: vec![],
            convention: Convention::Classic,
            shadows: false,
            bounces: Scene::DEFAULT_BOUNCES,
            background: Rgb::BLACK,
            exposure: 1.0,
            show: Show::Silhouette,
        })?;
        let corner = |k: u32, n: u32| f64::from(k) - 0.5 * f64::from(n);
        let truth = (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| (x, y)));
        let truth = truth
            .map(|(x, y)| share([corner(x, SIZE.width), corner(SIZE.height - 1 - y, SIZE.height)]));
        Ok(Self { name, scene, truth: truth.collect() })
    }

    /// How far a picture is off, in the root mean square over all pixels.
    pub fn rmse(&self, picture: &LinearImage) -> f64 {
        let off = self.errors(picture);
        (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt()
    }

    /// How far each pixel is off.
    pub fn errors(&self, picture: &LinearImage) -> Vec<f64> {
        picture.pixels().iter().zip(&self.truth).map(|(found, exact)| found.r - exact).collect()
    }
}

/// All of them.
///
/// # Errors
/// None that is known: a refusal of one of the tracer's constructors, whose
/// numbers are all within what they take.
pub fn known_pictures() -> Result<Vec<Known>, Refused> {
    Ok(vec![
        disks("one ball", &[([0.31, -0.17], 29.37)])?,
        upright("one box", &[(BOX.0, BOX.1)])?,
        polygons("slanted edges", &[vec![[-41.0, -30.2], [39.7, -17.1], [2.3, 31.6]]])?,
        disks("many balls", &scattered_disks(7, [0.6, 4.0]))?,
        disks("specks", &scattered_disks(8, [0.15, 0.45]))?,
        polygons(
            "needles",
            &[
                vec![[-44.0, -30.0], [43.1, 27.4], [43.0, 27.9]],
                vec![[-40.0, 20.3], [10.0, 31.0], [10.0, 31.6]],
                vec![[20.0, -5.0], [20.3, -5.0], [29.0, -31.0]],
            ],
        )?,
        upright("bars", &bars())?,
        checkers("checker", 7.317)?,
        checkers("fine checker", 2.617)?,
    ])
}

/// Balls.
fn disks(name: &'static str, disks: &[(Point, f64)]) -> Result<Known, Refused> {
    let ball =
        |([x, y], radius): &(Point, f64)| Ok(Sphere::new(dvec3(*x, *y, 0.0), *radius)?.into());
    let shapes = disks.iter().map(ball).collect::<Result<_, Refused>>()?;
    Known::new(name, shapes, |corner| {
        disks.iter().map(|(center, radius)| coverage::disk(*center, *radius, corner)).sum()
    })
}

/// Boxes, seen from the front.
fn upright(name: &'static str, boxes: &[(Point, Point)]) -> Result<Known, Refused> {
    let shape = |(min, max): &(Point, Point)| {
        Ok(AxisBox::new(dvec3(min[0], min[1], -1.0), dvec3(max[0], max[1], 1.0))?.into())
    };
    let shapes = boxes.iter().map(shape).collect::<Result<_, Refused>>()?;
    Known::new(name, shapes, |corner| {
        boxes.iter().map(|(min, max)| coverage::rectangle(*min, *max, corner)).sum()
    })
}

/// Triangles that do not meet, or at most in points.
fn polygons(name: &'static str, triangles: &[Vec<Point>]) -> Result<Known, Refused> {
    let corner = |[x, y]: Point| dvec3(x, y, 0.0);
    let shape =
        |p: &Vec<Point>| Ok(Triangle::new(corner(p[0]), corner(p[1]), corner(p[2]))?.into());
    let shapes = triangles.iter().map(shape).collect::<Result<_, Refused>>()?;
    Known::new(name, shapes, |pixel| {
        triangles.iter().map(|points| coverage::polygon(points, pixel)).sum()
    })
}

/// Fields of a checkerboard, all over the picture.
fn checkers(name: &'static str, width: f64) -> Result<Known, Refused> {
    let fields = (0.6 * f64::from(SIZE.width) / width).ceil() as i32;
    let mut shapes = Vec::new();
    for y in -fields..fields {
        for x in (-fields..fields).filter(|x| (x + y) % 2 == 0) {
            let [min, max] = [0, 1].map(|k| dvec3(f64::from(x + k), f64::from(y + k), 0.0) * width);
            shapes.push(AxisBox::new(min - DVec3::Z, max + DVec3::Z)?.into());
        }
    }
    Known::new(name, shapes, |corner| coverage::checker(width, corner))
}

/// Disks that do not meet, in cells of a lattice.
fn scattered_disks(seed: u64, [least, most]: [f64; 2]) -> Vec<(Point, f64)> {
    /// Width of a cell: two of the largest disks', and room to move.
    const CELL: f64 = 11.0;
    let random = &mut Random::of_chunk(seed, "known/disks", 0);
    let mut disks = Vec::new();
    for row in -2..=2 {
        for column in -3..=3 {
            let radius = least + (most - least) * random.unit();
            let mut along = |k: i32| (f64::from(k) + 0.5 * (random.unit() - 0.5)) * CELL;
            disks.push(([along(column), along(row)], radius));
        }
    }
    disks
}

/// Bars narrower than a pixel, upright and lying, with and without a pixel's
/// middle in them.
fn bars() -> Vec<(Point, Point)> {
    let upright = (0..9).map(|k| {
        let x = -43.013 + 4.617 * f64::from(k);
        ([x, -30.4], [x + 0.1 * f64::from(k + 1), 30.3])
    });
    let lying = (0..9).map(|k| {
        let y = -30.027 + 6.371 * f64::from(k);
        ([5.2, y], [40.7, y + 0.07 * f64::from(k + 1)])
    });
    upright.chain(lying).collect()
}
