//! `Overall`: what came of the consensus over all fixtures.

use std::collections::BTreeMap;

use super::{Opinion, Pixels, Told};

/// What came of the consensus over all fixtures.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Overall {
    /// Fixtures with enough pictures.
    pub fixtures: u64,
    /// Those of them where all agree inside of what is seen.
    pub agreed: u64,
    /// Each voter's part, by id.
    pub voters: BTreeMap<String, Share>,
    /// Interior pixels without a majority.
    pub undecided: u64,
}

/// A voter's part in it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Share {
    /// Fixtures that it was heard of.
    pub heard: u64,
    /// Pixels where it alone is against the majority.
    pub alone: Pixels,
    /// Pixels where it is against the majority with others.
    pub with_others: Pixels,
    /// Fixtures where it stands alone in an interior pixel, those with the most
    /// pixels first.
    pub alone_in: Vec<(String, u64)>,
}

/// Sums up what was told of each fixture, by name.
pub fn overall<'a>(all: impl Iterator<Item = (&'a str, &'a Told)>) -> Overall {
    let mut sum = Overall::default();
    for (name, told) in all {
        sum.fixtures += 1;
        let is_apart = |(opinion, pixels): (&Opinion, &Pixels)| {
            *opinion != Opinion::Agree && pixels.interior > 0
        };
        sum.agreed += u64::from(!told.opinions.iter().any(is_apart));
        for (i, voter) in told.voters.iter().enumerate() {
            let share = sum.voters.entry(voter.clone()).or_default();
            share.heard += 1;
            for (opinion, pixels) in &told.opinions {
                let odd = opinion.dissenters();
                if odd.only() == Some(i) {
                    add(&mut share.alone, *pixels);
                    if pixels.interior > 0 {
                        share.alone_in.push((name.to_owned(), pixels.interior));
                    }
                } else if odd.has(i) {
                    add(&mut share.with_others, *pixels);
                }
            }
        }
        let undecided = told.opinions.iter().filter(|(opinion, _)| {
            matches!(opinion, Opinion::Halves(..) | Opinion::AllDiffer | Opinion::Unclear)
        });
        sum.undecided += undecided.map(|(_, pixels)| pixels.interior).sum::<u64>();
    }
    for share in sum.voters.values_mut() {
        share.alone_in.sort_by_key(|(_, pixels)| std::cmp::Reverse(*pixels));
    }
    sum
}

fn add(sum: &mut Pixels, pixels: Pixels) {
    sum.interior += pixels.interior;
    sum.edge += pixels.edge;
}
