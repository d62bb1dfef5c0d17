//! Relations of scenes with textures, which lie in their objects' own space.

use scene::format::Object;

use super::*;

/// Balls, planes and others under a checkerboard, alone, by name and in groups.
const TEXTURED: &str = r#"(
    version: 1, image: (24, 20),
    camera: Perspective(view_point: (1, 2, 7), view_dir: (-0.2, -0.25, -1), view_up: (0.1, 1, 0),
        view_width: 1.2, view_height: 0.9, proj_distance: 1.4),
    materials: {
        "board": Lambert(texture: Checker(a: (0.9, 0.8, 0.7), b: (0.2, 0.1, 0.3), scale: (0.7, 0.9), offset: (0.3, 0.1))),
        "also": Named("board"),
    },
    objects: [
        Plane(point: (0.3, -1, 0.2), normal: (0.1, 1, 0.05), material: Named("also")),
        Sphere(center: (-1.2, 0.2, 0.3), radius: 0.7, material: Constant(
            color: (0.7, 0.8, 0.9),
            texture: Checker(a: (1, 1, 1), b: (0, 0.5, 0), scale: (9, -4), offset: (0.2, 0.3)),
        )),
        Sphere(center: (0.9, 0.9, -0.4), radius: 0.5, material: Lambert(diffuse: (0.6, 0.3, 0.2))),
        Group(
            transform: [Scale(0.7, 0.7, 0.7), RotateDeg(10, 25, 40), Translate(0.9, -0.4, 1.1)],
            material: Named("board"),
            objects: [
                Sphere(center: (0.5, 0.6, 0), radius: 0.6),
                Box(min: (-0.5, -0.7, -0.9), max: (0.8, 0.1, 0.4), material: Lambert()),
            ],
        ),
    ],
    lights: [
        Point(position: (3, 5, 4), intensity: (1, 0.9, 0.8)),
        Ambient(intensity: (0.05, 0.05, 0.06)),
    ],
)"#;

#[test]
fn a_textured_scene_keeps_every_relation() {
    for relation in RELATIONS {
        holds(TEXTURED, relation);
    }
}

#[test]
fn what_turns_or_grows_does_so_in_a_group_with_its_texture() {
    let file = fixture(TEXTURED, "Threads").file;
    let groups = |file: &File| -> Vec<_> {
        file.objects.iter().map(|object| matches!(object, Object::Group { .. })).collect()
    };
    for motion in [
        Motion::quarter_turn(Axis::X),
        Motion::quarter_turn(Axis::Z),
        Motion::mirror(Axis::Y),
        Motion::scale(2.0),
    ] {
        assert_eq!(groups(&motion.file(&file)), [true, true, false, true], "{motion:?}");
    }
    let moved = Motion::translation([1.0, 2.0, 3.0]).file(&file);
    assert_eq!(groups(&moved), [false, false, false, true]);
    let (flat, taken_out) = FlattenGroups::related(&file);
    assert_eq!(taken_out, 1, "the box, not the ball under a texture");
    assert_eq!(groups(&flat)[..4], [false, false, false, true]);
}

/// Left as they are written, textures stay upright: the relation would break.
#[test]
fn a_texture_does_not_turn_by_itself() {
    let fixture = fixture(TEXTURED, "Threads");
    let picture = fixture.render_linear();
    let alike = Alike { within: LOOSEST, edge_pixels: 2 };
    for motion in [Motion::quarter_turn(Axis::Z), Motion::scale(2.0)] {
        let moved = motion.file(&fixture.file);
        for i in 0..2 {
            let mut alone = moved.clone();
            let Object::Group { objects, .. } = &moved.objects[i] else { panic!("{i}") };
            // The shape is moved as it would be without a texture, which it then gets.
            let mut bare = fixture.file.clone();
            let material = objects[0].material().cloned();
            *bare.objects[i].material_mut() = None;
            alone.objects[i] = motion.file(&bare).objects[i].clone();
            *alone.objects[i].material_mut() = material;
            let found = fixture.render_related(&alone).unwrap();
            // A ball that only grows keeps its angles.
            let is_same = i == 1 && motion == Motion::scale(2.0);
            let compared = alike.compare(&motion.picture(&fixture.file, &picture), &found);
            assert_eq!(compared.is_ok(), is_same, "{motion:?} {i}");
        }
    }
}
