//! Scenes that fail for a known reason are left with nothing but that.

use scene::NoAssets;
use tracer::accel::Build;

use super::*;
use crate::encode::encode;

/// Eight balls and a box above a floor, two lights; one ball in a group.
const MANY: &str = r"(
    version: 1, image: (64, 48), background: (0.2, 0.2, 0.3), exposure: 1.5,
    camera: LookAt(eye: (0, 3, 12), at: (0, 0, 0), fov_deg: 40),
    objects: [
        Plane(point: (0, -1, 0), normal: (0, 1, 0)),
        Sphere(center: (-3, 0, 0), radius: 0.5), Sphere(center: (-2, 0, 0), radius: 0.5),
        Sphere(center: (-1, 0, 0), radius: 0.5), Sphere(center: (0, 0, 0), radius: 0.5),
        Group(transform: [Translate(1, 0, 0)], objects: [
            Sphere(center: (0, 0, 0), radius: 0.5), Torus(center: (1, 0, 0), axis: (0, 0, 1),
                major_radius: 0.4, minor_radius: 0.1),
        ]),
        Box(min: (2.5, -1, -1), max: (3.5, 1, 1)),
    ],
    lights: [Point(position: (5, 8, 5)), Ambient(intensity: (0.1, 0.1, 0.1))],
    check: (limits: (max_abs: 2, reason: 'a')),
)";

fn fixture() -> Fixture {
    Fixture::read("many", &MANY.replace('\'', "\""), &NoAssets, Build::Bvh).unwrap()
}

/// A renderer that is like this one but for what is done to the file.
fn renderer(change: fn(&mut File)) -> impl Fn(&str) -> Result<EncodedImage, String> {
    move |text| {
        let mut now = Fixture::read("other", text, &NoAssets, Build::Bvh)?;
        change(&mut now.file);
        let picture = now.with_file(now.file.clone())?.render_linear();
        encode(&picture, now.transfer).map_err(|nan| nan.to_string())
    }
}

/// Without any one of its objects the scene fails no more, and few are left.
#[track_caller]
fn check_nothing_can_go(smallest: &Smallest, reference: &Reference<'_>) {
    let objects = &smallest.file.objects;
    assert!(less::count(objects) <= 3, "{objects:?}");
    for place in 0..less::count(objects) {
        let objects = less::without(objects, &mut 0, &(place..place + 1));
        let file = File { objects, check: None, ..smallest.file.clone() };
        assert_eq!(Failure::Reference(reference).why(&fixture(), &file), None, "{place}");
    }
}

#[test]
fn a_shape_that_is_wrong_is_left_alone() {
    // One renderer's tori are thicker: the group goes, and so does all else.
    let thicker = renderer(|file| {
        thicken(&mut file.objects);
    });
    let smallest =
        minimize(&fixture(), &Failure::Reference(&thicker), &|_, _| ()).unwrap().unwrap();
    let objects = format!("{:?}", smallest.file.objects);
    assert!(objects.contains("Torus") && !objects.contains("Sphere"), "{objects}");
    check_nothing_can_go(&smallest, &thicker);
    assert!(smallest.why.contains("largest difference"), "{}", smallest.why);
    let written = scene::write(&smallest.file).unwrap();
    assert!(Fixture::read("small", &written, &NoAssets, Build::Bvh).is_ok(), "{written}");
}

fn thicken(objects: &mut [scene::format::Object]) {
    for object in objects {
        match object {
            scene::format::Object::Torus { minor_radius, .. } => *minor_radius *= 1.5,
            scene::format::Object::Group { objects, .. } => thicken(objects),
            _ => {}
        }
    }
}

#[test]
fn a_shadow_that_is_missing_keeps_what_casts_it_and_what_it_falls_on() {
    let shadowless = renderer(|file| file.shadows = false);
    let smallest =
        minimize(&fixture(), &Failure::Reference(&shadowless), &|_, _| ()).unwrap().unwrap();
    check_nothing_can_go(&smallest, &shadowless);
    assert_eq!(smallest.file.lights.len(), 1);
    assert!(smallest.file.shadows);
}

#[test]
fn what_does_not_fail_has_no_smallest() {
    let right = renderer(|_| ());
    assert_eq!(minimize(&fixture(), &Failure::Reference(&right), &|_, _| ()), Ok(None));
    assert!(Failure::of(&fixture(), &|_| ()).is_none());
    let broken = |_: &str| Err("no such renderer".to_owned());
    let found = minimize(&fixture(), &Failure::Reference(&broken), &|_, _| ());
    assert_eq!(found, Err("no such renderer".to_owned()));
}

#[test]
fn a_broken_relation_stays_broken_in_the_same_way() {
    // Two triangles at the very same distance: which is seen follows the order.
    const TIE: &str = r"(
        version: 1, image: (32, 24), camera: Parallel(view_point: (0, 0, 5), view_width: 8),
        objects: [
            Box(min: (-4, -1, -1), max: (-3, 1, 1), material: Constant(color: (0, 1, 0))),
            Triangle(a: (0, 0, 0), b: (2, 0, 0), c: (0, 0.5, 0), material: Constant(color: (1, 0, 0))),
            Triangle(a: (0, 0, 0), b: (2, 0, 0), c: (0, 0.5, 0), material: Constant(color: (0, 0, 1))),
        ],
        check: (relations: [Threads, PermuteObjects()]),
    )";
    let fixture = Fixture::read("tie", TIE, &NoAssets, Build::Bvh).unwrap();
    let failure = Failure::of(&fixture, &|_| ()).unwrap();
    let smallest = minimize(&fixture, &failure, &|_, _| ()).unwrap().unwrap();
    assert!(smallest.why.contains("PermuteObjects()") && smallest.why.contains("differ"));
    assert_eq!(less::count(&smallest.file.objects), 2, "{:?}", smallest.file.objects);
    // One color says nothing, which is no failure to be made small.
    let flat = "(version: 1, image: (8, 8), camera: Parallel(view_point: (0, 0, 5)))";
    let flat = Fixture::read("flat", flat, &NoAssets, Build::Bvh).unwrap();
    assert!(Failure::of(&flat, &|_| ()).is_none());
}
