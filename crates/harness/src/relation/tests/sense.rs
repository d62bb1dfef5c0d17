//! What a relation must have to say anything, asked before anything is rendered.

use super::*;

/// What is wrong with this relation of this scene, as the reader of the fixture
/// is told it; nothing for a good one.
fn problems(scene: &str, relation: &str) -> String {
    match Fixture::read("a.ron", &text(scene, relation), &NoAssets, Build::Bvh) {
        Ok(_) => String::new(),
        Err(why) => why.lines().next().unwrap_or("").to_owned(),
    }
}

#[track_caller]
fn check(scene: &str, relation: &str, expected: &str) {
    let found = problems(scene, relation);
    let name = relation.split('(').next().unwrap();
    assert!(found.starts_with("a.ron:"), "{relation}: {found}");
    assert!(found.ends_with(&format!(": {name}: {expected}")), "{relation}: {found}");
}

const EMPTY: &str = "(version: 1, image: (40, 30), camera: Parallel(view_point: (0, 0, 5)))";
const BALL: &str = "(version: 1, image: (40, 30), camera: Parallel(view_point: (0, 0, 5)), \
                    objects: [Sphere(center: (0, 0, 0), radius: 1)])";
const CARD: &str = "(version: 1, image: (40, 30), camera: Parallel(view_point: (0, 0, 5)), \
                    objects: [Box(min: (0, 0, 0), max: (1, 1, 0))])";

#[test]
fn what_a_relation_works_on_must_be_there() {
    for relation in ["Translate(by: (1, 0, 0))", "QuarterTurn(axis: X)", "Mirror(axis: X)"] {
        check(EMPTY, relation, "expected an object, found none");
    }
    let grouped = BALL.replace(
        "Sphere(center: (0, 0, 0), radius: 1)",
        "Group(transform: \
        [Scale(1, 2, 1)], objects: [Sphere(center: (0, 0, 0), radius: 1)])",
    );
    for scene in [EMPTY, BALL, CARD, &grouped] {
        let expected =
            "expected a shape in a group that can be put where it is without, found none";
        check(scene, "FlattenGroups()", expected);
    }
    let parallel = "expected a perspective camera, as a parallel one's window has no distance";
    check(BALL, "ScaleWindow(by: 2)", parallel);
    for relation in ["ScaleUnits(by: 2)", "IdentityGroup", "NoSkipping"] {
        check(EMPTY, relation, "expected an object, found none");
    }
    for scene in [EMPTY, BALL, CARD] {
        let expected = "expected a box with thickness among the objects, found none";
        check(scene, "SplitBoxes()", expected);
        check(scene, "PermuteObjects()", "expected two objects in one list, found none");
        let expected = "expected a mesh or two objects in one list, found neither";
        check(scene, "NoAccelerator", expected);
    }
    check(BALL, "SumOfLights()", "expected two lights or more, found 0");
    let row = BALL.replace("(40, 30)", "(40, 1)");
    check(&row, "Threads", "expected two rows of pixels or more to share, found one");
    let grouped = BALL.replace(
        "objects: [",
        "objects: [Group(objects: [Sphere(center: (0, 0, 0), \
         radius: 1), Sphere(center: (0, 0, 0), radius: 2)]), ",
    );
    assert_eq!(problems(&grouped, "PermuteObjects(), NoAccelerator"), "");
}

/// A number as it is printed.
fn shown(by: &str) -> String {
    by.parse::<f64>().map_or(by.to_owned(), |by| by.to_string())
}

#[test]
fn a_relation_that_does_nothing_is_none() {
    let factor =
        "`by`: expected a number from 1e-6 to 1e6 that is not 1, but for 0.01 or more, found ";
    for by in ["1", "0", "-2", "inf", "NaN", "1.0000000000000002", "1.009", "1e300"] {
        check(BALL, &format!("ScaleUnits(by: {by})"), &format!("{factor}{}", shown(by)));
        check(BALL, &format!("Exposure(by: {by})"), &format!("{factor}{}", shown(by)));
        let perspective = BALL.replace("Parallel", "Perspective");
        check(&perspective, &format!("ScaleWindow(by: {by})"), &format!("{factor}{}", shown(by)));
    }
    let way = "`by`: expected three finite numbers, one of 0.001 or more, found ";
    check(BALL, "Translate(by: (1e-300, 0, 0))", &format!("{way}[1e-300, 0.0, 0.0]"));
    check(BALL, "Translate(by: (0, -0, 0))", &format!("{way}[0.0, -0.0, 0.0]"));
    check(BALL, "Translate(by: (0, inf, 0))", &format!("{way}[0.0, inf, 0.0]"));
    let part = "`size`: expected a part of the picture, which is 40 x 30, found ";
    for (at, size, found) in [
        ("(0, 0)", "(40, 30)", "40 x 30 at (0, 0)"),
        ("(1, 0)", "(40, 10)", "40 x 10 at (1, 0)"),
        ("(0, 0)", "(0, 10)", "0 x 10 at (0, 0)"),
        ("(4294967295, 0)", "(2, 10)", "2 x 10 at (4294967295, 0)"),
    ] {
        check(BALL, &format!("Crop(at: {at}, size: {size})"), &format!("{part}{found}"));
    }
}

#[test]
fn what_cannot_be_related_is_said() {
    let with = |field: &str| SCENE.replace("shading: Attenuated", field);
    let order = "expected a picture that does not show numbers of objects, as these follow the \
                 order";
    check(&with("show: ObjectIds"), "PermuteObjects()", order);
    let own = "expected a picture that does not show numbers of objects, as triangles have their \
               own";
    check(&with("show: ObjectIds"), "SplitBoxes()", own);
    check(&with("show: ObjectIds"), "FlattenGroups()", own);
    let lit = "expected a shaded picture, as others do not show light";
    check(&with("show: Normals"), "SumOfLights()", lit);
    let exposed = "expected a shaded picture with an exposure above 0, as no other is exposed";
    check(&with("show: Normals"), "Exposure(by: 2)", exposed);
    check(&with("exposure: 0"), "Exposure(by: 2)", exposed);
    let grid = "expected samples on a grid, as scattered ones are not mirrored";
    check(&with("sampler: Sobol()"), "Mirror(axis: X)", grid);
    let place =
        "expected samples on a grid and the filter `Box`, as others depend on where a pixel is";
    check(&with("sampler: Sobol()"), "Crop(at: (0, 0), size: (2, 2))", place);
    check(&with("filter: Tent()"), "Crop(at: (0, 0), size: (2, 2))", place);
    let error = "expected a scene without `error`, as other pictures have other samples";
    for relation in
        ["Crop(at: (0, 0), size: (2, 2))", "Exposure(by: 2)", "SumOfLights()", "FlattenGroups()"]
    {
        check(&with("error: 0.01"), relation, error);
    }
    let bright = SCENE.replace("(0.05, 0.1, 0.2)", "(0.05, 0.1, 1.2)");
    let bright = bright.replace("shading: Attenuated", "show: Normals");
    let background = "expected a background of at most 1, as colors of normals turn with the scene";
    check(&bright, "QuarterTurn(axis: Z)", background);
    assert_eq!(problems(&bright, "Translate(by: (1, 0, 0))"), "");
    let normal = "expected no material `Normal`, as its colors turn with the scene";
    let ball = BALL.replace("radius: 1", "radius: 1, material: Normal");
    check(&ball, "Mirror(axis: Z)", normal);
    let named = BALL.replace("objects:", "materials: { \"n\": Normal }, objects:");
    check(&named, "QuarterTurn(axis: Z)", normal);
    assert_eq!(problems(&ball, "ScaleUnits(by: 2)"), "");
}

#[test]
fn allowances_have_bounds_and_forms_are_checked() {
    let within = "`within`: expected a number from 0 to 0.000001, found ";
    check(BALL, "ScaleUnits(by: 2, within: 0.001)", &format!("{within}0.001"));
    check(BALL, "ScaleUnits(by: 2, within: NaN)", &format!("{within}NaN"));
    let edges = "`edge_pixels`: expected at most 6 of the picture's 1200 pixels, found 7";
    check(BALL, "ScaleUnits(by: 2, edge_pixels: 7)", edges);
    assert_eq!(problems(BALL, "ScaleUnits(by: 2, within: 1e-9, edge_pixels: 6)"), "");
    for (relation, expected) in [
        ("Rotate(by: 2)", "Rotate"),
        ("ScaleUnits(by: 2, withn: 0)", "withn"),
        ("QuarterTurn(axis: W)", "W"),
        ("ScaleUnits()", "by"),
        ("Threads(4)", "Threads"),
    ] {
        let found = problems(BALL, relation);
        assert!(found.contains(expected), "{relation}: {found}");
    }
}

#[test]
fn a_scene_that_cannot_be_read_in_full_is_not_judged_for_its_relations() {
    let text = text(&CARD.replace("Box(", "Bux("), "SplitBoxes()");
    let why = Fixture::read("a.ron", &text, &NoAssets, Build::Bvh).unwrap_err();
    assert!(why.contains("Bux") && !why.contains("SplitBoxes:"), "{why}");
}
