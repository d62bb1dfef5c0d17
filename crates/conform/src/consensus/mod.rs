//! Consensus: of three or more renderers of one scene, which is the odd one out,
//! region by region.
//!
//! goldray is one of them, by the picture that judges the others. A run of goldray
//! itself, by its own adapter, is the same program: it gets no second vote. A picture
//! that may be of a single color where goldray's is not has none either.
//!
//! Two agree in a pixel where what their files may stand for is in no channel farther
//! apart than the larger tolerance, relative to the brightest channel of the two.
//! Whether one agrees with goldray has been judged, and is taken from there; two that
//! do agree with each other as well: their values are about the one that goldray has. Pixels where a moved sample would see something else are counted apart: any
//! two renderers may differ there.

mod opinion;
mod overall;
mod picture;
mod regions;

use std::collections::BTreeMap;

use tracer::{LinearImage, Rgb, Size};

pub use opinion::{MOST_VOTERS, Opinion, Voters};
pub use overall::{Overall, Share, overall};
pub use picture::{COLORS, SEVERAL, UNDECIDED, disagreement};

use crate::objects::{Objects, Seen};
use crate::scale::Scale;
use crate::{Conformed, Evidence};
use regions::areas;

/// The number of the voter that goldray is.
pub const GOLDRAY: &str = "goldray";

/// Fewer do not make an odd one out.
pub const FEWEST_VOTERS: usize = 3;

/// So many regions are told, the largest.
pub const MOST_REGIONS: usize = 100;

/// What renderers say of one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Told {
    /// Who was heard, by id, goldray first.
    pub voters: Vec<String>,
    /// Whose picture there is not, is of another size or says nothing, by id.
    pub unheard: Vec<String>,
    /// Of the pictures.
    pub size: Size,
    /// How many pixels there are of each opinion.
    pub opinions: BTreeMap<Opinion, Pixels>,
    /// Interior pixels of one opinion that lie together, but of [`Opinion::Agree`];
    /// the largest first, at most [`MOST_REGIONS`].
    pub regions: Vec<Region>,
    /// How many regions are not told, and their pixels.
    pub untold: (u64, u64),
    /// The opinion of each pixel, row by row from the top; empty where all agree.
    pub map: Vec<Opinion>,
}

/// Pixels, those at edges apart.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Pixels {
    /// Inside of what is seen.
    pub interior: u64,
    /// Where a moved sample would see something else.
    pub edge: u64,
}

/// Interior pixels of one opinion that lie together.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// The opinion.
    pub opinion: Opinion,
    /// How many they are.
    pub pixels: u64,
    /// Column and row of the upper left corner of the box around them.
    pub from: (u32, u32),
    /// Of the lower right corner, which is in it.
    pub to: (u32, u32),
    /// What most of them show, and how many do.
    pub on: Option<(Seen, u64)>,
}

/// A renderer's picture, and how far it may be off.
struct Voice<'a> {
    tolerance: f64,
    /// Its picture; `None` for goldray.
    evidence: Option<&'a Evidence>,
}

/// What the runs say of a fixture; `None` where fewer than [`FEWEST_VOTERS`] have a
/// picture of it, goldray included.
///
/// `objects` says what each pixel shows, where that is known; it is asked only where
/// they disagree.
pub fn of_fixture(
    name: &str,
    runs: &[Conformed],
    objects: &dyn Fn() -> Option<Objects>,
) -> Option<Told> {
    let others = runs.iter().filter(|one| one.run.renderer.id != GOLDRAY);
    let asked: Vec<_> = others.filter(|one| one.run.fixtures.contains_key(name)).collect();
    let reference = asked.iter().find_map(|one| one.evidence.get(name).filter(|e| is_whole(e)))?;
    let size = reference.reference.size();
    let mut voices = vec![Voice { tolerance: 0.0, evidence: None }];
    let (mut voters, mut unheard) = (vec![GOLDRAY.to_owned()], Vec::new());
    for one in asked {
        let id = one.run.renderer.id.clone();
        // Another reference means that the runs were of two states of the suite.
        let evidence = one.evidence.get(name).filter(|evidence| {
            is_whole(evidence)
                && is_same(&evidence.reference, &reference.reference)
                && !says_nothing(evidence)
                && voices.len() < MOST_VOTERS
        });
        match evidence {
            Some(evidence) => {
                let tolerance = one.run.tolerance;
                voices.push(Voice { tolerance, evidence: Some(evidence) });
                voters.push(id);
            }
            None => unheard.push(id),
        }
    }
    if voices.len() < FEWEST_VOTERS {
        return None;
    }
    let scale = Scale::of(&reference.reference);
    let opinion =
        |i: usize| Opinion::of(voices.len(), |a, b| agree(&voices[a], &voices[b], i, scale));
    let map = (0..reference.edges.len()).map(opinion).collect();
    Some(told(Told { voters, unheard, ..blank(size) }, map, &reference.edges, objects))
}

/// Whether every part is of one size.
fn is_whole(evidence: &Evidence) -> bool {
    let pixels = evidence.reference.pixels().len();
    let sizes = [&evidence.actual, &evidence.low, &evidence.high].map(LinearImage::size);
    sizes == [evidence.reference.size(); 3]
        && [evidence.edges.len(), evidence.off.len()] == [pixels; 2]
}

/// Whether a picture may be of a single color where goldray's is not: nothing was drawn,
/// all of it is clamped, or its codes are too coarse for so dark a scene. It would agree
/// with whoever has that color somewhere, and is heard by no majority.
fn says_nothing(evidence: &Evidence) -> bool {
    /// A picture whose channels are no farther apart than this part of white is of one
    /// color.
    const ONE_COLOR: f64 = 1e-12;
    let channel = |picture: &LinearImage, i: usize| {
        let channels = picture.pixels().iter().map(|pixel| pixel.channels()[i]);
        channels.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), c| {
            (least.min(c), most.max(c))
        })
    };
    let may_be_one = (0..3).all(|i| channel(&evidence.low, i).1 <= channel(&evidence.high, i).0);
    let is_drawn = (0..3).any(|i| {
        let (least, most) = channel(&evidence.reference, i);
        most - least > ONE_COLOR
    });
    let is_number = |pixel: &Rgb| pixel.channels().iter().all(|c| !c.is_nan());
    may_be_one && is_drawn && evidence.actual.pixels().iter().all(is_number)
}

/// Whether two pictures have the same bits.
fn is_same(a: &LinearImage, b: &LinearImage) -> bool {
    let bits = |pixel: &Rgb| pixel.channels().map(f64::to_bits);
    a.size() == b.size() && a.pixels().iter().map(bits).eq(b.pixels().iter().map(bits))
}

fn blank(size: Size) -> Told {
    Told {
        voters: Vec::new(),
        unheard: Vec::new(),
        size,
        opinions: BTreeMap::new(),
        regions: Vec::new(),
        untold: (0, 0),
        map: Vec::new(),
    }
}

/// So much of a pixel's brightest channel is rounding, where the values of two codes
/// meet.
const ROUNDING: f64 = 1e-12;

/// Whether two agree in a pixel.
fn agree(a: &Voice<'_>, b: &Voice<'_>, pixel: usize, scale: Scale) -> bool {
    let (a_evidence, b_evidence) = match (a.evidence, b.evidence) {
        (Some(a), Some(b)) => (a, b),
        (None, Some(one)) | (Some(one), None) => return !one.off[pixel],
        (None, None) => return true,
    };
    if !a_evidence.off[pixel] && !b_evidence.off[pixel] {
        return true;
    }
    let channels = |picture: &LinearImage| picture.pixels()[pixel].channels();
    let nominal = [a_evidence, b_evidence].map(|evidence| evidence.actual.pixels()[pixel]);
    let brightest = nominal.map(|pixel| scale.at(pixel)).into_iter().fold(0.0, f64::max);
    let allowed = a.tolerance.max(b.tolerance) * brightest;
    let (a_low, a_high) = (channels(&a_evidence.low), channels(&a_evidence.high));
    let (b_low, b_high) = (channels(&b_evidence.low), channels(&b_evidence.high));
    // What is no number is near nothing, and what is infinite has no neighbors.
    nominal.iter().all(|pixel| pixel.channels().iter().all(|c| c.is_finite()))
        && (0..3).all(|i| {
            let gap = (a_low[i] - b_high[i]).max(b_low[i] - a_high[i]);
            let is_exact = (a_high[i] - a_low[i]).min(b_high[i] - b_low[i]) <= allowed;
            // Two codes beside each other stand for values that end where the others
            // begin: they say that the value is another.
            if is_exact { gap <= allowed } else { gap < -ROUNDING * brightest }
        })
}

/// Counts the opinions and finds their regions.
fn told(
    mut told: Told,
    map: Vec<Opinion>,
    edges: &[bool],
    objects: &dyn Fn() -> Option<Objects>,
) -> Told {
    for (opinion, &is_edge) in map.iter().zip(edges) {
        let pixels = told.opinions.entry(*opinion).or_default();
        *if is_edge { &mut pixels.edge } else { &mut pixels.interior } += 1;
    }
    if map.iter().all(|opinion| *opinion == Opinion::Agree) {
        return told;
    }
    let inside: Vec<_> = map
        .iter()
        .zip(edges)
        .map(|(&opinion, &is_edge)| {
            Some(opinion).filter(|opinion| !is_edge && *opinion != Opinion::Agree)
        })
        .collect();
    let width = told.size.width as usize;
    let mut found = areas(&inside, width);
    // Stable: equals stay in the order of their first pixels.
    found.sort_by_key(|area| std::cmp::Reverse(area.pixels.len()));
    let beyond = found.split_off(found.len().min(MOST_REGIONS));
    told.untold = (beyond.len() as u64, beyond.iter().map(|area| area.pixels.len() as u64).sum());
    let objects = if found.is_empty() { None } else { objects() };
    let region = |area: regions::Area<Opinion>| {
        let columns = || area.pixels.iter().map(|pixel| (pixel % width) as u32);
        let rows = || area.pixels.iter().map(|pixel| (pixel / width) as u32);
        Region {
            opinion: area.value,
            pixels: area.pixels.len() as u64,
            from: (columns().min().unwrap_or(0), rows().min().unwrap_or(0)),
            to: (columns().max().unwrap_or(0), rows().max().unwrap_or(0)),
            on: objects.as_ref().and_then(|objects| objects.most(area.pixels.iter().copied())),
        }
    };
    told.regions = found.into_iter().map(region).collect();
    told.map = map;
    told
}

#[cfg(test)]
mod tests;
