//! `Plan`: a rubric that makes sense for a suite, or all that does not.

use std::collections::{BTreeMap, BTreeSet};

use harness::called::command;
use harness::filter::{FilterError, select};
use interchange::Feature;
use scene::{Problem, Span, Step};

use super::points::Points;
use super::rubric::{Part, Penalty, Rubric, VERSION};

/// The largest rubric that is read, in bytes: 1 MiB.
pub const MAX_BYTES: usize = 1 << 20;

/// A rubric with the fixtures that it is about.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What was written.
    pub rubric: Rubric,
    /// What each part is worth, with its fixtures.
    pub parts: Vec<Asked>,
    /// What each penalty takes, with its fixtures.
    pub penalties: Vec<Asked>,
    /// Fixtures of the suite that no part asks for.
    pub unasked: Vec<String>,
    /// Fixtures that several parts ask for.
    pub shared: Vec<String>,
    /// What each fixture of the suite asks for.
    pub features: BTreeMap<String, BTreeSet<Feature>>,
}

/// Points with fixtures.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Asked {
    /// How many points.
    pub points: Points,
    /// At most so many; for penalties.
    pub at_most: Option<Points>,
    /// The names of the fixtures.
    pub fixtures: BTreeSet<String>,
}

impl Plan {
    /// The plan of a rubric for the fixtures of a suite, each with what it asks for.
    ///
    /// # Errors
    /// Everything that is wrong with its form, or else with its meaning.
    pub fn read(
        text: &str,
        fixtures: &BTreeMap<String, BTreeSet<Feature>>,
    ) -> Result<Self, Vec<Problem>> {
        if text.len() > MAX_BYTES {
            return Err(vec![Problem {
                span: Span { start: 0, end: 0 },
                message: format!(
                    "expected a rubric of at most {MAX_BYTES} bytes, found {}",
                    text.len()
                ),
                help: None,
            }]);
        }
        let rubric: Rubric = scene::read(text)?;
        let mut judge = Judge { text, fixtures, problems: Vec::new() };
        let plan = judge.plan(rubric);
        judge.problems.sort_by_key(|problem| problem.span);
        if judge.problems.is_empty() { Ok(plan) } else { Err(judge.problems) }
    }

    /// Every fixture that is asked for.
    pub fn asked(&self) -> BTreeSet<&String> {
        self.parts.iter().chain(&self.penalties).flat_map(|asked| &asked.fixtures).collect()
    }
}

/// What a part of a rubric is called in its paths.
type Path = (&'static str, usize);

struct Judge<'a> {
    text: &'a str,
    fixtures: &'a BTreeMap<String, BTreeSet<Feature>>,
    problems: Vec<Problem>,
}

impl Judge<'_> {
    fn report(&mut self, path: &[Step], message: String, help: Option<String>) {
        let span = scene::span_of(self.text, path);
        self.problems.push(Problem { span, message, help });
    }

    fn plan(&mut self, rubric: Rubric) -> Plan {
        if rubric.version != VERSION {
            let message = format!("expected version {VERSION}, found {}", rubric.version);
            self.report(&["version".into()], message, None);
        }
        if rubric.title.trim().is_empty() {
            self.report(&["title".into()], "expected a title, found an empty text".into(), None);
        }
        if rubric.parts.is_empty() {
            self.report(&["parts".into()], "expected at least one part, found none".into(), None);
        }
        if !rubric.parts.is_empty() && rubric.parts.iter().all(|part| part.points == 0.0) {
            let message = "expected a part that gives points, found none".to_owned();
            self.report(&["parts".into()], message, None);
        }
        self.names("parts", rubric.parts.iter().map(|part| part.name.as_str()));
        self.names("penalties", rubric.penalties.iter().map(|penalty| penalty.name.as_str()));
        let parts: Vec<_> = rubric
            .parts
            .iter()
            .enumerate()
            .map(|(i, part)| self.part(("parts", i), part))
            .collect();
        let mut counts: BTreeMap<&String, u32> = BTreeMap::new();
        for name in parts.iter().flat_map(|asked| &asked.fixtures) {
            *counts.entry(name).or_default() += 1;
        }
        let is_unasked = |name: &&String| !counts.contains_key(*name);
        let unasked = self.fixtures.keys().filter(is_unasked).cloned().collect();
        let shared =
            counts.iter().filter(|(_, n)| **n > 1).map(|(&name, _)| name.clone()).collect();
        let all: BTreeSet<_> = counts.into_keys().cloned().collect();
        let penalty = |(i, penalty)| self.penalty(("penalties", i), penalty, &all);
        let penalties = rubric.penalties.iter().enumerate().map(penalty).collect();
        let features = self.fixtures.clone();
        Plan { rubric, parts, penalties, unasked, shared, features }
    }

    /// Names are there, and no two are the same.
    fn names<'n>(&mut self, list: &'static str, names: impl Iterator<Item = &'n str>) {
        let mut seen = BTreeSet::new();
        for (i, name) in names.enumerate() {
            let path = [list.into(), i.into(), "name".into()];
            if name.trim().is_empty() {
                self.report(&path, "expected a name, found an empty text".into(), None);
            } else if !seen.insert(name) {
                let message = format!("expected another name, found \"{name}\" a second time");
                self.report(&path, message, None);
            }
        }
    }

    fn points(&mut self, (list, i): Path, field: &'static str, points: f64) -> Points {
        Points::new(points).unwrap_or_else(|| {
            let message = format!(
                "expected points from 0 to {} with two decimals at most, found {points}",
                Points::MOST
            );
            self.report(&[list.into(), i.into(), field.into()], message, None);
            Points::default()
        })
    }

    fn part(&mut self, path: Path, part: &Part) -> Asked {
        let points = self.points(path, "points", part.points);
        let (list, i) = path;
        if part.fixtures.is_empty() && part.features.is_empty() {
            let message = "expected `fixtures` or `features`, found neither".to_owned();
            let help = "`fixtures: [\"*\"]` asks for all".to_owned();
            self.report(&[list.into(), i.into()], message, Some(help));
        }
        let problems = self.problems.len();
        let selected = if part.fixtures.is_empty() {
            self.fixtures.keys().cloned().collect()
        } else {
            self.select(path, &part.fixtures)
        };
        let wanted = |name: &String| {
            let has = self.fixtures.get(name);
            part.features.is_empty()
                || has.is_some_and(|has| part.features.iter().any(|feature| has.contains(feature)))
        };
        let fixtures: BTreeSet<_> = selected.into_iter().filter(wanted).collect();
        if fixtures.is_empty() && !part.features.is_empty() && self.problems.len() == problems {
            let names: Vec<_> = part.features.iter().map(|feature| feature.name()).collect();
            let of = if part.fixtures.is_empty() { "" } else { " of those in `fixtures`" };
            let message =
                format!("expected a fixture{of} that asks for {}, found none", names.join(" or "));
            self.report(&[list.into(), i.into(), "features".into()], message, None);
        }
        Asked { points, at_most: None, fixtures }
    }

    fn penalty(&mut self, path: Path, penalty: &Penalty, all: &BTreeSet<String>) -> Asked {
        let points = self.points(path, "points", penalty.points);
        let at_most = penalty.at_most.map(|most| self.points(path, "at_most", most));
        if penalty.outcomes.is_empty() {
            let (list, i) = path;
            let message = "expected at least one outcome, found none".to_owned();
            self.report(&[list.into(), i.into(), "outcomes".into()], message, None);
        }
        let fixtures = if penalty.fixtures.is_empty() {
            all.clone()
        } else {
            self.select(path, &penalty.fixtures)
        };
        Asked { points, at_most, fixtures }
    }

    /// What the filters select, each with its own problem.
    fn select(&mut self, (list, i): Path, filters: &[String]) -> BTreeSet<String> {
        let names: BTreeSet<_> = self.fixtures.keys().cloned().collect();
        let mut selected = BTreeSet::new();
        for (number, filter) in filters.iter().enumerate() {
            match select(&names, &[filter], &format!("{} list", command())) {
                Ok(found) => selected.extend(found),
                Err(why) => {
                    let path = [list.into(), i.into(), "fixtures".into(), number.into()];
                    let message = match why {
                        FilterError::Empty => {
                            "expected a filter, found an empty text; `*` selects all".to_owned()
                        }
                        why @ FilterError::SelectsNothing { .. } => why.to_string(),
                    };
                    self.report(&path, message, None);
                }
            }
        }
        selected
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Feature::{Shadows, Sphere, Torus};

    fn suite() -> BTreeMap<String, BTreeSet<Feature>> {
        let all = [
            ("shadow/hard", vec![Shadows, Sphere]),
            ("sphere/far", vec![Sphere]),
            ("sphere/near", vec![Sphere]),
            ("torus/ring", vec![Torus]),
        ];
        let all = all.into_iter();
        all.map(|(name, has)| (name.to_owned(), has.into_iter().collect())).collect()
    }

    fn read(parts: &str, more: &str) -> Result<Plan, Vec<Problem>> {
        let text = format!("(version: 1, title: \"t\", parts: [{parts}], {more})");
        Plan::read(&text, &suite())
    }

    #[track_caller]
    fn selects(part: &str, expected: &[&str]) {
        let plan = read(&format!("(name: \"p\", points: 1, {part})"), "").unwrap();
        let found: Vec<_> = plan.parts[0].fixtures.iter().map(String::as_str).collect();
        assert_eq!(found, expected, "{part}");
    }

    #[test]
    fn a_part_is_about_fixtures_and_features() {
        selects("fixtures: [\"*\"]", &["shadow/hard", "sphere/far", "sphere/near", "torus/ring"]);
        selects(
            "fixtures: [\"sphere\", \"torus/ring\"]",
            &["sphere/far", "sphere/near", "torus/ring"],
        );
        selects("features: [Sphere]", &["shadow/hard", "sphere/far", "sphere/near"]);
        selects("features: [Torus, Shadows]", &["shadow/hard", "torus/ring"]);
        selects("fixtures: [\"s*\"], features: [Shadows]", &["shadow/hard"]);
    }

    /// The messages with their lines.
    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let problems = Plan::read(text, &suite()).unwrap_err();
        let said: Vec<_> = problems
            .iter()
            .map(|p| format!("{}: {}", scene::line_column(text, p.span.start).0, p.message))
            .collect();
        assert_eq!(said, expected, "{text}");
    }

    #[test]
    fn every_problem_has_its_place() {
        let part =
            |rest: &str| format!("(version: 1, title: \"t\", parts: [\n(\nname: \"a\",\n{rest})])");
        check(&part("points: 1"), &["2: expected `fixtures` or `features`, found neither"]);
        check(
            &part("points: -1,\nfixtures: [\"shpere/far\",\n\"\"]"),
            &[
                "4: expected points from 0 to 1000000 with two decimals at most, found -1",
                "5: the filter \"shpere/far\" selects nothing; did you mean \"sphere/far\"?",
                "6: expected a filter, found an empty text; `*` selects all",
            ],
        );
        check(
            &part("points: 1,\nfeatures: [Disk]"),
            &["5: expected a fixture that asks for Disk, found none"],
        );
        check(
            &part("points: 1,\nfixtures: [\"torus/ring\"],\nfeatures: [Sphere, Disk]"),
            &[
                "6: expected a fixture of those in `fixtures` that asks for Sphere or Disk, found none",
            ],
        );
        // What a wrong filter leaves empty is said once.
        check(
            &part("points: 1,\nfixtures: [\"zzzzzzzz\"],\nfeatures: [Disk]"),
            &["5: the filter \"zzzzzzzz\" selects nothing; `cargo xtask list` shows all names"],
        );
        check(
            "(version: 2,\ntitle: \" \",\nparts: [])",
            &[
                "1: expected version 1, found 2",
                "2: expected a title, found an empty text",
                "3: expected at least one part, found none",
            ],
        );
    }

    #[test]
    fn problems_of_form_are_those_of_every_file() {
        let problems = read("(name: \"a\", pionts: 1, per: Shar)", "").unwrap_err();
        assert!(problems.len() >= 2, "{problems:?}");
        assert!(read("", "").is_err());
        let deep = "[".repeat(100_000);
        assert!(Plan::read(&deep, &suite()).is_err());
        assert!(Plan::read(&"x".repeat(MAX_BYTES + 1), &suite()).is_err());
    }

    #[test]
    fn penalties_are_judged_too() {
        let part = "(name: \"a\", points: 1, fixtures: [\"*\"])";
        let twice = format!("{part}, {part}");
        let said = |parts: &str, more: &str| {
            let problems = read(parts, more).unwrap_err();
            problems.into_iter().map(|problem| problem.message).collect::<Vec<_>>()
        };
        assert_eq!(said(&twice, ""), ["expected another name, found \"a\" a second time"]);
        let wrong = "penalties: [(name: \"\", points: 0.001, outcomes: [], fixtures: [\"q\"], at_most: -1)]";
        assert_eq!(said(part, wrong).len(), 5);
        let good = "penalties: [(name: \"a\", points: 2, outcomes: [Crashed])]";
        assert_eq!(read(part, good).unwrap().penalties[0].fixtures.len(), 4);
    }

    #[test]
    fn what_no_part_asks_for_is_said() {
        let one = "(name: \"a\", points: 1, fixtures: [\"sphere\"])";
        let plan =
            read(&format!("{one}, (name: \"b\", points: 1, fixtures: [\"far\"])"), "").unwrap();
        assert_eq!(plan.unasked, ["shadow/hard", "torus/ring"]);
        assert_eq!(plan.shared, ["sphere/far"]);
        assert_eq!(plan.asked().len(), 2);
    }
}
