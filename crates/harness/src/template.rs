//! `new_fixture`: a small valid fixture to start from.

use crate::store::{self, StoreError};
use crate::suite::Suite;

/// The text of a new fixture.
pub const TEMPLATE: &str = include_str!("template.ron");

/// Writes a new fixture under this name and returns its path relative to the
/// suite. A name is parts of letters, digits, `-` and `_` with `/` between.
///
/// # Errors
/// A name that is none, and a fixture that is there already.
pub fn new_fixture(suite: &Suite, name: &str) -> Result<String, StoreError> {
    check_name(name)?;
    store::write_new(&suite.fixture_path(name), TEMPLATE.as_bytes())?;
    Ok(Suite::fixture_label(name))
}

/// Whether a new fixture may have this name.
///
/// # Errors
/// It may not.
pub fn check_name(name: &str) -> Result<(), StoreError> {
    let is_plain = |part: &str| {
        !part.is_empty()
            && !part.starts_with('-')
            && part.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'))
    };
    if name.split('/').all(is_plain) {
        return Ok(());
    }
    let what = format!(
        "expected a name such as `sphere/tangent` (letters, digits, `-`, `_` and `/`), found \
         \"{name}\""
    );
    Err(StoreError { path: "fixtures".into(), what })
}

#[cfg(test)]
mod tests {
    use scene::NoAssets;
    use tracer::accel::Build;

    use super::*;
    use crate::fixture::Fixture;

    #[test]
    fn the_template_is_a_good_fixture_that_keeps_its_expectations() {
        let fixture = Fixture::read("template", TEMPLATE, &NoAssets, Build::Bvh).unwrap();
        let picture = fixture.render().unwrap();
        assert_eq!(crate::judge::broken_expectations(&fixture, &picture), [""; 0]);
        assert!(!fixture.check.expect.is_empty());
    }

    #[test]
    fn names_stay_in_the_suite_and_nothing_is_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        store::write(&folder.path().join("fixtures/a.ron"), b"mine").unwrap();
        let suite = Suite::open(folder.path()).unwrap();
        for name in ["", "/", "-x", "../x", "a/../b", "/etc/x", "a b", "a.ron", "a"] {
            assert!(new_fixture(&suite, name).is_err(), "{name}");
        }
        let kept = store::read(&suite.fixture_path("a"), 99).unwrap();
        assert_eq!(kept.as_deref(), Some(&b"mine"[..]));
        assert_eq!(new_fixture(&suite, "area/b-1").unwrap(), "fixtures/area/b-1.ron");
    }
}
