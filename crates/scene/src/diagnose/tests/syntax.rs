//! Mistakes of writing: commas, colons, quotes, characters.

use super::schema::Scene;
use super::{check, objects};

#[track_caller]
fn check_fields(fields: &str, expected: &[&str]) {
    check::<Scene>(&objects(fields), expected);
}

#[test]
fn empty_texts() {
    check::<f64>("", &["1:1 the file is empty: expected a value"]);
    check::<f64>(" // nothing\n", &["2:1 the file is empty: expected a value"]);
    check::<f64>("/* nothing", &["1:1 `/*` is never closed by `*/`"]);
}

#[test]
fn commas() {
    check::<Vec<u8>>("[1 2, 3]", &["1:4 expected `,` before `2`"]);
    check::<Vec<u8>>("[1,, 2]", &["1:4 expected a value before `,`"]);
    check::<Vec<u8>>("[,1]", &["1:2 expected a value before `,`"]);
    check::<Vec<u8>>("[1; 2]", &["1:3 unexpected `;` | values are separated by `,`"]);
    check::<(u8, u8)>("(1 2)", &["1:4 expected `,` before `2`"]);
    check_fields(
        "objects: [Sphere(center: (0,0,0) radius: 1 material: \"red\")]",
        &["1:76 expected `,` before `radius`", "1:86 expected `,` before `material`"],
    );
}

#[test]
fn a_second_comma_at_the_end_is_good_only_where_ron_takes_it() {
    check_fields("objects: [], sky: Some(1, 2, 3,,)", &[]);
    check_fields("objects: [], sky: Some(1, 2, 3,,,)", &["1:74 expected a value before `,`"]);
    check_fields("objects: [], sky: (1, 2, 3,,)", &["1:70 expected a value before `,`"]);
    check_fields(
        "objects: [], sky: Some(1, 2,,)",
        &["1:61 expected 3 values in parentheses, found 2"],
    );
    check_fields("objects: [], sky: Some(1, 2, 3,;)", &["1:74 unexpected `;`"]);
    check::<Option<super::schema::Lens>>(
        "Some(radius: 1,,)",
        &["1:16 expected a value before `,`"],
    );
}

#[test]
fn colons() {
    let found = &["1:77 expected `:` after `radius`"];
    check_fields("objects: [Sphere(center: (0,0,0), radius 1, material: \"red\")]", found);
    let found = &["1:60 expected `:` after `center`"];
    check_fields("objects: [Sphere(center (0,0,0), radius: 1, material: \"red\")]", found);
    let found = &["1:84 unexpected `=` | a value follows its name after `:`"];
    check_fields("objects: [Sphere(center: (0,0,0), radius = 1, material: \"red\")]", found);
    check_fields("objects: [], materials: {\"a\" Black}", &["1:68 expected `:` after `\"a\"`"]);
    check_fields(
        "objects: [], materials: {\"a\": , \"b\"}",
        &["1:68 expected a value after `\"a\":`", "1:75 expected `:` and a value after `\"b\"`"],
    );
    let found = &["1:77 expected a value after `radius:`"];
    check_fields("objects: [Sphere(center: (0,0,0), radius: , material: \"red\")]", found);
    let found = &["1:77 expected `:` and a value after `radius`"];
    check_fields("objects: [Sphere(center: (0,0,0), radius, material: \"red\")]", found);
}

#[test]
fn values_and_fields_do_not_mix() {
    let found = &["1:77 expected the name of a field before `1.0`"];
    check_fields("objects: [Sphere(center: (0,0,0), 1.0, material: \"red\")]", found);
    let found = &["1:75 unexpected name `z` among values"];
    check_fields("objects: [Sphere(center: (0, 0, z: 0), radius: 1, material: \"red\")]", found);
    check_fields(
        "objects: [], \"sky\": (0, 0, 0)",
        &["1:56 expected the name of a field, found the text `\"sky\"` | \
           names have no quotes: `sky: ...`"],
    );
}

#[test]
fn texts_and_characters() {
    check::<String>("\"a\\qb\"", &["1:2 `\"a\\qb\"` has an escape that is not known"]);
    check::<String>("\"a", &["1:1 `\"` is never closed"]);
    check::<String>("'abc'", &["1:1 `'abc'` is not one character | texts are written in `\"`"]);
    check::<String>("r#\"a\"", &["1:1 `r#\"` is never closed by `\"#`"]);
    check::<String>("\"a\nb\"", &[]);
    check::<char>("'''", &[]);
    check::<char>("'\\u{1F600}'", &[]);
}

#[test]
fn stray_characters() {
    check::<u8>("\u{FEFF}1", &["1:1 the file begins with a byte order mark"]);
    check::<Vec<u8>>("[1, \u{A0}2]", &["1:5 unexpected character `\\u{a0}`"]);
    check::<Vec<u8>>("[1 @, 2]", &["1:4 unexpected `@`"]);
    check::<Vec<u8>>("[@, 2]", &["1:2 unexpected `@`"]);
    check::<u8>("#![enable(nonsense)] 1", &["1:1 unknown attribute `#![enable(nonsense)]`"]);
    check::<Vec<String>>("[a-b]", &["1:2 `a-b` is neither a name nor a number"]);
    check::<u8>("1 2 3", &["1:3 unexpected `2` after the end of the value"]);
}

#[test]
fn structs_in_the_manner_of_rust() {
    check_fields(
        "objects: [Sphere { center: (0,0,0), radius: 1, material: \"red\" }]",
        &["1:60 expected `(` after `Sphere`, found `{`"],
    );
}

#[test]
fn deep_nesting_is_one_problem() {
    let deep = 100_000;
    for (open, close) in [("(", ")"), ("[", "]"), ("{", "}"), ("Some(", ")"), ("Some ", "")] {
        let text = format!("{}1{}", open.repeat(deep), close.repeat(deep));
        let tree = super::super::Tree::read(&text);
        let deep = tree.1.iter().filter(|problem| problem.message.contains("nested more than 128"));
        assert_eq!(deep.count(), 1, "{open}");
    }
    let groups = |depth: usize| {
        let inner = format!("{}{}", "Group(objects: [".repeat(depth), "])".repeat(depth));
        objects(&format!("objects: [{inner}]"))
    };
    check::<Scene>(&groups(20), &[]);
    check::<Scene>(&groups(40), &["1:453 values are nested too deeply here"]);
}
