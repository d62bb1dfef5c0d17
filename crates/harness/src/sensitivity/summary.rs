//! `Summary`: the rows of all fixtures, looked at defect by defect.

use super::{DEFECTS, Defect, Row};

/// What stands out of many rows.
#[derive(Debug, Clone)]
pub struct Summary<'a> {
    /// One for each of [`DEFECTS`].
    pub defects: Vec<OfDefect<'a>>,
    /// The fixture that lets the most pass, and which defect: that whose
    /// smallest caught strength is the most above what people see. The first by
    /// name of several; `None` where no defect has an effect on any.
    pub weakest: Option<(&'a Row, usize)>,
}

/// One defect in all fixtures.
#[derive(Debug, Clone)]
pub struct OfDefect<'a> {
    /// Which.
    pub defect: &'static Defect,
    /// Where it has an effect, the lower one of two in the middle.
    pub median: Option<&'a Row>,
    /// Where the least of it is caught, the first by name of several.
    pub worst: Option<&'a Row>,
    /// In how many fixtures it is never caught.
    pub never: usize,
    /// In how many fixtures it has no effect.
    pub no_effect: usize,
}

/// Sums up.
pub fn summarize(rows: &[Row]) -> Summary<'_> {
    let defects = (0..DEFECTS.len()).map(|i| of_defect(rows, i)).collect();
    let cells = rows.iter().flat_map(|row| (0..row.cells.len()).map(move |i| (row, i)));
    Summary { defects, weakest: most(cells) }
}

impl Row {
    /// The defect that this fixture lets pass the most of, by its number;
    /// `None` where none has an effect.
    pub fn weakest(&self) -> Option<usize> {
        most((0..self.cells.len()).map(|i| (self, i))).map(|(_, i)| i)
    }
}

fn of_defect(rows: &[Row], i: usize) -> OfDefect<'_> {
    let mut sorted: Vec<_> =
        rows.iter().filter_map(|row| Some((row.cells[i].times_visible?, row))).collect();
    // Stable: of equals the first by name comes first.
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let median = (!sorted.is_empty()).then(|| sorted[(sorted.len() - 1) / 2].1);
    OfDefect {
        defect: &DEFECTS[i],
        median,
        worst: most(rows.iter().map(|row| (row, i))).map(|(row, _)| row),
        never: sorted.iter().filter(|(times, _)| times.is_infinite()).count(),
        no_effect: rows.len() - sorted.len(),
    }
}

/// The first of those that let the most pass.
fn most<'a>(cells: impl Iterator<Item = (&'a Row, usize)>) -> Option<(&'a Row, usize)> {
    let mut most = None;
    for (row, i) in cells {
        let Some(times) = row.cells[i].times_visible else { continue };
        if most.is_none_or(|(highest, _)| times > highest) {
            most = Some((times, (row, i)));
        }
    }
    most.map(|(_, found)| found)
}

#[cfg(test)]
mod tests {
    use super::super::{Cell, Place, Smallest};
    use super::*;

    fn row(name: &str, times: &[Option<f64>]) -> Row {
        let cell = |(i, &times_visible): (usize, &Option<f64>)| Cell {
            defect: &DEFECTS[i],
            smallest: match times_visible {
                None => Smallest::NoEffect,
                Some(f64::INFINITY) => Smallest::Never { place: Place::Whole },
                Some(strength) => Smallest::Caught { strength, place: Place::Whole },
            },
            times_visible,
            missed: None,
        };
        let rest = std::iter::repeat_n(&None, DEFECTS.len() - times.len());
        let cells = times.iter().chain(rest).enumerate().map(cell).collect();
        Row { fixture: name.to_owned(), cells }
    }

    #[test]
    fn the_weakest_the_worst_and_the_middle_are_named() {
        let never = Some(f64::INFINITY);
        let rows = [
            row("a", &[Some(1.0), Some(9.0)]),
            row("b", &[Some(3.0), None]),
            row("c", &[never, None]),
            row("d", &[never, Some(0.5)]),
        ];
        let summary = summarize(&rows);
        let (weakest, defect) = summary.weakest.unwrap();
        assert_eq!((weakest.fixture.as_str(), defect), ("c", 0), "the first of two");
        let names = |i: usize| {
            let OfDefect { median, worst, never, no_effect, .. } = &summary.defects[i];
            let name = |row: Option<&Row>| row.map_or(String::new(), |row| row.fixture.clone());
            (name(*median), name(*worst), *never, *no_effect)
        };
        assert_eq!(names(0), ("b".into(), "c".into(), 2, 0));
        assert_eq!(names(1), ("d".into(), "a".into(), 0, 2));
        assert_eq!(names(2), (String::new(), String::new(), 0, 4));
        assert_eq!(rows[0].weakest(), Some(1));
        assert_eq!(row("flat", &[]).weakest(), None);
    }
}
