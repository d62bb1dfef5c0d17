//! Adaptive pictures against areas that are known by formulas.

use glam::{DVec3, dvec3};

use super::survey::contrast;
use super::*;
use crate::shape::{AxisBox, Shape, Sphere, Triangle};
use crate::{
    Camera, Convention, Falloff, Filter, Group, Light, Material, Member, Object, Projection,
    Samples, SceneParts, Show, Skipping, Stats, View, render, render_counted,
};

/// A white thing on black, seen along z: a pixel is a unit.
fn silhouette(shape: Shape, samples: u32, error: Option<f64>) -> Scene {
    let view = View {
        view_point: DVec3::Z * 50.0,
        view_dir: -DVec3::Z,
        view_up: DVec3::Y,
        proj_normal: None,
        view_width: f64::from(SIZE.width),
        view_height: f64::from(SIZE.height),
    };
    Scene::new(SceneParts {
        camera: Camera::new(&view, Projection::Parallel).unwrap(),
        size: SIZE,
        samples: Samples::grid(samples).unwrap(),
        filter: Filter::BOX,
        error,
        world: Group::world(vec![Member::Object(Object::new(shape, Material::Normal))]),
        lights: vec![],
        convention: Convention::Classic,
        shadows: false,
        bounces: Scene::DEFAULT_BOUNCES,
        background: Rgb::BLACK,
        exposure: 1.0,
        show: Show::Silhouette,
    })
    .unwrap()
}

const SIZE: Size = Size { width: 33, height: 26 };

fn counted(scene: &Scene) -> (LinearImage, Stats) {
    render_counted(scene, &Plan::new(scene, Skipping::On))
}

/// The root mean square difference from `share(x0, y0)`, the covered part of
/// the pixel with this lower left corner.
fn error_of(picture: &LinearImage, share: &dyn Fn(f64, f64) -> f64) -> f64 {
    let Size { width, height } = SIZE;
    let mut sum = 0.0;
    for y in 0..height {
        for x in 0..width {
            let corner = |k: u32, n: u32| f64::from(k) - 0.5 * f64::from(n);
            let exact = share(corner(x, width), corner(height - 1 - y, height));
            let off = picture.get(x, y).unwrap().r - exact;
            sum += off * off;
        }
    }
    (sum / f64::from(width * height)).sqrt()
}

/// The area of a unit square that lies below the line `y = m x + c`, by slices
/// so thin that it is right to 1e-7.
fn below(height: impl Fn(f64) -> f64, x0: f64, y0: f64) -> f64 {
    const SLICES: u32 = 4096;
    let slice = |k: u32| {
        let x = x0 + (f64::from(k) + 0.5) / f64::from(SLICES);
        (height(x) - y0).clamp(0.0, 1.0)
    };
    (0..SLICES).map(slice).sum::<f64>() / f64::from(SLICES)
}

const RADIUS: f64 = 9.37;

fn disk_share(x0: f64, y0: f64) -> f64 {
    let rise = |x: f64| (RADIUS * RADIUS - x * x).max(0.0).sqrt();
    below(rise, x0, y0) - below(|x| -rise(x), x0, y0)
}

fn ball() -> Shape {
    Sphere::new(DVec3::ZERO, RADIUS).unwrap().into()
}

#[test]
fn a_silhouette_is_as_exact_as_asked_for_at_a_fraction_of_the_rays() {
    let measure = |samples, error| {
        let (picture, stats) = counted(&silhouette(ball(), samples, error));
        (error_of(&picture, &disk_share), stats.get(Event::EyeRay))
    };
    let uniform = [2_u32, 4, 8, 16, 32].map(|n| measure(n * n, None));
    for error in [1e-2, 3e-3, 1e-3] {
        let (found, rays) = measure(1, Some(error));
        assert!(found <= error, "{found} for {error}");
        // The cheapest grid that is as good, if there is one.
        let grid = uniform.iter().find(|(grid, _)| *grid <= found * 1.01);
        if let Some((_, most)) = grid {
            let less = if error > 2e-3 { 2 } else { 5 };
            assert!(less * rays < *most, "{rays} rays for {error}, and a grid takes {most}");
        }
    }
}

#[test]
fn edges_of_every_slope_too() {
    for slope in [0.0, 1e-3, -0.1, 0.25, 0.5, -0.683, 1.0, -1.0] {
        for offset in [0.1, 0.2, 1.0 / 3.0, 0.5, 0.77] {
            let line = |x: f64| offset + slope * x;
            // Below the line in the picture, and the other edges far away.
            let corner = |x: f64, y: f64| dvec3(x, y, 0.0);
            let (left, right) = (corner(-90.0, line(-90.0)), corner(90.0, line(90.0)));
            let triangle = || Triangle::new(left, right, corner(0.0, -999.0)).unwrap();
            for error in [1e-2, 1e-3] {
                let (picture, stats) = counted(&silhouette(triangle().into(), 1, Some(error)));
                assert!(stats.get(Event::RefinedPixel) > 30);
                let found = error_of(&picture, &|x0, y0| below(line, x0, y0));
                assert!(found <= error, "{found} for {error}, slope {slope}, offset {offset}");
            }
        }
    }
}

#[test]
fn an_edge_between_pixels_is_exact() {
    let square = AxisBox::new(dvec3(-7.5, -5.0, 0.0), dvec3(3.5, 8.0, 1.0)).unwrap();
    let (picture, _) = counted(&silhouette(square.into(), 1, Some(1e-3)));
    let share = |x0: f64, y0: f64| {
        let is_in = (-7.5..3.5).contains(&x0) && (-5.0..8.0).contains(&y0);
        f64::from(u8::from(is_in))
    };
    assert_eq!(error_of(&picture, &share), 0.0);
}

#[test]
fn mirrored_pixels_have_the_same_bits() {
    let filters = [
        Filter::BOX,
        Filter::tent(1.5).unwrap(),
        Filter::gaussian(0.6).unwrap(),
        Filter::mitchell(2.0).unwrap(),
    ];
    for filter in filters {
        for (samples, error) in [(1, Some(1e-3)), (1, None), (16, None), (9, None)] {
            let scene = silhouette(ball(), samples, error).with_filter(filter).unwrap();
            let (picture, _) = counted(&scene);
            for y in 0..SIZE.height {
                for x in 0..SIZE.width {
                    let here = picture.get(x, y);
                    assert_eq!(here, picture.get(SIZE.width - 1 - x, y), "{filter:?} {samples}");
                    assert_eq!(here, picture.get(x, SIZE.height - 1 - y), "{filter:?} {samples}");
                }
            }
        }
    }
}

#[test]
fn what_no_middle_sees_is_found() {
    // A wire between two columns of middles, and a speck on a corner of four
    // pixels: nothing of them is seen by one sample a pixel.
    let wire = AxisBox::new(dvec3(-3.3, -9.0, 0.0), dvec3(-3.15, 9.0, 1.0)).unwrap();
    let speck = Sphere::new(dvec3(4.5, 3.0, 0.0), 0.2).unwrap();
    for (shape, area) in [(Shape::from(wire), 0.15 * 18.0), (speck.into(), 0.1257)] {
        let sum = |error| {
            let (picture, _) = counted(&silhouette(shape.clone(), 1, error));
            picture.pixels().iter().map(|pixel| pixel.r).sum::<f64>()
        };
        assert_eq!(sum(None), 0.0);
        let found = sum(Some(1e-3));
        assert!((found / area - 1.0).abs() < 0.02, "{found} {area}");
    }
}

#[test]
fn where_nothing_differs_one_sample_is_enough() {
    let wall = || AxisBox::new(dvec3(-99.0, -99.0, 0.0), dvec3(99.0, 99.0, 1.0)).unwrap().into();
    let (_, stats) = counted(&silhouette(wall(), 1, Some(1e-6)));
    assert_eq!(stats.get(Event::EyeRay), u64::from(SIZE.width * SIZE.height));
    assert_eq!(stats.get(Event::RefinedPixel), 0);
}

#[test]
fn shadows_and_highlights_are_refined_and_skipping_changes_no_bit() {
    let member = |shape| {
        let material = Material::BlinnPhong {
            diffuse: Rgb::new(0.5, 0.4, 0.3),
            specular: Rgb::WHITE,
            exponent: 200.0,
        };
        Member::Object(Object::new(shape, material))
    };
    let floor = AxisBox::new(dvec3(-99.0, -99.0, -1.0), dvec3(99.0, 99.0, 0.0)).unwrap();
    let ball = Sphere::new(dvec3(-5.0, 0.0, 6.0), 4.0).unwrap();
    let light = Light::point(dvec3(4.0, 9.0, 30.0), Rgb::WHITE, Falloff::Constant).unwrap();
    let scene = |samples, error| {
        let plain = silhouette(self::ball(), 1, None);
        Scene::new(SceneParts {
            camera: *plain.camera(),
            size: SIZE,
            samples: Samples::grid(samples).unwrap(),
            filter: Filter::BOX,
            error,
            world: Group::world(vec![member(floor.into()), member(ball.into())]),
            lights: vec![light],
            convention: Convention::Classic,
            shadows: true,
            bounces: Scene::DEFAULT_BOUNCES,
            background: Rgb::BLACK,
            exposure: 1.0,
            show: Show::Shaded,
        })
        .unwrap()
    };
    let adaptive = scene(1, Some(2e-3));
    let (picture, stats) = counted(&adaptive);
    let without = render_counted(&adaptive, &Plan::new(&adaptive, Skipping::Off)).0;
    assert!(picture == without && picture == render(&adaptive));
    // Against a grid of 64 by 64.
    let (exact, all) = counted(&scene(4096, None));
    let squares = picture
        .pixels()
        .iter()
        .zip(exact.pixels())
        .map(|(found, exact)| contrast(*found, *exact) * contrast(*found, *exact));
    let error = (squares.sum::<f64>() / f64::from(SIZE.width * SIZE.height)).sqrt();
    assert!(error < 2e-3, "{error}");
    assert!(20 * stats.get(Event::EyeRay) < all.get(Event::EyeRay));
}

#[test]
fn the_error_is_one_that_can_be_asked_for() {
    let plain = silhouette(ball(), 1, None);
    for (error, accepted) in [(1e-6, true), (1.0, true), (0.0, false), (2.0, false)] {
        assert_eq!(plain.with_error(error).is_ok(), accepted, "{error}");
    }
    assert!(plain.with_error(f64::NAN).is_err());
    let refused = Scene::new(SceneParts {
        samples: Samples::grid(4).unwrap(),
        error: Some(0.1),
        ..plain.with_error(0.1).unwrap().parts().clone()
    });
    assert_eq!(refused.unwrap_err().refusals()[0].field, "error");
}
