//! Mistakes of meaning: names, kinds and numbers of values.

use super::schema::{Gain, Scene};
use super::{check, objects, problems};

/// Checks a scene with these objects, or other fields; places are in the whole line.
#[track_caller]
fn check_fields(fields: &str, expected: &[&str]) {
    check::<Scene>(&objects(fields), expected);
}

#[test]
fn unknown_fields_come_with_the_nearest_known_one() {
    check_fields(
        "objects: [Sphere(center: (0,0,0), raduis: 1, material: \"red\")]",
        &["1:77 unknown field `raduis` in `Sphere` | \
           did you mean `radius`? known here: `center`, `radius`, `material`"],
    );
    check_fields(
        "objects: [], colour: 3",
        &["1:56 unknown field `colour` in `Scene` | known here: `version`, `image`, `camera`, \
           `materials`, `objects`, `lights`, `sky`, `gain`"],
    );
    check_fields("objects: [], lihgts: 1", &["1:56 unknown field `lihgts` in `Scene`"]);
}

#[test]
fn the_value_of_a_misspelled_field_is_read_too() {
    check_fields(
        "objects: [Sphere(center: (0,0,0), raduis: \"big\", material: \"red\")]",
        &[
            "1:77 unknown field `raduis` in `Sphere`",
            "1:85 expected a number, found the text `\"big\"`",
        ],
    );
}

#[test]
fn every_missing_field_is_named() {
    check_fields(
        "objects: [Sphere(center: (0,0,0), material: \"red\"), Sphere()]",
        &[
            "1:53 `Sphere` has no field `radius`, which it needs",
            "1:95 `Sphere` has no field `center`, which it needs",
            "1:95 `Sphere` has no field `material`, which it needs",
            "1:95 `Sphere` has no field `radius`, which it needs",
        ],
    );
    check::<Scene>(
        "(version: 1, image: (1, 1), objects: [])",
        &["1:1 `Scene` has no field `camera`, which it needs"],
    );
}

#[test]
fn a_field_given_twice_is_reported_once() {
    check_fields("objects: [], objects: [3]", &["1:56 the field `objects` is given twice"]);
}

#[test]
fn unknown_variants_come_with_the_nearest_known_one() {
    check_fields(
        "objects: [Sphre(center: (0,0,0), radius: 1, material: \"red\")]",
        &["1:53 unknown variant `Sphre`; expected one of `Sphere`, `Box`, `Group`, `Moved` | \
           did you mean `Sphere`?"],
    );
    check_fields(
        "objects: [Cone(height: x), Cylinder, Sphere(center: (0,0,0), radius: x, material: \"red\")]",
        &[
            "1:53 unknown variant `Cone`; expected one of `Sphere`, `Box`, `Group`, `Moved`",
            "1:70 unknown variant `Cylinder`; expected one of `Sphere`, `Box`, `Group`, `Moved`",
            "1:112 expected a number, found `x`",
        ],
    );
    check_fields(
        "objects: [\"Sphere\", 3]",
        &[
            "1:53 expected one of `Sphere`, `Box`, `Group`, `Moved`, found the text `\"Sphere\"` | \
             write `Sphere`, without quotes",
            "1:63 expected one of `Sphere`, `Box`, `Group`, `Moved`, found `3`",
        ],
    );
}

#[test]
fn values_of_the_wrong_kind_are_shown() {
    check::<f64>("\"big\"", &["1:1 expected a number, found the text `\"big\"`"]);
    check::<f64>("red", &["1:1 expected a number, found `red`"]);
    check::<f64>("1u8", &["1:1 expected a number, found `1u8` | write `1`, without the type"]);
    check::<f64>("1.0.0", &["1:1 expected a number, found `1.0.0`"]);
    check::<f64>("1e", &["1:1 expected a number, found `1e`"]);
    check::<bool>("yes", &["1:1 expected `true` or `false`, found `yes`"]);
    check::<char>(
        "\"a\"",
        &["1:1 expected one character in single quotes, found the text `\"a\"`"],
    );
    check::<String>("red", &["1:1 expected a text in quotes, found `red` | write `\"red\"`"]);
    check::<String>("[1, 2]", &["1:1 expected a text in quotes, found the list `[1, 2]`"]);
    check::<Vec<u8>>("{}", &["1:1 expected a list in brackets, found the map `{}`"]);
    let long = "[11111, 22222, 33333, 44444, 55555, 66666, 77777, 88888]";
    check::<f64>(
        long,
        &["1:1 expected a number, found the list `[11111, 22222, 33333, 44444, 55555, 6666…`"],
    );
}

#[test]
fn whole_numbers_have_a_range() {
    check::<u8>("300", &["1:1 expected a whole number from 0 to 255, found `300`"]);
    check::<u32>("-1", &["1:1 expected a whole number from 0 to 4294967295, found `-1`"]);
    check::<u32>("1.5", &["1:1 expected a whole number from 0 to 4294967295, found `1.5`"]);
    check::<i8>("128", &["1:1 expected a whole number from -128 to 127, found `128`"]);
    check::<u32>(
        "'a'",
        &["1:1 expected a whole number from 0 to 4294967295, found the character `'a'`"],
    );
    check::<u32>("-0", &[]);
    check::<u8>("0xfF", &[]);
}

#[test]
fn tuples_have_their_number_of_values() {
    check::<(f64, f64, f64)>("(0, 1)", &["1:1 expected 3 values in parentheses, found 2"]);
    check::<(f64, f64)>(
        "(0, a, 2)",
        &["1:1 expected 2 values in parentheses, found 3", "1:5 expected a number, found `a`"],
    );
    check::<(f64, f64)>("()", &["1:1 expected 2 values in parentheses, found 0"]);
    check::<(f64, f64)>(
        "(x: 1, y: 2)",
        &["1:1 expected 2 values in parentheses, found `(x: 1, y: 2)`"],
    );
    check::<[f64; 2]>(
        "[0, a]",
        &[
            "1:1 expected 2 values in parentheses, found the list `[0, a]` | \
         write `(...)` in place of `[...]`",
            "1:5 expected a number, found `a`",
        ],
    );
}

#[test]
fn brackets_of_another_kind_are_read_all_the_same() {
    check::<Vec<u8>>(
        "(1, 300)",
        &[
            "1:1 expected a list in brackets, found `(1, 300)` | lists are written `[...]`",
            "1:5 expected a whole number from 0 to 255, found `300`",
        ],
    );
    check_fields(
        "objects: [], sky: Some((1, 2, x))",
        &[
            "1:66 `(1, 2, x)` needs no brackets of its own in `Some(...)` | write `Some(1, 2, x)`",
            "1:73 expected a number, found `x`",
        ],
    );
    check_fields(
        "objects: [], materials: {a: Black, \"b\": Tint((1, 2, 3))}",
        &[
            "1:68 expected a text in quotes, found `a` | write `\"a\"`",
            "1:88 `(1, 2, 3)` needs no brackets of its own in `Tint(...)` | write `Tint(1, 2, 3)`",
        ],
    );
    check_fields(
        "objects: [], lights: {\"position\": (0, 0)}",
        &[
            "1:64 expected a list in brackets, found the map `{\"position\": (0, 0)}`",
            "1:86 the field `lights` is given twice",
        ],
    );
}

#[test]
fn variants_hold_what_they_hold() {
    check_fields(
        "objects: [], materials: {\"a\": Black(), \"b\": Dielectric, \"c\": Dielectric(1, 2), \
         \"e\": Named(), \"f\": Mix(\"a\"), \"g\": Lambert, \"h\": Named(x: 1)}",
        &[
            "1:78 `Black` takes no values | leave out the parentheses",
            "1:87 `Dielectric` needs a value: `Dielectric(...)`",
            "1:104 expected a number in `Dielectric(...)`, found 2 values",
            "1:127 expected a text in quotes in `Named(...)`, found nothing",
            "1:141 expected 3 values in parentheses, found 1",
            "1:156 `Lambert` needs fields: `Lambert(...)`",
            "1:170 expected a text in quotes in `Named(...)`, found fields",
        ],
    );
}

#[test]
fn names_of_structs_are_checked() {
    check::<Scene>(
        "Scen(version: 1, image: (1, 1), camera: Flat, objects: [], sky: Color(1, 2, 3))",
        &[
            "1:1 expected the name `Scene`, found `Scen`",
            "1:65 expected values in parentheses, found `Color`",
        ],
    );
    check_fields(
        "objects: [], materials: {\"a\": Tint(Color(1, 2, 3))}",
        &["1:78 `Color(1, 2, 3)` needs no brackets of its own in `Tint(...)`"],
    );
}

#[test]
fn what_a_type_refuses_is_told_in_its_words() {
    check::<Gain>("-2", &["1:1 a gain is above 0, not -2"]);
    check::<Vec<Gain>>(
        "[-2, 1, x, 0]",
        &[
            "1:2 a gain is above 0, not -2",
            "1:9 expected a number, found `x`",
            "1:12 a gain is above 0, not 0",
        ],
    );
}

#[test]
fn the_number_of_runs_is_bounded() {
    let found = problems::<Vec<Gain>>(&format!("[{}]", "-1,".repeat(200)));
    assert_eq!(found.len(), 65);
    assert_eq!(found[64], "1:603 further problems are not listed");
}
