//! `steady`: whether a fixture's picture comes out the same each time.

use std::time::Instant;

use crate::expectation::Rendered;
use crate::fixture::Fixture;
use crate::run::{self, Judged, judge_fixture};
use crate::store::StoreError;
use crate::suite::{Selection, Suite};
use crate::verdict::Outcome;

/// Judges everything selected as [`run::run`] does, of which every fixture is
/// rendered `repeats` times. One whose picture then differs in a bit, of the
/// linear picture or the encoded one, is unsteady.
///
/// # Errors
/// Artifacts that cannot be written.
pub fn run_repeatedly(
    suite: &Suite,
    selection: &Selection,
    repeats: u32,
    on_outcome: &(dyn Fn(&Outcome) + Sync),
) -> Result<Vec<Outcome>, StoreError> {
    let judge = |suite: &Suite, name: &str| {
        judge_repeatedly(suite, name, repeats, &mut Fixture::render_again)
    };
    run::run_by(suite, selection, &judge, on_outcome)
}

/// Judges a fixture, then has it rendered `again` until there are `repeats`
/// pictures.
pub fn judge_repeatedly(
    suite: &Suite,
    name: &str,
    repeats: u32,
    again: &mut dyn FnMut(&Fixture) -> Result<Rendered, String>,
) -> Judged {
    let mut judged = judge_fixture(suite, name);
    if let Ok((fixture, first)) = &judged.rendered {
        let started = Instant::now();
        let unsteady = difference(first, (1..repeats).map(|_| again(fixture)));
        judged.judgment = judged.judgment.with_steadiness(unsteady);
        judged.render_ms += started.elapsed().as_secs_f64() * 1e3;
    }
    judged
}

/// How other renders of a scene differ from the first in any bit, in a
/// sentence; `None` where none does. One that was refused differs in all.
pub fn difference(
    first: &Rendered,
    others: impl IntoIterator<Item = Result<Rendered, String>>,
) -> Option<String> {
    let mut moved = vec![false; first.encoded.pixels().len()];
    let (mut renders, mut differing, mut example) = (1, 0, None);
    for other in others {
        renders += 1;
        let places = match other {
            Ok(other) => differing_pixels(first, &other),
            Err(why) => Err(format!("a render was refused: {why}")),
        };
        match places {
            Ok(places) if places.is_empty() => continue,
            Ok(places) => places.into_iter().for_each(|place| moved[place] = true),
            Err(why) => _ = example.get_or_insert(why),
        }
        differing += 1;
    }
    if differing == 0 {
        return None;
    }
    let what = example.unwrap_or_else(|| {
        let count = moved.iter().filter(|&&moved| moved).count();
        let width = first.encoded.size().width as usize;
        let place = moved.iter().position(|&moved| moved).unwrap_or_default();
        let (x, y) = (place % width, place / width);
        format!("{count} of {} pixels have other bits, first ({x}, {y})", moved.len())
    });
    Some(format!("{differing} of {renders} renders differ from the first: {what}"))
}

/// The places, row by row, of pixels that are not the same in every bit.
///
/// # Errors
/// Pictures of two sizes.
fn differing_pixels(a: &Rendered, b: &Rendered) -> Result<Vec<usize>, String> {
    let (size, other) = (a.linear.size(), b.linear.size());
    if size != other || a.encoded.size() != b.encoded.size() {
        return Err(format!("one is {} x {}", other.width, other.height));
    }
    let bits = |picture: &Rendered, place: usize| {
        picture.linear.pixels()[place].channels().map(f64::to_bits)
    };
    let differs = |&place: &usize| {
        bits(a, place) != bits(b, place) || a.encoded.pixels()[place] != b.encoded.pixels()[place]
    };
    Ok((0..a.encoded.pixels().len()).filter(differs).collect())
}

#[cfg(test)]
mod tests;
