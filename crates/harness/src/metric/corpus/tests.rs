//! The corpus: every metric rates every case as stated, and every blind spot is shown.

use std::collections::BTreeMap;

use super::blind_spots::{BLIND_SPOTS, Shown};
use super::*;
use crate::metric::{Comparison, Metric};

#[test]
fn every_metric_rates_every_case_as_stated() {
    for case in corpus() {
        assert_eq!(case.outcome(), case.expected, "{}", case.name);
    }
}

#[test]
fn the_corpus_is_large_and_its_names_are_its_own() {
    let names: BTreeMap<_, _> = corpus().into_iter().map(|case| (case.name, case)).collect();
    assert_eq!(names.len(), corpus().len());
    assert!(corpus().iter().filter(|case| case.ratings().is_ok()).count() >= 24);
}

#[test]
fn every_metric_has_a_scale_that_leaves_room() {
    assert_eq!(SCALES.map(|scale| scale.metric).to_vec(), names());
    let wrong = SCALES.iter().zip(METRICS).find(|(scale, metric)| match metric.direction {
        crate::metric::Direction::HigherIsBetter => scale.tight <= scale.loose,
        crate::metric::Direction::LowerIsBetter => scale.loose <= scale.tight,
    });
    assert!(wrong.is_none(), "{wrong:?}");
}

fn names() -> Vec<&'static str> {
    METRICS.iter().map(|metric| metric.name).collect()
}

/// Whoever words a blind spot also shows it.
#[test]
fn every_clause_of_a_blind_spot_is_shown() {
    let stated: Vec<_> = METRICS
        .iter()
        .flat_map(|metric| metric.blind_spot.split("; ").map(|clause| (metric.name, clause)))
        .collect();
    let shown: Vec<_> = BLIND_SPOTS.iter().map(|&(metric, clause, _)| (metric, clause)).collect();
    assert_eq!(stated, shown);
}

fn metric(name: &str) -> &'static Metric {
    METRICS.iter().find(|metric| metric.name == name).unwrap()
}

fn comparison(case: &str) -> Comparison {
    let case = corpus().into_iter().find(|found| found.name == case).unwrap();
    compare(&case.golden.unwrap(), &case.actual.unwrap()).unwrap()
}

fn rating(name: &str, case: &str) -> Rating {
    let scale = SCALES.iter().find(|scale| scale.metric == name).unwrap();
    scale.rate(metric(name), &comparison(case))
}

#[test]
fn every_blind_spot_is_one() {
    for &(name, clause, shown) in BLIND_SPOTS {
        let is_shown = match shown {
            Shown::Passes(case) => rating(name, case) == Rating::Blind,
            Shown::Alike(one, other) => {
                let [one, other] = [one, other].map(comparison);
                let value = metric(name).value;
                one != other && value(&one).is_some() && value(&one) == value(&other)
            }
            Shown::Harsher(case, than) => {
                rating(name, case) == Rating::Large && rating(than, case) != Rating::Large
            }
        };
        assert!(is_shown, "{name}, {clause}: {shown:?}");
    }
}

#[test]
fn no_damage_is_passed_by_all() {
    for case in corpus() {
        if let Ok(ratings) = case.ratings() {
            let passes = |rating: &Rating| [Rating::Same, Rating::Blind].contains(rating);
            assert!(!ratings.iter().all(passes) || ratings[0] == Rating::Same, "{}", case.name);
        }
    }
}
