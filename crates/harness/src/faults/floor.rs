//! The floor: how many fixtures notice each fault, committed, so that a suite
//! cannot come to notice less without anybody saying so.
//!
//! The table is `golden/faults.txt`: a line for each fault, `name killed golden
//! paper`; `#` starts a comment.

use std::collections::BTreeMap;
use std::fmt;

use super::matrix::{Matrix, Row};
use super::trial::Evidence;
use crate::store::{self, StoreError};
use crate::suite::Suite;

/// Where the table is, relative to the suite.
pub const FLOOR: &str = "golden/faults.txt";

/// The largest table that is read, in bytes.
const MAX_BYTES: u64 = 1 << 20;

/// The fewest fixtures that have to notice a fault: one may be edited away.
const FEWEST: u32 = 2;

const HEAD: &str = "\
# How many fixtures notice each seeded fault: in all, by their golden, by what is known on paper.
# Held against by .ci/run; written by: cargo xtask faults --write
";

/// How many fixtures notice a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Kills {
    /// In any way.
    pub all: u32,
    /// By their golden.
    pub golden: u32,
    /// By an expectation or a relation.
    pub paper: u32,
}

/// Kills by the name of the fault.
pub type Floor = BTreeMap<String, Kills>;

impl Matrix {
    /// How many fixtures notice each fault.
    pub fn kills(&self) -> Floor {
        let of = |row: &Row| {
            let count = |has: fn(&Evidence) -> bool| {
                row.kills().filter(|(_, evidence)| has(evidence)).count() as u32
            };
            Kills {
                all: count(|_| true),
                golden: count(|evidence| evidence.golden),
                paper: count(|evidence| evidence.on_paper > 0),
            }
        };
        self.rows.iter().map(|row| (row.fault.name(), of(row))).collect()
    }
}

/// One way in which a suite notices less than it should, or than is written down.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fall {
    /// Too few fixtures notice this fault, whatever the table says.
    TooFew {
        /// The fault.
        fault: String,
        /// Who does.
        found: Kills,
    },
    /// Other fixtures notice it than did: fewer, or more, so that the table would
    /// let some of them go blind.
    Changed {
        /// The fault.
        fault: String,
        /// What the table says.
        expected: Kills,
        /// Who does.
        found: Kills,
    },
    /// A fault without a line.
    Missing {
        /// The fault.
        fault: String,
    },
    /// A line without a fault.
    Surplus {
        /// The name in the line.
        fault: String,
    },
}

impl fmt::Display for Kills {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { all, golden, paper } = self;
        write!(f, "{all} fixtures ({golden} by their golden, {paper} on paper)")
    }
}

impl fmt::Display for Fall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { fault, found } => write!(
                f,
                "{fault}: expected at least {FEWEST} fixtures to notice it, one of them on paper, \
                 found {found}"
            ),
            Self::Changed { fault, expected, found } => {
                write!(f, "{fault}: expected {expected} as {FLOOR} says, found {found}")
            }
            Self::Missing { fault } => {
                write!(f, "{fault}: expected a line in {FLOOR}, found none")
            }
            Self::Surplus { fault } => {
                write!(f, "{fault}: expected a fault, as {FLOOR} has a line for it, found none")
            }
        }
    }
}

/// All ways in which a whole suite notices less than it should, or anything else
/// than the table says, by name of the fault.
pub fn falls(floor: &Floor, today: &Floor) -> Vec<Fall> {
    let gone = floor.keys().filter(|fault| !today.contains_key(*fault));
    let mut all: Vec<_> = gone.map(|fault| Fall::Surplus { fault: fault.clone() }).collect();
    for (fault, &found) in today {
        let fault = fault.clone();
        if found.all < FEWEST || found.paper == 0 {
            all.push(Fall::TooFew { fault: fault.clone(), found });
        }
        match floor.get(&fault) {
            None => all.push(Fall::Missing { fault }),
            Some(&expected) if found != expected => {
                all.push(Fall::Changed { fault, expected, found });
            }
            Some(_) => {}
        }
    }
    all
}

/// The suite's table; `None` where it has none.
///
/// # Errors
/// A file that cannot be read or is no such table, with the line.
pub fn read_floor(suite: &Suite) -> Result<Option<Floor>, StoreError> {
    let path = suite.root().join(FLOOR);
    let Some(bytes) = store::read(&path, MAX_BYTES)? else { return Ok(None) };
    let text = String::from_utf8(bytes).map_err(|_| "expected UTF-8 text".to_owned());
    let floor = text.and_then(|text| parse(&text));
    floor.map(Some).map_err(|what| StoreError { path, what })
}

/// Writes the suite's table.
///
/// # Errors
/// A file that cannot be written.
pub fn write_floor(suite: &Suite, floor: &Floor) -> Result<(), StoreError> {
    let line = |(fault, kills): (&String, &Kills)| {
        let Kills { all, golden, paper } = kills;
        format!("{fault} {all} {golden} {paper}\n")
    };
    let lines: String = floor.iter().map(line).collect();
    store::write(&suite.root().join(FLOOR), (HEAD.to_owned() + &lines).as_bytes())
}

fn parse(text: &str) -> Result<Floor, String> {
    let mut floor = Floor::new();
    for (i, line) in text.lines().enumerate() {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let words: Vec<_> = line.split(' ').collect();
        let counts = words.get(1..).unwrap_or_default().iter().map(|word| word.parse().ok());
        let counts = counts.collect::<Option<Vec<_>>>();
        let Some(&[all, golden, paper]) = counts.as_deref() else {
            let expected = "the name of a fault and three counts";
            return Err(format!("line {}: expected {expected}, found \"{line}\"", i + 1));
        };
        if floor.insert(words[0].to_owned(), Kills { all, golden, paper }).is_some() {
            return Err(format!("line {}: expected each fault once, found it again", i + 1));
        }
    }
    Ok(floor)
}

#[cfg(test)]
mod tests {
    use tracer::fault::Fault;

    use super::super::matrix::tests::trial;
    use super::*;

    fn floor(lines: &[(&str, [u32; 3])]) -> Floor {
        let kills = |[all, golden, paper]: [u32; 3]| Kills { all, golden, paper };
        lines.iter().map(|&(name, counts)| (name.to_owned(), kills(counts))).collect()
    }

    #[track_caller]
    fn check(was: [u32; 3], is: [u32; 3], expected: &[&str]) {
        let found = falls(&floor(&[("a", was)]), &floor(&[("a", is)]));
        let words: Vec<_> = found.iter().map(Fall::to_string).collect();
        assert_eq!(words.len(), expected.len(), "{words:?}");
        for (words, expected) in words.iter().zip(expected) {
            assert!(words.contains(expected), "{words}");
        }
    }

    #[test]
    fn no_count_may_change() {
        check([5, 4, 2], [5, 4, 2], &[]);
        check([5, 4, 2], [6, 6, 3], &["found 6 fixtures"]);
        check([5, 4, 2], [4, 4, 2], &["expected 5 fixtures"]);
        check([5, 4, 2], [5, 3, 2], &["found 5 fixtures (3 by their golden, 2 on paper)"]);
        check([5, 4, 2], [5, 4, 1], &["found 5"]);
    }

    #[test]
    fn two_must_notice_one_of_them_on_paper() {
        check([2, 2, 1], [2, 2, 1], &[]);
        check([1, 1, 1], [1, 1, 1], &["at least 2"]);
        check([9, 9, 0], [9, 9, 0], &["one of them on paper"]);
    }

    #[test]
    fn lines_and_faults_belong_together() {
        let found = falls(&floor(&[("gone", [3, 3, 3])]), &floor(&[("a", [3, 3, 3])]));
        let surplus = Fall::Surplus { fault: "gone".to_owned() };
        assert_eq!(found, [surplus, Fall::Missing { fault: "a".to_owned() }]);
    }

    #[test]
    fn fixtures_are_counted_by_their_evidence() {
        let trials = vec![trial("a", 5, 0), trial("b", 0, 2), trial("c", 1, 1), trial("d", 0, 0)];
        let matrix = Matrix { rows: vec![Row { fault: Fault::GammaTwice, trials }] };
        assert_eq!(matrix.kills(), floor(&[("gamma-twice", [3, 2, 2])]));
    }

    #[test]
    fn a_table_comes_back_and_others_are_refused() {
        assert_eq!(parse("# x\n\na 3 2 1\n"), Ok(floor(&[("a", [3, 2, 1])])));
        for bad in ["a", "a 1 2", "a 1 2 3 4", "a 1 2 -3", "a 1  2 3", "a 1 2 3\na 1 2 3"] {
            assert!(parse(bad).unwrap_err().starts_with("line "), "{bad}");
        }
    }
}
