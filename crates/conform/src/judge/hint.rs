//! What would make a picture right that is not: the usual mistakes of adapters and
//! of first renderers.

use harness::picture_file::Stored;

use super::{Allowance, Levels, Reference, judge};
use crate::adapter::{Meaning, Rounding, Transfer};

/// Another meaning of the file by which its interior is right, in a sentence.
pub(super) fn hint(
    reference: &Reference<'_>,
    (stored, grid): (&Stored, u32),
    meaning: Meaning,
    allowance: Allowance,
) -> Option<String> {
    let turned = [meaning.rows, meaning.rows.turned()];
    let curved = |rows| Transfer::ALL.map(|transfer| Meaning { transfer, rows, ..meaning });
    let all = turned.into_iter().flat_map(curved);
    let all = all.flat_map(|meaning| Rounding::ALL.map(|rounding| Meaning { rounding, ..meaning }));
    let is_right = |other: &Meaning| {
        let levels = Levels::of(stored, *other);
        levels.is_ok_and(|levels| {
            judge(reference, &levels.gathered(grid), allowance).numbers.interior_off == 0
        })
    };
    let other = all.filter(|other| *other != meaning).find(is_right)?;
    let mut words = Vec::new();
    if other.rows != meaning.rows {
        words.push(format!("upside down (`rows: {:?}` in its adapter)", other.rows));
    }
    if other.transfer != meaning.transfer {
        words.push(format!("with another curve (`transfer: {:?}` in its adapter)", other.transfer));
    }
    if other.rounding != meaning.rounding {
        let rounding = other.rounding;
        words.push(format!(
            "with codes rounded otherwise (`rounding: {rounding:?}` in its adapter)"
        ));
    }
    Some(format!("its interior would be right {}", words.join(" and ")))
}
