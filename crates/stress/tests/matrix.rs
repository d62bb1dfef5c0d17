//! A sample of the stress matrix: every family, fewer cases, the same targets.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;

use stress::kept::Kept;
use stress::{Case, Family, Random, Tally, subject, table};

/// Cases of each family: enough to notice a broken formula, few enough for
/// every test run.
const CASES: u64 = 1_000;

/// The first case that is beyond a target, if any of the sample is.
fn first_offender(family: &Family) -> (Vec<Tally>, Option<Case>) {
    let mut tallies = family.tallies();
    let mut random = Random::of_chunk(7, &family.label(), 0);
    let mut offender = None;
    for _ in 0..CASES.min(family.volume.quick) {
        let case = (family.generate)(&mut random);
        (family.judge)(&case, &mut tallies);
        let offended = stress::tally::take_offense(&mut tallies);
        offender = offender.or(offended.then_some(case));
    }
    (tallies, offender)
}

#[test]
fn every_family_holds_on_a_sample() {
    use rayon::prelude::*;
    let failed: Vec<_> = subject::all()
        .par_iter()
        .filter_map(|family| {
            let (tallies, offender) = first_offender(family);
            let rows = table::rows(family, &tallies);
            let failed = rows.iter().any(|row| row.contract && !row.pass);
            let line = |case| Kept { family: family.label(), case }.line();
            failed.then(|| format!("{}{:?}", table::text(&rows), offender.map(line)))
        })
        .collect();
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

#[test]
fn labels_are_unique_and_say_a_known_primitive() {
    const PRIMITIVES: [&str; 13] = [
        "sphere", "triangle", "box", "plane", "disk", "cylinder", "cone", "torus", "mesh",
        "instance", "spawn", "camera", "image",
    ];
    let families = subject::all();
    let labels: BTreeSet<_> = families.iter().map(Family::label).collect();
    assert_eq!(labels.len(), families.len());
    let found: BTreeSet<_> = families.iter().map(|family| family.primitive).collect();
    assert_eq!(found, BTreeSet::from(PRIMITIVES));
}

#[test]
fn every_family_holds_a_kernel_to_something() {
    for family in subject::all() {
        let label = family.label();
        assert!(family.kernels.iter().any(|kernel| kernel.contract), "{label}");
        assert!(family.targets.iter().any(|(_, target)| target.is_some()), "{label}");
        assert!(family.volume.quick > 0 && family.volume.quick <= family.volume.full, "{label}");
    }
}

#[test]
fn a_case_says_all_that_its_family_needs() {
    // Judged from its numbers alone, as a kept case is, it gives the same.
    for family in subject::all() {
        let mut random = Random::of_chunk(8, &family.label(), 0);
        for _ in 0..20 {
            let case = (family.generate)(&mut random);
            let line = Kept { family: family.label(), case }.line();
            let read = stress::kept::read(&line).unwrap();
            let judged = |case: &Case| {
                let mut tallies = family.tallies();
                (family.judge)(case, &mut tallies);
                tallies.iter().map(Tally::to_stored).collect::<Vec<_>>()
            };
            assert_eq!(judged(&case), judged(&read[0].case), "{line}");
        }
    }
}

#[test]
fn the_kept_cases_hold() {
    let text = include_str!("../../../tests/kept-cases.txt");
    let families = subject::all();
    for kept in stress::kept::read(text).unwrap() {
        let family = families.iter().find(|family| family.label() == kept.family);
        let family = family.unwrap_or_else(|| panic!("no family {}", kept.family));
        assert!(!family.offends(&kept.case), "{}", kept.line());
    }
}
