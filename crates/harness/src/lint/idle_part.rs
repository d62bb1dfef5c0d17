//! `idle-part`: every object and light of a fixture is tested, so that the
//! fixture fails without it; and one that is said to be idle is.

use rayon::prelude::*;

use super::{Around, Finding, Part, Rule, finding, parts, without};
use crate::case::Case;
use crate::judge::{broken_expectations, is_caught};

pub(super) const RULE: Rule = Rule {
    name: "idle-part",
    asks: "the picture fails without any object or light, but those named in `idle`",
    find,
};

fn find(case: &Case, _: &Around<'_>) -> Vec<Finding> {
    let said = &case.fixture.check.idle;
    let parts = parts(&case.fixture.file);
    let mut found: Vec<_> = said
        .keys()
        .filter(|name| parts.iter().all(|part| part.to_string() != **name))
        .map(|name| unknown(case, name, &parts))
        .collect();
    // Without a group all that is in it is gone, and one reason will do.
    let said: Vec<_> =
        parts.iter().filter(|part| said.contains_key(&part.to_string())).cloned().collect();
    let idle: Vec<_> = parts.par_iter().map(|part| is_idle(case, part)).collect();
    let mut reported: Vec<&Part> = Vec::new();
    for (part, is_idle) in parts.iter().zip(idle) {
        let is_said = said.iter().any(|said| part.is_in(said));
        if is_idle && !is_said && !reported.iter().any(|outer| part.is_in(outer)) {
            reported.push(part);
            found.push(untested(case, part));
        }
        if !is_idle && said.contains(part) {
            found.push(not_idle(case, part));
        }
    }
    found
}

/// Whether the fixture would pass without this part. A scene that makes no sense
/// without it would not.
fn is_idle(case: &Case, part: &Part) -> bool {
    let Ok(fixture) = case.fixture.with_file(without(&case.fixture.file, part)) else {
        return false;
    };
    let Ok(picture) = fixture.render() else { return false };
    let limits = fixture.check.limits.as_ref();
    !is_caught(limits, &case.golden.picture, &picture.encoded)
        && broken_expectations(&fixture, &picture).is_empty()
}

fn untested(case: &Case, part: &Part) -> Finding {
    let message = format!("expected a fixture that fails without {part}, found that it passes");
    let help = format!(
        "take it out, put it where it is seen, or say why it is there: check: (idle: {{\"{part}\": \
         \"...\"}})"
    );
    finding(case, &RULE, &part.path(), message, help)
}

fn not_idle(case: &Case, part: &Part) -> Finding {
    let path = ["check".into(), "idle".into(), scene::Step::key(part.to_string())];
    let message = format!("expected the same picture without {part}, found another");
    finding(case, &RULE, &path, message, "mend the scene, or take it out of `idle`")
}

fn unknown(case: &Case, name: &str, parts: &[Part]) -> Finding {
    let path = ["check".into(), "idle".into(), scene::Step::key(name)];
    let names: Vec<_> = parts.iter().map(ToString::to_string).collect();
    let nearest = scene::nearest(name, names.iter().map(String::as_str));
    let hint = nearest.map_or(String::new(), |name| format!("did you mean {name}? "));
    let message = format!("expected an object or light of this scene, found \"{name}\"");
    let help =
        format!("{hint}they are counted from 0: objects[0], objects[0].objects[1], lights[0]");
    finding(case, &RULE, &path, message, help)
}
