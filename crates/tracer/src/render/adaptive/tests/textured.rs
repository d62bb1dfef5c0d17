//! Edges inside a texture, which are no edges of an object.

use std::sync::Arc;

use super::*;
use crate::shape::Plane;
use crate::texture::{Checker, Image, Pattern, TexelFilter, Texels, Wrap};
use crate::{Texture, Transform, accel::Build};

/// The shape under this texture, turned by so many degrees about the line of
/// sight, in a picture where a pixel is a unit.
fn textured(shape: Shape, texture: &Arc<Texture>, turn_deg: f64) -> Scene {
    let object = Object::textured(shape, Material::Constant(Rgb::WHITE), Arc::clone(texture));
    let turn = Transform::rotation_deg(dvec3(0.0, 0.0, turn_deg)).unwrap();
    let world = Group::new(turn, vec![Member::Object(object.unwrap())], Build::Bvh);
    let plain = silhouette(ball(), 1, None);
    Scene::new(SceneParts { world, show: Show::Shaded, ..plain.parts().clone() }).unwrap()
}

fn checker(scale: [f64; 2]) -> Arc<Texture> {
    let checker = Checker::new([Rgb::new(1.0, 0.7, 0.2), Rgb::new(0.0, 0.1, 0.9)]).unwrap();
    Arc::new(Texture::new(Pattern::Checker(checker), scale, [0.37, 0.19]).unwrap())
}

/// Steps of a tenth to the right, each as wide as a pixel, so that the middles of
/// pixels lie on a straight line.
fn stairs(filter: TexelFilter) -> Arc<Texture> {
    let codes = (0..11).map(|code| [code; 3]).collect();
    let levels = (0..11).map(|code| f64::from(code) / 10.0).collect();
    let texels = Texels::new(Size { width: 11, height: 1 }, codes, levels).unwrap();
    let image = Image::new(Arc::new(texels), filter, Wrap::Repeat);
    Arc::new(Texture::new(Pattern::Image(image), [1.0 / 11.0, 1.0], [0.01, 0.0]).unwrap())
}

/// Against a grid of 64 by 64, which is off by less than this along slanted edges and
/// small steps.
#[track_caller]
fn check(scene: &Scene, asked: f64) {
    let (found, stats) = counted(&scene.with_error(asked).unwrap());
    let (exact, all) = counted(&scene.with_samples(Samples::grid(4096).unwrap()).unwrap());
    let pairs = found.pixels().iter().zip(exact.pixels());
    let squares = pairs.map(|(a, b)| contrast(*a, *b) * contrast(*a, *b));
    let error = (squares.sum::<f64>() / f64::from(SIZE.width * SIZE.height)).sqrt();
    assert!(error <= asked, "{error} for {asked}");
    assert!(3 * stats.get(Event::EyeRay) < all.get(Event::EyeRay));
}

fn wall() -> Shape {
    Plane::new(DVec3::ZERO, DVec3::Z).unwrap().into()
}

/// How much of a unit square with this lower left corner has the first color of
/// `checker` on a wall that is turned: by lines from bottom to top, each cut where
/// it leaves a square, so many that it is right to 1e-6.
fn share(scale: f64, turn_deg: f64, [x0, y0]: [f64; 2]) -> f64 {
    const LINES: u32 = 1024;
    let (sin, cos) = crate::math::sin_cos_deg(turn_deg);
    let of_line = |k: u32| {
        let x = x0 + (f64::from(k) + 0.5) / f64::from(LINES);
        // Both coordinates of the wall as `start + slope y`.
        let u = (scale * cos * x + 0.37, scale * sin);
        let v = (-scale * sin * x + 0.19, scale * cos);
        let mut ends = vec![y0, y0 + 1.0];
        for (start, slope) in [u, v] {
            let (a, b) = (start + slope * y0, start + slope * (y0 + 1.0));
            let whole = a.min(b).ceil() as i32..=a.max(b).floor() as i32;
            let cuts = whole.map(|n| (f64::from(n) - start) / slope);
            ends.extend(cuts.filter(|y| (y0..y0 + 1.0).contains(y)));
        }
        ends.sort_by(f64::total_cmp);
        let part = |pair: &[f64]| {
            let y = 0.5 * (pair[0] + pair[1]);
            let [u, v] = [u, v].map(|(start, slope)| (start + slope * y).floor());
            if (u + v).rem_euclid(2.0) == 0.0 { pair[1] - pair[0] } else { 0.0 }
        };
        ends.windows(2).map(part).sum::<f64>()
    };
    (0..LINES).map(of_line).sum::<f64>() / f64::from(LINES)
}

/// As [`error_of`], but for the pixels at the picture's border: an edge that only
/// they have in them may be seen by no middle, as those beyond are not looked at.
fn error_inside(picture: &LinearImage, share: &dyn Fn(f64, f64) -> f64) -> f64 {
    let Size { width, height } = SIZE;
    let (mut sum, mut count) = (0.0, 0.0);
    for (x, y) in (1..height - 1).flat_map(|y| (1..width - 1).map(move |x| (x, y))) {
        let corner = |k: u32, n: u32| f64::from(k) - 0.5 * f64::from(n);
        let exact = share(corner(x, width), corner(height - 1 - y, height));
        let off = picture.get(x, y).unwrap().r - exact;
        sum += off * off;
        count += 1.0;
    }
    (sum / count).sqrt()
}

#[test]
fn a_checkerboard_is_as_exact_as_asked_for() {
    for (turn_deg, squares, asked) in [
        (0.0, 0.11, 1e-3),
        (0.0, 0.23, 1e-3),
        (1.0, 0.11, 1e-3),
        (17.0, 0.11, 1e-3),
        (17.0, 0.23, 1e-3),
        (45.0, 0.23, 1e-3),
        (17.0, 0.2, 1e-2),
    ] {
        let scene = textured(wall(), &checker([squares, squares]), turn_deg);
        let (picture, stats) = counted(&scene.with_error(asked).unwrap());
        let error = error_inside(&picture, &|x, y| share(squares, turn_deg, [x, y]));
        assert!(error <= asked, "{error} for {asked} at {turn_deg} degrees, {squares}");
        assert!(stats.get(Event::EyeRay) < 858 * 1024);
    }
}

#[test]
fn so_is_one_on_a_ball() {
    check(&textured(ball(), &checker([8.0, 4.0]), 20.0), 1e-3);
}

#[test]
fn so_are_texels() {
    for filter in [TexelFilter::Nearest, TexelFilter::Bilinear] {
        check(&textured(wall(), &stairs(filter), 0.0), 1e-3);
        check(&textured(wall(), &stairs(filter), 10.0), 1e-3);
    }
}
