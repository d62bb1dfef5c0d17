//! The frontier, the families and the report, without a clock.

use super::*;
use crate::bench::contest::entrants;

fn row(kernel: &'static str, ns: f64, error: f64, wrong: f64) -> Row {
    Row {
        primitive: "sphere",
        family: "near",
        kernel,
        ns,
        error_p50: error,
        error_p999: error,
        error_max: error,
        misclassified_ppm: wrong,
        leaks_ppm: 0.0,
        frontier: false,
    }
}

#[test]
fn the_frontier_is_what_nothing_beats() {
    let mut rows = [
        row("fast-and-wrong", 0.5, 1e-9, 9.0),
        row("fast", 1.0, 1e-3, 0.0),
        row("faster-by-noise", 0.98, 1e-2, 0.0),
        row("slow-and-worse", 2.0, 1e-2, 0.0),
        row("slow-and-better", 2.0, 1e-4, 0.0),
        row("slow-and-exact", 9.0, 0.0, 0.0),
        row("as-slow-and-exact", 9.2, 0.0, 0.0),
        row("slower-and-exact", 9.9, 0.0, 0.0),
        row("never-right", 1.0, f64::NAN, 0.0),
    ];
    mark_frontier(&mut rows);
    let on: Vec<_> = rows.iter().filter(|row| row.frontier).map(|row| row.kernel).collect();
    assert_eq!(on, ["fast", "slow-and-better", "slow-and-exact", "as-slow-and-exact"]);
}

#[test]
fn every_number_of_a_case_is_of_f32_and_families_have_hits_and_misses() {
    const CASES: usize = 2000;
    for family in family::all() {
        let cases = family.cases(CASES);
        assert_eq!(cases.len(), CASES);
        assert_eq!(cases, family.cases(CASES));
        let single = |x: &f64| f64::from(*x as f32) == *x;
        assert!(cases.iter().all(|case| case.numbers().iter().all(single)), "{}", family.label());
        let truths: Vec<_> = cases.iter().map(|case| family.primitive.truth(case)).collect();
        let hits = truths.iter().filter(|truth| truth.t.is_some()).count();
        let misses = truths.iter().filter(|truth| truth.t.is_none() && !truth.tie).count();
        assert!(hits > CASES / 5, "{}: {hits} hits", family.label());
        // Each ray of this one starts on its way to the sphere.
        let all_hit = family.label() == "sphere/near-surface";
        assert!(misses > CASES / 20 || all_hit, "{}: {misses} misses", family.label());
    }
}

#[test]
fn double_double_answers_every_case_right() {
    const CASES: usize = 2000;
    for family in family::all() {
        let entrants = entrants(family.primitive);
        let entrant = entrants.iter().find(|e| e.name == "double-double").unwrap();
        for case in family.cases(CASES) {
            let truth = family.primitive.truth(&case);
            if !truth.tie {
                assert_eq!(entrant.answer(&case), truth.t.map(|(hi, _)| hi), "{case:?}");
            }
        }
    }
}

#[test]
fn a_run_has_a_row_for_each_kernel_and_all_its_forms_are_made() {
    let effort = Effort { judged: 64, timed: 16, rounds: 1, turn: 1e-6 };
    let mut begun = Vec::new();
    let report =
        run(|label| label.contains("mesh-edge"), &effort, |label| begun.push(label.to_owned()));
    assert_eq!(begun, ["triangle/mesh-edge"]);
    assert_eq!(report.rows.len(), 11);
    assert!(report.rows.iter().any(|row| row.frontier));
    let ours = report.rows.iter().find(|row| row.kernel == OURS).unwrap();
    assert_eq!((ours.misclassified_ppm, ours.leaks_ppm), (0.0, 0.0));
    let (text, svg) = (text(&report), svg(&report));
    for row in &report.rows {
        assert!(text.contains(row.kernel) && svg.contains(row.kernel), "{}", row.kernel);
    }
}
