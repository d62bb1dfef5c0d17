//! `slow`: which fixtures took long to render, and what they are made of.

use crate::fixture::{Build, Fixture, Skipping};
use crate::suite::Suite;
use crate::verdict::{Origin, Outcome};

/// From so many milliseconds on a fixture is slow: a suite of a thousand such
/// would take a quarter of an hour.
pub const SLOW_MS: f64 = 1e3;

/// At most so many are told.
const SHOWN: usize = 3;

/// A fixture that took long to render.
#[derive(Debug, Clone, PartialEq)]
pub struct Slow {
    /// Its name.
    pub name: String,
    /// How long it took, in milliseconds. Fixtures are rendered beside each
    /// other, so that it takes less alone.
    pub render_ms: f64,
    /// What most of the time goes into: the size of the picture, and the gist of
    /// what [`tracer::Plan::notes`] says of its rays.
    pub needs: String,
}

/// The slowest of those that took `over_ms` milliseconds or more to render, the
/// slowest first. Those that cannot be read any more are left out.
pub fn slowest(suite: &Suite, outcomes: &[Outcome], over_ms: f64) -> Vec<Slow> {
    let is_slow = |o: &&Outcome| o.origin != Origin::Unchanged && o.render_ms >= over_ms;
    let mut slow: Vec<_> = outcomes.iter().filter(is_slow).collect();
    // Equals stay in the order of names.
    slow.sort_by(|a, b| b.render_ms.total_cmp(&a.render_ms));
    let with_needs = |outcome: &&Outcome| {
        let (name, render_ms) = (outcome.name.clone(), outcome.render_ms);
        let path = suite.fixture_path(&name);
        let fixture = Fixture::open(&Suite::fixture_label(&name), &path, Build::default()).ok()?;
        let size = fixture.scene.size();
        let size = format!("{} x {} pixels", size.width, size.height);
        let plan = fixture.plan(Skipping::On);
        let needs: Vec<_> = std::iter::once(&*size).chain(gist(plan.notes())).collect();
        Some(Slow { name, render_ms, needs: needs.join("; ") })
    };
    slow.iter().filter_map(with_needs).take(SHOWN).collect()
}

/// Which samples there are, and what they meet, without what is skipped of it.
fn gist(notes: &[String]) -> impl Iterator<Item = &str> {
    const TOLD: [&str; 3] = ["eye rays: ", "shapes: ", "shadow rays: "];
    const DETAILS: [&str; 3] = [";", ", held", ", from"];
    let told = notes.iter().filter(|note| TOLD.iter().any(|begin| note.starts_with(begin)));
    told.map(|note| {
        let ends = DETAILS.iter().filter_map(|detail| note.find(detail));
        &note[..ends.min().unwrap_or(note.len())]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store;
    use crate::template::TEMPLATE;
    use crate::verdict::Verdict;

    #[test]
    fn the_three_slowest_are_told_with_what_they_need() {
        let folder = tempfile::tempdir().unwrap();
        let took = |name: &str, render_ms: f64| Outcome {
            render_ms,
            ..Outcome::unrendered(name, Verdict::Match)
        };
        for name in ["a", "b", "c", "d", "e"] {
            let path = folder.path().join(format!("fixtures/{name}.ron"));
            store::write(&path, TEMPLATE.as_bytes()).unwrap();
        }
        let suite = Suite::open(folder.path()).unwrap();
        let skipped = Outcome { origin: Origin::Unchanged, ..took("e", 9e9) };
        let all = [took("a", 5.0), took("b", 7.0), took("c", 7.0), took("d", 6.0), skipped];
        let told = |over_ms: f64| slowest(&suite, &all, over_ms);
        let names = |over_ms| told(over_ms).into_iter().map(|s| s.name).collect::<Vec<_>>();
        assert_eq!(names(1.0), ["b", "c", "d"]);
        assert_eq!(names(6.5), ["b", "c"]);
        assert!(names(8.0).is_empty());
        let needs = &told(1.0)[0].needs;
        let expected = "96 x 72 pixels; eye rays: 1 sample on a grid a pixel, in 84 of 108 tiles of \
                        8 x 8 pixels; shapes: 1 sphere, 1 plane; shadow rays: towards 1 light";
        assert_eq!(needs, expected);
        // One that has gone meanwhile.
        store::remove(&suite.fixture_path("b")).unwrap();
        assert_eq!(names(1.0), ["c", "d", "a"]);
    }
}
