//! Many mistakes in one file, and brackets that are missing.

use super::schema::Scene;
use super::{GOOD, check, objects, problems};

/// Checks the good file with `from` replaced.
#[track_caller]
fn check_good(from: &str, to: &str, expected: &[&str]) {
    assert_eq!(GOOD.matches(from).count(), 1, "{from}");
    check::<Scene>(&GOOD.replace(from, to), expected);
}

#[track_caller]
fn check_fields(fields: &str, expected: &[&str]) {
    check::<Scene>(&objects(fields), expected);
}

#[test]
fn five_mistakes_are_five_problems() {
    let text = GOOD
        .replace("version: 1", "version: -1")
        .replace("look_at: (0, 0, 0),", "look_att: (0, 0, 0),")
        .replace("\"dark\": Black,", "\"dark\": Black")
        .replace("radius: 1.0, ", "")
        .replace("power: 12.0", "power: \"high\"");
    check::<Scene>(
        &text,
        &[
            "4:14 expected a whole number from 0 to 4294967295, found `-1`",
            "8:9 unknown field `look_att` in `Perspective` | \
         did you mean `look_at`? known here: `look_from`, `look_at`, `fov_deg`",
            "16:9 expected `,` before `\"by name\"`",
            "21:9 `Sphere` has no field `radius`, which it needs",
            "28:43 expected a number, found the text `\"high\"`",
        ],
    );
}

#[test]
fn a_bracket_that_is_never_closed_is_shown_where_it_opens() {
    check_good("look_at: (0, 0, 0),\n", "look_at: (0, 0, 0,\n", &["8:18 `(` is never closed"]);
    check_good("Some(40.0),\n    ),\n", "Some(40.0),\n", &["6:24 `(` is never closed"]);
    check_good("        ]),\n    ],", "        ]),\n", &["20:14 `[` is never closed"]);
    check_good("        ]),\n    ],", "        ),\n    ],", &["22:38 `[` is never closed"]);
    check_good("    },\n    objects", "    objects", &["11:16 `{` is never closed"]);
    check_good("2.0,\n)", "2.0,\n", &["3:6 `(` is never closed"]);
    check_good("\"dark\": Black,", "\"dark: Black,", &["15:9 `\"` is never closed"]);
    check_good("comment */ */", "comment */", &["13:35 `/*` is never closed by `*/`"]);
}

#[test]
fn brackets_on_one_line_are_told_by_what_they_hold() {
    let found = &["1:68 `(` is never closed"];
    check_fields("objects: [Sphere(center: (0,0,0, radius: 1, material: \"red\")]", found);
    let found = &["1:59 `(` is never closed"];
    check_fields(
        "objects: [Sphere(center: (0,0,0), radius: 1, material: \"red\", Group(objects: [])]",
        found,
    );
    let found = &["1:52 `[` is never closed"];
    check_fields("objects: [Sphere(center: (0,0,0), radius: 1, material: \"red\")", found);
    let found = &["1:98 `\"` is never closed"];
    check_fields("objects: [Sphere(center: (0,0,0), radius: 1, material: \"red)]", found);
    let found = &["1:80 `(` is never closed"];
    check_fields("objects: [], materials: {\"a\": Lambert(albedo: (1,1,1), \"b\": Black}", found);
}

#[test]
fn a_bracket_too_many_closes_nothing() {
    check_good("        ]),\n    ],", "        ])),\n    ],", &["26:11 `)` closes nothing"]);
    check_good("2.0,\n)", "2.0,\n))", &["31:2 `)` closes nothing"]);
    let found = &["1:75 `)` closes nothing"];
    check_fields("objects: [Sphere(center: (0,0,0)), radius: 1, material: \"red\")]", found);
    let found = &["1:103 `]` closes nothing"];
    check_fields("objects: [Sphere(center: (0,0,0), radius: 1, material: \"red\"])]", found);
}

#[test]
fn a_bracket_of_the_wrong_kind_closes_all_the_same() {
    let found = &["1:74 expected `)`, found `]` | the innermost open bracket is `(`"];
    check_fields("objects: [Sphere(center: (0,0,0], radius: 1, material: \"red\")]", found);
}

#[test]
fn a_file_cut_off_is_one_problem() {
    for (end, _) in GOOD.char_indices().skip(60) {
        let found = problems::<Scene>(&GOOD[..end]);
        let closed = found.iter().filter(|problem| problem.contains("never closed")).count();
        assert!(closed <= 1 && found.len() <= 2, "cut at {end}: {found:#?}");
    }
}
