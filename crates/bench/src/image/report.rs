//! What was measured, as machines read it.

use std::collections::BTreeMap;

use serde::Serialize;

use super::curve::{Point, Reach, reach};

/// The errors that are asked for.
pub(crate) const TARGETS: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// Everything that one run measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Report {
    /// The version of this form.
    pub(crate) schema: u32,
    /// What an error is.
    pub(crate) error: &'static str,
    /// What a time is.
    pub(crate) time: &'static str,
    /// The processor's name.
    pub(crate) machine: String,
    /// Engine to version.
    pub(crate) versions: BTreeMap<String, String>,
    /// Engine to why it is not there.
    pub(crate) missing: BTreeMap<String, String>,
    /// Each scene's own.
    pub(crate) scenes: Vec<OfScene>,
    /// Each setting that was measured.
    pub(crate) rows: Vec<Row>,
    /// How long each engine takes to each error.
    pub(crate) reached: Vec<Reached>,
    /// How many times longer than goldray's best way others take.
    pub(crate) ratios: Vec<Ratio>,
}

impl Report {
    /// What an error is, and what a time.
    pub(crate) const ERROR: &'static str = "RMSE over linear RGB and all pixels against the truth; \
                                            nothing is cut off, as no scene is brighter than 1";
    pub(crate) const TIME: &'static str = "CPU seconds of rendering on one thread: without reading \
                                           the scene, building what speeds it up, and writing the \
                                           picture; medians of interleaved repetitions";
}

/// A scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct OfScene {
    pub(crate) scene: String,
    pub(crate) about: String,
    pub(crate) image: (u32, u32),
    /// How the truth is known.
    pub(crate) truth: &'static str,
    /// How close to the truth each engine came with any setting that was tried: at
    /// least so well do they agree on the scene.
    pub(crate) closest: BTreeMap<String, f64>,
}

/// A setting that was measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Row {
    pub(crate) scene: String,
    pub(crate) engine: String,
    pub(crate) setting: String,
    /// The median.
    pub(crate) seconds: f64,
    /// The least and the most.
    pub(crate) spread: (f64, f64),
    pub(crate) repetitions: usize,
    pub(crate) rmse: f64,
    /// Whether nobody's other setting is as fast and as exact.
    pub(crate) frontier: bool,
}

impl Row {
    pub(crate) fn point(&self) -> Point {
        Point { seconds: self.seconds, rmse: self.rmse }
    }
}

/// How long an engine takes to an error.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Reached {
    pub(crate) scene: String,
    pub(crate) engine: String,
    pub(crate) rmse: f64,
    pub(crate) seconds: f64,
    /// `between` two settings, the `cheapest` one has it already, or `not within`
    /// the seconds of the best setting that was tried.
    pub(crate) how: &'static str,
}

/// How many times longer one engine takes than another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Ratio {
    pub(crate) scene: String,
    pub(crate) rmse: f64,
    pub(crate) engine: String,
    pub(crate) than: String,
    pub(crate) times: f64,
    /// Whether that is the least it can be, as the error was not reached.
    pub(crate) at_least: bool,
}

/// Marks what is on the frontier of its scene.
pub(crate) fn mark_frontier(rows: &mut [Row]) {
    let points: Vec<_> = rows.iter().map(Row::point).collect();
    for k in super::curve::frontier(&points) {
        rows[k].frontier = true;
    }
}

/// How long each engine takes to each error on a scene with these rows, in the
/// rows' order.
pub(crate) fn reached(rows: &[Row]) -> Vec<Reached> {
    let mut engines: Vec<&str> = rows.iter().map(|row| row.engine.as_str()).collect();
    engines.dedup();
    let mut all = Vec::new();
    for (engine, rmse) in engines.iter().flat_map(|engine| TARGETS.map(|rmse| (*engine, rmse))) {
        let own = rows.iter().filter(|row| row.engine == engine);
        let points: Vec<_> = own.clone().map(Row::point).collect();
        if let (Some(row), Some(reach)) = (own.clone().next(), reach(&points, rmse)) {
            let how = match reach {
                Reach::Between(_) => "between",
                Reach::Cheapest(_) => "cheapest",
                Reach::NotWithin(_) => NOT_WITHIN,
            };
            let (scene, engine) = (row.scene.clone(), engine.to_owned());
            all.push(Reached { scene, engine, rmse, seconds: reach.seconds(), how });
        }
    }
    all
}

const NOT_WITHIN: &str = "not within";

impl Reached {
    /// Whether the error is not reached by what was tried.
    pub(crate) fn is_not_within(&self) -> bool {
        self.how == NOT_WITHIN
    }
}

/// How many times longer than `than` the others take on the same scene; none
/// where `than` does not get there.
pub(crate) fn ratios(reached: &[Reached], than: &str) -> Vec<Ratio> {
    let base = |other: &Reached| {
        reached
            .iter()
            .find(|one| one.engine == than && one.scene == other.scene && one.rmse == other.rmse)
    };
    reached
        .iter()
        .filter(|other| other.engine != than)
        .filter_map(|other| {
            let base = base(other).filter(|base| !base.is_not_within())?;
            Some(Ratio {
                scene: other.scene.clone(),
                rmse: other.rmse,
                engine: other.engine.clone(),
                than: than.to_owned(),
                times: other.seconds / base.seconds,
                at_least: other.is_not_within(),
            })
        })
        .collect()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A report of two engines on one scene.
    pub(crate) fn report() -> Report {
        let row = |engine: &str, setting: &str, seconds: f64, rmse: f64| Row {
            scene: "balls".into(),
            engine: engine.into(),
            setting: setting.into(),
            seconds,
            spread: (seconds * 0.9, seconds * 1.25),
            repetitions: 3,
            rmse,
            frontier: false,
        };
        let mut rows = vec![
            row("goldray-adaptive", "error 1e-1", 0.1, 5e-3),
            row("goldray-adaptive", "error 1e-3", 1.0, 5e-5),
            row("povray", "-A", 0.3, 2e-2),
            row("povray", "+AM2 +R3 +A0.1 -J", 3.0, 2e-3),
        ];
        mark_frontier(&mut rows);
        let reached = reached(&rows);
        let ratios = ratios(&reached, "goldray-adaptive");
        Report {
            schema: 1,
            error: Report::ERROR,
            time: Report::TIME,
            machine: "a processor".into(),
            versions: BTreeMap::from([("povray".into(), "3.7".into())]),
            missing: BTreeMap::from([("mitsuba-llvm".into(), "not installed".into())]),
            scenes: vec![OfScene {
                scene: "balls".into(),
                about: "7 spheres".into(),
                image: (640, 480),
                truth: "integrated",
                closest: BTreeMap::from([("povray".into(), 1e-4)]),
            }],
            rows,
            reached,
            ratios,
        }
    }

    #[test]
    fn the_frontier_and_the_ratios_are_those_of_the_rows() {
        let report = report();
        let marks: Vec<_> = report.rows.iter().map(|row| row.frontier).collect();
        assert_eq!(marks, [true, true, false, false]);
        let how: Vec<_> = report.reached.iter().map(|reached| reached.how).collect();
        let (own, other) =
            (["cheapest", "between", "between"], ["between", "not within", "not within"]);
        assert_eq!(how, [own, other].concat());
        let at_least: Vec<_> = report.ratios.iter().map(|ratio| ratio.at_least).collect();
        assert_eq!(at_least, [false, true, true]);
        // To 1e-2 POV-Ray takes 0.3 * 10^log10(2) = 0.6 seconds, goldray 0.1.
        let times = report.ratios[0].times;
        let expected = 0.3 * libm::exp10(libm::log10(2.0)) / 0.1;
        assert!((times / expected - 1.0).abs() < 1e-12, "{times}");
        // Where the base does not get there, there is no ratio.
        assert!(ratios(&report.reached, "povray").iter().all(|ratio| ratio.rmse == 1e-2));
    }

    #[test]
    fn machines_find_what_they_look_for() {
        let json = serde_json::to_value(report()).unwrap();
        assert_eq!(json["schema"], 1);
        assert_eq!(json["rows"][0]["spread"][1], 0.125);
        assert_eq!(json["rows"][2]["setting"], "-A");
        assert_eq!(json["reached"][0]["how"], "cheapest");
        assert_eq!(json["ratios"][1]["at_least"], true);
        assert_eq!(json["scenes"][0]["closest"]["povray"], 1e-4);
        assert_eq!(json["missing"]["mitsuba-llvm"], "not installed");
    }
}
