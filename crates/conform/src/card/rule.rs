//! The rule by which a feature passes or fails: what fixtures that pass show to
//! be right is not blamed for those that fail.
//!
//! A picture is wrong as a whole; it does not say which of the things in it is to
//! blame. A feature is *cleared* if some passing fixture has it. The *suspects* of
//! a failing fixture are those of its features that are not cleared. Where none is
//! left, each of them is right somewhere, and what is wrong is a case of one or a
//! combination: the *suspect pairs* are the pairs of its features that no passing
//! fixture has together.

use std::collections::{BTreeMap, BTreeSet};

use interchange::Feature;

use crate::{Outcome, Run, outcome};

/// What a failing fixture may be put down to.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Suspicion {
    /// Its features that no passing fixture has.
    pub features: BTreeSet<Feature>,
    /// Where there are none: its pairs of features that no passing fixture has
    /// together.
    pub pairs: Vec<(Feature, Feature)>,
}

/// What a run says of a feature, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// Some fixture fails and nothing else in it is a suspect.
    Fails,
    /// No fixture that has it passes, and where one fails there are other
    /// suspects.
    Suspect,
    /// Some pass and some fail, and a failure has no suspect: it may be a case of
    /// this feature.
    Mixed,
    /// Some pass; each that fails has a suspect among its other features.
    Cleared,
    /// All that were rendered pass, and some were.
    Passes,
    /// None was asked for: the adapter or its dialect does not have it, or not
    /// what comes with it.
    Unsupported,
    /// No fixture of the run has it.
    NotAsked,
}

impl Standing {
    /// All of them, the worst first.
    pub const ALL: [Self; 7] = [
        Self::Fails,
        Self::Suspect,
        Self::Mixed,
        Self::Cleared,
        Self::Passes,
        Self::Unsupported,
        Self::NotAsked,
    ];

    /// Its name in JSON.
    pub fn id(self) -> &'static str {
        match self {
            Self::Fails => "fails",
            Self::Suspect => "suspect",
            Self::Mixed => "mixed",
            Self::Cleared => "cleared",
            Self::Passes => "passes",
            Self::Unsupported => "unsupported",
            Self::NotAsked => "not_asked",
        }
    }

    /// Its name for people.
    pub fn words(self) -> &'static str {
        match self {
            Self::NotAsked => "not asked",
            other => other.id(),
        }
    }

    /// What it means, as a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Fails => "A fixture fails, and every other feature in it passes elsewhere.",
            Self::Suspect => {
                "Every fixture with it that was rendered fails, but each has other suspects."
            }
            Self::Mixed => {
                "It passes in some fixtures; another fails whose features all pass elsewhere."
            }
            Self::Cleared => {
                "It passes in some fixtures; each that fails has a suspect among other features."
            }
            Self::Passes => "Every fixture with it that was rendered passes.",
            Self::Unsupported => {
                "No fixture with it was rendered: the adapter or its language does not have it, or \
                 not what else each of them asks for."
            }
            Self::NotAsked => "No fixture of this run has it.",
        }
    }
}

/// A run, read by the rule.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Reading {
    /// Features that a passing fixture has.
    pub cleared: BTreeSet<Feature>,
    /// Each failing fixture with what it may be put down to.
    pub suspicions: BTreeMap<String, Suspicion>,
}

impl Reading {
    /// Reads a run.
    pub fn of(run: &Run) -> Self {
        let passing: Vec<_> =
            run.fixtures.values().filter(|f| f.outcome == Outcome::Pass).collect();
        let cleared: BTreeSet<_> = passing.iter().flat_map(|f| &f.features).copied().collect();
        let failing = run.fixtures.iter().filter(|(_, f)| outcome::is_failure(f.outcome));
        let suspicion = |features: &BTreeSet<Feature>| {
            let features_left: BTreeSet<_> = features.difference(&cleared).copied().collect();
            let is_clean = |a: Feature, b: Feature| {
                passing.iter().any(|f| f.features.contains(&a) && f.features.contains(&b))
            };
            let mut pairs = Vec::new();
            if features_left.is_empty() {
                for (i, &a) in features.iter().enumerate() {
                    let others = features.iter().skip(i + 1);
                    pairs.extend(others.filter(|&&b| !is_clean(a, b)).map(|&b| (a, b)));
                }
            }
            Suspicion { features: features_left, pairs }
        };
        let suspicions = failing.map(|(name, f)| (name.clone(), suspicion(&f.features))).collect();
        Self { cleared, suspicions }
    }

    /// What the run says of a feature.
    pub fn standing(&self, run: &Run, feature: Feature) -> Standing {
        let having = || run.fixtures.iter().filter(|(_, f)| f.features.contains(&feature));
        if having().next().is_none() {
            return Standing::NotAsked;
        }
        let suspects = |name: &str| self.suspicions.get(name).map(|s| &s.features);
        let failing = || having().filter_map(|(name, _)| suspects(name));
        if !self.cleared.contains(&feature) {
            // It is itself a suspect of each.
            return match failing().map(BTreeSet::len).min() {
                None => Standing::Unsupported,
                Some(1) => Standing::Fails,
                Some(_) => Standing::Suspect,
            };
        }
        match failing().map(BTreeSet::is_empty).max() {
            None => Standing::Passes,
            Some(true) => Standing::Mixed,
            Some(false) => Standing::Cleared,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trial::{result, run};
    use Feature::{BlinnPhong, Box, Lambert, Shadows, Sphere, Torus};
    use Outcome::{Crashed, Fail, Pass, TimedOut, Unsupported};

    fn read(fixtures: &[(Outcome, &[Feature])]) -> (Run, Reading) {
        let mut made = run("r");
        for (i, (outcome, features)) in fixtures.iter().enumerate() {
            let result = result(*outcome, 0.0);
            let features = features.iter().copied().collect();
            made.fixtures.insert(i.to_string(), crate::FixtureResult { features, ..result });
        }
        let reading = Reading::of(&made);
        (made, reading)
    }

    #[track_caller]
    fn check(fixtures: &[(Outcome, &[Feature])], expected: &[(Feature, Standing)]) {
        let (run, reading) = read(fixtures);
        for &(feature, standing) in expected {
            assert_eq!(reading.standing(&run, feature), standing, "{feature} of {fixtures:?}");
        }
    }

    #[test]
    fn the_innocent_are_not_blamed() {
        use Standing::{Cleared, Fails, Mixed, NotAsked, Passes, Suspect};
        check(&[], &[(Sphere, NotAsked)]);
        check(&[(Pass, &[Sphere])], &[(Sphere, Passes), (Box, NotAsked)]);
        check(&[(Fail, &[Sphere])], &[(Sphere, Fails)]);
        // Two that only fail together: neither is shown to be wrong.
        check(&[(Fail, &[Sphere, Shadows])], &[(Sphere, Suspect), (Shadows, Suspect)]);
        // One of them is right elsewhere, so it is the other.
        check(
            &[(Fail, &[Sphere, Shadows]), (Pass, &[Sphere])],
            &[(Sphere, Cleared), (Shadows, Fails)],
        );
        // Each is right elsewhere: the combination, or a case.
        check(
            &[(Fail, &[Sphere, Shadows]), (Pass, &[Sphere]), (Pass, &[Shadows, Box])],
            &[(Sphere, Mixed), (Shadows, Mixed), (Box, Passes)],
        );
        // Beside a failure with a suspect, one without.
        check(
            &[(Fail, &[Sphere, Torus]), (Fail, &[Sphere]), (Pass, &[Sphere])],
            &[(Sphere, Mixed), (Torus, Fails)],
        );
        // Alone in one failure, among others in another.
        check(
            &[(Fail, &[Sphere, Torus]), (Fail, &[Sphere, Torus, Box]), (Pass, &[Sphere])],
            &[(Torus, Fails), (Box, Suspect)],
        );
    }

    #[test]
    fn what_was_not_rendered_proves_nothing() {
        use Standing::{Fails, Passes};
        check(&[(Unsupported, &[Torus])], &[(Torus, Standing::Unsupported)]);
        check(&[(Unsupported, &[Torus]), (Pass, &[Torus])], &[(Torus, Passes)]);
        // Not to give a picture is to fail.
        check(&[(Crashed, &[Torus])], &[(Torus, Fails)]);
        check(&[(TimedOut, &[Torus]), (Unsupported, &[Torus])], &[(Torus, Fails)]);
    }

    #[test]
    fn where_no_feature_is_left_pairs_are_suspects() {
        let all = [
            (Fail, &[Sphere, Lambert, Shadows][..]),
            (Pass, &[Sphere, Lambert]),
            (Pass, &[Shadows, Lambert]),
        ];
        let (_, reading) = read(&all);
        let expected = Suspicion { features: BTreeSet::new(), pairs: vec![(Sphere, Shadows)] };
        assert_eq!(reading.suspicions["0"], expected);
        // Nothing but the very scene is left.
        let (_, reading) = read(&[(Fail, &[Sphere]), (Pass, &[Sphere, Lambert])]);
        assert_eq!(reading.suspicions["0"], Suspicion::default());
        // No pairs where a feature is a suspect.
        let (_, reading) = read(&[(Fail, &[Sphere, BlinnPhong]), (Pass, &[Sphere])]);
        assert_eq!(reading.suspicions["0"].features, [BlinnPhong].into());
        assert_eq!(reading.suspicions["0"].pairs, []);
    }

    #[test]
    fn each_standing_has_its_own_name() {
        let ids: BTreeSet<_> = Standing::ALL.iter().map(|standing| standing.id()).collect();
        assert_eq!(ids.len(), Standing::ALL.len());
        assert!(Standing::ALL.is_sorted());
    }
}
