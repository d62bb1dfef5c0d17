//! `ron` and the tolerant reader must agree on which texts are good.

use fastrand::Rng;

use super::super::{examine, ron_options};
use super::schema::{Color, Lens, Object, Scene};
use super::{GOOD, ODD, objects};
use serde::de::DeserializeOwned;

/// How many mutated texts each run of the tests tries.
const MUTATIONS: usize = 3_000;

/// Pieces that mistakes are made of.
const PIECES: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "'",
    "#",
    "-",
    "+",
    ".",
    "..",
    "_",
    "r#\"",
    "b\"",
    "\\",
    "/*",
    "*/",
    "//",
    "\n",
    " ",
    "\u{FEFF}",
    "\u{A0}",
    "é",
    "²",
    "Some",
    "Some(",
    "None",
    "inf",
    "-inf",
    "NaN",
    "1",
    "1.5",
    "-1",
    "300",
    "0x1F",
    "1u8",
    "2f64",
    "true",
    "()",
    "Sphere",
    "Black",
    "Scene",
    "radius: 1",
    "r#radius",
    "1e5",
    "1_0",
    "_1",
    "=",
    ";",
    "'a'",
    "b'a'",
    "\u{85}",
];

/// A text with a few mistakes.
fn mutate(rng: &mut Rng, text: &str) -> String {
    let mut text = text.to_owned();
    for _ in 0..rng.usize(1..4) {
        let a = text.floor_char_boundary(rng.usize(..=text.len()));
        let b = text.floor_char_boundary(rng.usize(..=text.len()));
        let short = text.floor_char_boundary((a + rng.usize(1..12)).min(text.len()));
        let piece = PIECES[rng.usize(..PIECES.len())];
        match rng.u8(..8) {
            0 => text.replace_range(a..short, ""),
            1 | 2 => text.insert_str(a, piece),
            3 => text.replace_range(a..short, piece),
            4 => {
                let copy = text[a..short].to_owned();
                text.insert_str(b, &copy);
            }
            5 => text = swap_tokens(rng, &text),
            6 => text = drop_token(rng, &text),
            _ if rng.u8(..8) == 0 => text.truncate(a),
            _ => text = drop_token(rng, &text),
        }
    }
    text
}

/// The text cut between words and signs.
fn cut(text: &str) -> Vec<&str> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        let len = if word == 0 { c.len_utf8() } else { word };
        let (token, after) = rest.split_at(len);
        out.push(token);
        rest = after;
    }
    out
}

fn swap_tokens(rng: &mut Rng, text: &str) -> String {
    let mut tokens = cut(text);
    if let Some(last) = tokens.len().checked_sub(1) {
        tokens.swap(rng.usize(..=last), rng.usize(..=last));
    }
    tokens.concat()
}

fn drop_token(rng: &mut Rng, text: &str) -> String {
    let mut tokens = cut(text);
    if !tokens.is_empty() {
        tokens.remove(rng.usize(..tokens.len()));
    }
    tokens.concat()
}

/// What is wrong with what is said of a text, if `ron` does not agree.
fn disagreement<T: DeserializeOwned>(text: &str) -> Option<String> {
    let ron = ron_options().from_str::<T>(text);
    let own = examine::<T>(text);
    match (ron, own.problems.first()) {
        (Ok(_), Some(problem)) => Some(format!("ron accepts, but: {problem:?}")),
        (Ok(_), None) if own.value.is_none() => Some("ron accepts, but no value".to_owned()),
        (Err(error), None) => Some(format!("nothing found, but ron says: {error}")),
        _ => None,
    }
}

#[test]
fn ron_and_diagnose_agree_on_mutated_files() {
    let mut rng = Rng::with_seed(7);
    let lines: Vec<&str> = GOOD.lines().collect();
    let flat =
        GOOD.replace("// A comment, with \"quotes\" and (brackets.\n", "").replace('\n', " ");
    let mut disagreements = Vec::new();
    let mut accepted = 0;
    for _ in 0..MUTATIONS {
        let good = match rng.u8(..4) {
            0 => flat.clone(),
            2 => ODD.to_owned(),
            1 => lines.join("\r\n"),
            _ => GOOD.to_owned(),
        };
        let text = mutate(&mut rng, &good);
        accepted += usize::from(ron_options().from_str::<Scene>(&text).is_ok());
        if let Some(disagreement) = disagreement::<Scene>(&text) {
            disagreements.push(format!("{disagreement}\n{text}"));
        }
    }
    let shown =
        disagreements.iter().take(5).map(String::as_str).collect::<Vec<_>>().join("\n----\n");
    assert!(accepted > MUTATIONS / 50, "{accepted} accepted texts say little");
    assert!(disagreements.is_empty(), "{} disagreements:\n{shown}", disagreements.len());
}

#[test]
fn every_beginning_of_a_file_is_read() {
    for text in [GOOD, ODD] {
        for (end, _) in text.char_indices() {
            assert_eq!(disagreement::<Scene>(&text[..end]), None, "cut at {end}");
        }
    }
}

/// Whether `ron` accepts `text` must be as expected, and `diagnose` must agree.
#[track_caller]
fn check<T: DeserializeOwned>(text: &str, accepted: bool) {
    assert_eq!(ron_options().from_str::<T>(text).is_ok(), accepted, "{text}");
    assert_eq!(disagreement::<T>(text), None, "{text}");
}

#[test]
fn the_ways_of_ron_are_followed() {
    for good in ["Some-1", "Some 1", "Some(1,)", "None", "1", "Some/**/(1)", "Some.5"] {
        check::<Option<f64>>(good, true);
    }
    for bad in ["Some", "Some()", "None()", "r#None", "Some(1,,)", "Some(Some(1))", "(1)"] {
        check::<Option<f64>>(bad, false);
    }
    for good in ["+1", "-.5", "1.", "1_0.", "inf", "-NaN", "inff64", "1e400", "0x1"] {
        check::<f64>(good, good != "0x1");
    }
    for bad in ["1__.", "_1", "1._5", "+", ".", "1f32", "--1", "r#inf", "infinity", "1\u{0}"] {
        check::<f64>(bad, bad == "1__.");
    }
    for good in ["-0", "0b1_", "0o17", "1u32", "+7"] {
        check::<u32>(good, true);
    }
    for bad in ["0x_1", "1u8", "0b2", "0x", "1_000_000_000_000", "b'a'", "1.0", "1e1", "- 1"] {
        check::<u32>(bad, false);
    }
    check::<Color>("Color(1, 2, 3)", true);
    check::<Color>("Color (1, 2, 3)", false);
    check::<Color>("r#Color(1, 2, 3,)", true);
    check::<Lens>("Lens (radius: 1,)", true);
    check::<Lens>("#![enable(explicit_struct_names)] (radius: 1)", false);
    check::<Lens>("(\"radius\": 1)", false);
    check::<Option<(f64, f64)>>("Some(1, 2,,)", true);
    check::<Option<(f64, f64)>>("Some((1, 2))", false);
    check::<()>("( )", false);
}

#[test]
fn ron_counts_levels_alike() {
    for depth in 0..40 {
        let groups = format!("{}{}", "Group(objects: [".repeat(depth), "])".repeat(depth));
        check::<Scene>(&objects(&format!("objects: [{groups}]")), depth <= 25);
        let unit = "Group(objects: [])";
        let moved = format!("{}{unit}{}", "Moved(".repeat(depth), ", (0,0,0))".repeat(depth));
        let accepted = ron_options().from_str::<Object>(&moved).is_ok();
        check::<Object>(&moved, accepted);
    }
}
