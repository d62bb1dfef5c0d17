//! `Digest`: the bits of a fixture's picture as two short texts, and the
//! committed table of them that every target must reproduce.
//!
//! A golden has 8 bits a channel and so is blind to the last bits of the
//! linear picture, which are what another compiler, processor or level of
//! optimization would change. The table is `golden/digests.txt`: a line for
//! each fixture, sorted, `name linear encoded`; `#` starts a comment.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use rayon::prelude::*;
use tracer::{LinearImage, Size};

use crate::encode::EncodedImage;
use crate::expectation::Rendered;
use crate::run::render_fixture;
use crate::store::{self, StoreError};
use crate::suite::Suite;

/// The bits of a picture, before and after encoding. Two pictures have the
/// same only if they have the same size and bits.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Digest {
    /// Of the linear picture: BLAKE3 of its width and height as `u32` and then
    /// all channels as the bits of `f64`, row-major from the top, red first;
    /// everything little-endian. The first 128 bits in hexadecimal.
    pub linear: String,
    /// The same of the encoded picture, whose channels are bytes.
    pub encoded: String,
}

/// Digests by the name of their fixture.
pub type Table = BTreeMap<String, Digest>;

/// Where the table is, relative to the suite.
pub const TABLE: &str = "golden/digests.txt";

/// The largest table that is read, in bytes: far above 10,000 fixtures.
const MAX_TABLE_BYTES: u64 = 1 << 24;

/// Hexadecimal letters of a digest: 128 bits tell any two pictures apart.
const LETTERS: usize = 32;

/// The comment at the head of the table.
const HEAD: &str = "\
# The bits of every fixture's picture: name, linear, encoded (crates/harness/src/digest.rs).
# Held against by cargo test and .ci/digests; written by: cargo xtask digest --write
";

impl Digest {
    /// The digest of a picture.
    pub fn of(picture: &Rendered) -> Self {
        Self { linear: of_linear(&picture.linear), encoded: of_encoded(&picture.encoded) }
    }
}

fn of_linear(picture: &LinearImage) -> String {
    let channels = picture.pixels().iter().flat_map(|pixel| pixel.channels());
    hex(picture.size(), &channels.flat_map(|c| c.to_bits().to_le_bytes()).collect::<Vec<_>>())
}

/// The digest of a picture of 8 bits a channel.
pub(crate) fn of_encoded(picture: &EncodedImage) -> String {
    hex(picture.size(), picture.bytes())
}

fn hex(Size { width, height }: Size, bytes: &[u8]) -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(&width.to_le_bytes()).update(&height.to_le_bytes()).update(bytes);
    let mut hex = hasher.finalize().to_hex().to_string();
    hex.truncate(LETTERS);
    hex
}

/// Today's digest of each of these fixtures, in the order of the names, or why
/// it has no picture. `on_each` hears of each as it is known, from any thread.
pub fn of_fixtures(
    suite: &Suite,
    names: &[String],
    on_each: &(dyn Fn(&str) + Sync),
) -> Vec<(String, Result<Digest, String>)> {
    let of_one = |name: &String| {
        let digest = render_fixture(suite, name).map(|(_, picture)| Digest::of(&picture));
        on_each(name);
        (name.clone(), digest)
    };
    names.par_iter().map(of_one).collect()
}

/// The suite's table; `None` where it has none.
///
/// # Errors
/// A file that cannot be read or is no such table, with the line.
pub fn read_table(suite: &Suite) -> Result<Option<Table>, StoreError> {
    let path = suite.root().join(TABLE);
    let Some(bytes) = store::read(&path, MAX_TABLE_BYTES)? else { return Ok(None) };
    let table = String::from_utf8(bytes).map_err(|_| "expected UTF-8 text".to_owned());
    let table = table.and_then(|text| parse(&text));
    table.map(Some).map_err(|what| StoreError { path, what })
}

/// Writes the suite's table.
///
/// # Errors
/// A file that cannot be written.
pub fn write_table(suite: &Suite, table: &Table) -> Result<(), StoreError> {
    store::write(&suite.root().join(TABLE), to_text(table).as_bytes())
}

/// The line of the table for one fixture.
pub fn line(name: &str, Digest { linear, encoded }: &Digest) -> String {
    format!("{name} {linear} {encoded}")
}

fn to_text(table: &Table) -> String {
    let lines = table.iter().map(|(name, digest)| line(name, digest) + "\n");
    HEAD.to_owned() + &lines.collect::<String>()
}

fn parse(text: &str) -> Result<Table, String> {
    let mut table = Table::new();
    for (i, whole) in text.lines().enumerate() {
        if whole.is_empty() || whole.starts_with('#') {
            continue;
        }
        // From the end: a fixture's name may have spaces in it.
        let mut words = whole.rsplitn(3, ' ');
        let mut digest = || words.next().filter(|word| is_digest(word)).map(str::to_owned);
        let (encoded, linear) = (digest(), digest());
        let (Some(name), Some(linear), Some(encoded)) = (words.next(), linear, encoded) else {
            let expected = format!("a name and two digests of {LETTERS} letters from 0 to f");
            return Err(format!("line {}: expected {expected}, found \"{whole}\"", i + 1));
        };
        if table.insert(name.to_owned(), Digest { linear, encoded }).is_some() {
            return Err(format!("line {}: expected each name once, found {name} again", i + 1));
        }
    }
    Ok(table)
}

fn is_digest(word: &str) -> bool {
    word.len() == LETTERS && word.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b))
}

/// One way in which a table is not what it should be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Difference {
    /// A fixture without a line.
    Missing {
        /// The fixture.
        name: String,
    },
    /// A line without a fixture.
    Surplus {
        /// The name in the line.
        name: String,
    },
    /// Other bits than the table's.
    Bits {
        /// The fixture.
        name: String,
        /// `"linear"` or `"encoded"`.
        picture: &'static str,
        /// The table's digest.
        expected: String,
        /// Today's digest.
        found: String,
    },
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { name } => write!(f, "{name}: expected a line in {TABLE}, found none"),
            Self::Surplus { name } => {
                write!(f, "{name}: expected a fixture, as {TABLE} has a line for it, found none")
            }
            Self::Bits { name, picture, expected, found } => {
                write!(f, "{name}: expected the {picture} picture {expected}, found {found}")
            }
        }
    }
}

/// All differences between the table and `today`, sorted by name. `fixtures`
/// are the names of the whole suite, of which `today` may be a part.
pub fn differences(table: &Table, fixtures: &[String], today: &Table) -> Vec<Difference> {
    let known: BTreeSet<_> = fixtures.iter().collect();
    let mut all = Vec::new();
    for name in table.keys().filter(|name| !known.contains(name)) {
        all.push((name, Difference::Surplus { name: name.clone() }));
    }
    for (name, today) in today {
        let Some(expected) = table.get(name) else {
            all.push((name, Difference::Missing { name: name.clone() }));
            continue;
        };
        let pairs = [
            ("linear", &expected.linear, &today.linear),
            ("encoded", &expected.encoded, &today.encoded),
        ];
        for (picture, expected, found) in pairs.into_iter().filter(|(_, a, b)| a != b) {
            let (expected, found) = (expected.clone(), found.clone());
            all.push((name, Difference::Bits { name: name.clone(), picture, expected, found }));
        }
    }
    all.sort_by_key(|(name, _)| *name);
    all.into_iter().map(|(_, difference)| difference).collect()
}

#[cfg(test)]
mod tests;
