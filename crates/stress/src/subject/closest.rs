//! The question that most primitives are asked: where is the ray's first hit?

use tracer::glam::DVec3;

use crate::family::{Family, Generate, Kernel, Volume};
use crate::truth::{Truth, UNIT_ROUNDOFF, distance};
use crate::{Case, Metric, Random, Tally};

/// A kernel with its formula: the first `t` above 0.
pub(super) type Answer = (Kernel, fn(&Case) -> Option<f64>);

/// What the inputs are, which decides how an error is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Inputs {
    /// Numbers of `f32`: `t` rounded to `f32` is off by at most this many of
    /// its units.
    Single {
        /// In units of the last place; one half is a correct rounding.
        ulp32: f64,
    },
    /// Numbers of `f64`: the error of `t` is at most this many times what one
    /// rounding of the inputs may do.
    Double {
        /// In units of `kappa u |t|`.
        condition_error: f64,
    },
}

/// What all families of a primitive have in common.
pub(super) struct Subject {
    /// Its name.
    pub(super) primitive: &'static str,
    /// The exact answer.
    pub(super) truth: fn(&Case) -> Truth,
    /// Who answers.
    pub(super) answers: Vec<Answer>,
}

impl Subject {
    /// A family of this primitive.
    pub(super) fn family(
        &self,
        name: impl Into<String>,
        inputs: Inputs,
        volume: Volume,
        generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
    ) -> Family {
        let (truth, answers) = (self.truth, self.answers.clone());
        let generate: Generate = Box::new(generate);
        Family {
            primitive: self.primitive,
            name: name.into(),
            kernels: answers.iter().map(|(kernel, _)| *kernel).collect(),
            targets: targets(inputs),
            volume,
            generate,
            judge: Box::new(move |case, tallies| {
                let truth = truth(case);
                let shown = is_shown(case);
                for ((kernel, answer), tally) in answers.iter().zip(tallies) {
                    if kernel.contract || shown {
                        judge(&truth, answer(case), tally);
                    }
                }
            }),
        }
    }
}

/// Whether kernels that are only shown answer this case: one in eight, so that
/// the time goes into those that are held to something.
pub(super) fn is_shown(case: &Case) -> bool {
    const ONE_IN: u32 = 8;
    // The sum of the mantissas' bits is as good as a throw of dice.
    let ones = case.numbers().iter().map(|x| x.to_bits().count_ones()).sum::<u32>();
    ones % ONE_IN == 0
}

fn targets(inputs: Inputs) -> Vec<(Metric, Option<f64>)> {
    let none = Some(0.0);
    let mut targets =
        vec![(Metric::FalseMisses, none), (Metric::FalseHits, none), (Metric::NotFinite, none)];
    match inputs {
        Inputs::Single { ulp32 } => {
            targets.extend([(Metric::Ulp32, Some(ulp32)), (Metric::Ulp32Usual, None)]);
        }
        Inputs::Double { condition_error } => targets.extend([
            (Metric::ConditionError, Some(condition_error)),
            (Metric::Ulp64Usual, None),
            (Metric::Ulp64, None),
        ]),
    }
    targets
}

/// `f32` errors are told to this part of a unit in the last place: an `f64`
/// that is right to its own last place may round to the other neighbor of a
/// number halfway between two `f32`s, which is 2^-29 beyond one half.
const ULP32_DIGITS: f64 = 1e6;

/// Counts the case; whether it is left to hold the answer against the truth:
/// it is a number or none, and the case is no tie.
pub(super) fn is_decided(tie: bool, answer: Option<f64>, tally: &mut Tally) -> bool {
    if answer.is_some_and(|t| !t.is_finite()) {
        tally.case();
        tally.count(Metric::NotFinite);
        return false;
    }
    if tie {
        tally.tie();
        return false;
    }
    tally.case();
    true
}

/// Holds one answer against the exact one.
pub(super) fn judge(truth: &Truth, answer: Option<f64>, tally: &mut Tally) {
    if !is_decided(truth.tie, answer, tally) {
        return;
    }
    match (truth.t, answer) {
        (None, None) => {}
        (Some(_), None) => tally.count(Metric::FalseMisses),
        (None, Some(_)) => tally.count(Metric::FalseHits),
        (Some(exact), Some(t)) => {
            let error = distance(t, exact);
            let ulp32 = distance(f64::from(t as f32), exact) / f64::from(ulp_f32(exact.0));
            let ulp32 = (ulp32 * ULP32_DIGITS).round() / ULP32_DIGITS;
            let ulp64 = error / ulp(exact.0);
            tally.most(Metric::Ulp32, ulp32);
            tally.spread(Metric::Ulp32Usual, ulp32);
            tally.most(Metric::Ulp64, ulp64);
            tally.spread(Metric::Ulp64Usual, ulp64);
            // The answer's own rounding to an `f64` is always allowed for.
            let allowed = UNIT_ROUNDOFF * truth.condition.max(exact.0.abs());
            tally.most(Metric::ConditionError, error / allowed);
        }
    }
}

/// The distance from `|x|` to the next `f64`.
pub(super) fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

/// The distance from `|x|`, rounded down to an `f32`, to the next `f32`.
fn ulp_f32(x: f64) -> f32 {
    let nearest = x.abs() as f32;
    let below = if f64::from(nearest) > x.abs() { nearest.next_down() } else { nearest };
    below.next_up() - below
}

/// Numbers on which arithmetic has rules of its own.
pub(super) const SPECIAL: [f64; 14] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    1e20,
    -1e20,
    1e-200,
    1e200,
    1.0,
];

/// Cases that every primitive is asked: a ray with NaN, infinities, zeros of
/// both signs, denormal and enormous numbers in any of its slots. A hit must
/// be finite, and no ray with a NaN or an infinity has one.
pub(super) fn special(
    primitive: &'static str,
    answers: Vec<Answer>,
    ray_at: usize,
    volume: Volume,
    generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
) -> Family {
    let kernels = answers.iter().map(|(kernel, _)| *kernel).collect();
    Family {
        primitive,
        name: "special-values".to_owned(),
        kernels,
        targets: vec![(Metric::NotFinite, Some(0.0)), (Metric::Panics, Some(0.0))],
        volume,
        generate: Box::new(move |random| {
            let case = generate(random);
            let mut numbers = case.numbers().to_vec();
            for _ in 0..=random.below(3) {
                let slot = ray_at + random.below(6);
                if let Some(number) = numbers.get_mut(slot) {
                    *number = random.one_of(&SPECIAL);
                }
            }
            Case::of(&numbers).unwrap_or(case)
        }),
        judge: Box::new(move |case, tallies| {
            let ray = case.ray(ray_at);
            let finite = ray.origin.is_finite() && ray.direction.is_finite();
            for ((_, answer), tally) in answers.iter().zip(tallies) {
                tally.case();
                match std::panic::catch_unwind(|| answer(case)) {
                    Ok(Some(t)) if !(finite && t.is_finite()) => tally.count(Metric::NotFinite),
                    Ok(_) => {}
                    Err(_) => tally.count(Metric::Panics),
                }
            }
        }),
    }
}

/// A ray's origin at `distance` from `target`, with a direction of some length
/// that passes `target`.
pub(super) fn towards(target: DVec3, way: DVec3, distance: f64, length: f64) -> (DVec3, DVec3) {
    (target - way * distance, way * length)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The metrics beyond their target, of one answer to one truth.
    fn broken(inputs: Inputs, truth: Truth, answer: Option<f64>) -> Vec<&'static str> {
        let targets = targets(inputs);
        let mut tally = Tally::new(&targets, true);
        judge(&truth, answer, &mut tally);
        let beyond = |(metric, target): &(Metric, Option<f64>)| {
            target.is_some_and(|target| tally.value(*metric) > target)
        };
        targets.iter().filter(|t| beyond(t)).map(|(metric, _)| metric.name()).collect()
    }

    const SINGLE: Inputs = Inputs::Single { ulp32: 0.5 };
    const DOUBLE: Inputs = Inputs::Double { condition_error: 4.0 };

    #[test]
    fn wrong_answers_are_named() {
        let three = Truth::hit((3.0, 0.0), 3.0);
        assert_eq!(broken(SINGLE, three, Some(3.0)), [""; 0]);
        assert_eq!(broken(SINGLE, three, None), ["false_misses"]);
        assert_eq!(broken(SINGLE, Truth::MISS, Some(3.0)), ["false_hits"]);
        assert_eq!(broken(SINGLE, Truth::TIE, Some(3.0)), [""; 0]);
        assert_eq!(broken(SINGLE, Truth::TIE, Some(f64::NAN)), ["not_finite"]);
        assert_eq!(broken(SINGLE, three, Some(f64::from(3.0_f32.next_up()))), ["ulp32_max"]);
        let off = |ulps: f64| Some(3.0 + ulps * ulp(3.0));
        // An ulp of 3 is 4/3 of 2^-53 times 3.
        assert_eq!(broken(DOUBLE, three, off(3.0)), [""; 0]);
        assert_eq!(broken(DOUBLE, three, off(4.0)), ["condition_error"]);
        let ill = Truth::hit((3.0, 0.0), 3000.0);
        assert_eq!(broken(DOUBLE, ill, off(2000.0)), [""; 0]);
        assert_eq!(broken(DOUBLE, ill, off(4000.0)), ["condition_error"]);
    }

    #[test]
    fn the_low_part_of_the_truth_counts() {
        // A quarter of an ulp beside 1, and told from both sides.
        let low = 0.25 * f64::EPSILON;
        assert_eq!(distance(1.0, (1.0, low)), low);
        assert_eq!(distance(1.0_f64.next_up(), (1.0, low)), 3.0 * low);
        assert_eq!(ulp_f32(1.0_f64.next_down()), f32::EPSILON / 2.0);
    }
}
