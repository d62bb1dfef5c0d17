//! `Opinion`: who agrees with whom in one pixel.

use std::fmt;

/// The most renderers that are heard about one scene.
pub const MOST_VOTERS: usize = 8;

/// A set of voters by number, of at most [`MOST_VOTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Voters(u8);

impl Voters {
    /// Nobody.
    pub const NONE: Self = Self(0);

    /// The first `count` of them.
    pub fn first(count: usize) -> Self {
        Self(((1_u32 << count.min(MOST_VOTERS)) - 1) as u8)
    }

    /// These together with voter `i`.
    #[must_use]
    pub fn with(self, i: usize) -> Self {
        Self(self.0 | 1 << i)
    }

    /// Whether voter `i` is one of them.
    pub fn has(self, i: usize) -> bool {
        self.0 >> i & 1 == 1
    }

    /// How many there are.
    pub fn count(self) -> u32 {
        self.0.count_ones()
    }

    /// Their numbers, in order.
    pub fn numbers(self) -> impl Iterator<Item = usize> {
        (0..MOST_VOTERS).filter(move |&i| self.has(i))
    }

    /// The one, if there is no other.
    pub fn only(self) -> Option<usize> {
        (self.count() == 1).then(|| self.0.trailing_zeros() as usize)
    }

    fn is_within(self, others: Self) -> bool {
        self.0 & !others.0 == 0
    }

    fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }
}

/// What the voters say of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Opinion {
    /// Any two of them agree.
    Agree,
    /// More than half agree with each other; these do not agree with all of them.
    Against(Voters),
    /// Two halves, each of one mind, the one of the first voter first.
    Halves(Voters, Voters),
    /// No two agree.
    AllDiffer,
    /// None of these: no majority, or two that share members.
    Unclear,
}

impl Opinion {
    /// The opinion of `count` voters, where `agrees(a, b)` says whether two agree,
    /// `a < b`. Agreement need not carry over: of three, the middle one may agree
    /// with both others that do not agree with each other, and then nobody is odd.
    ///
    /// One voter or none agrees with itself. Only the first [`MOST_VOTERS`] are
    /// heard.
    pub fn of(count: usize, agrees: impl Fn(usize, usize) -> bool) -> Self {
        let count = count.min(MOST_VOTERS);
        let mut friends = [Voters::NONE; MOST_VOTERS];
        for a in 0..count {
            friends[a] = friends[a].with(a);
            for b in a + 1..count {
                if agrees(a, b) {
                    friends[a] = friends[a].with(b);
                    friends[b] = friends[b].with(a);
                }
            }
        }
        let friends = &friends[..count];
        let all = Voters::first(count);
        if friends.iter().all(|&of_one| of_one == all) {
            return Self::Agree;
        }
        if friends.iter().all(|of_one| of_one.count() == 1) {
            return Self::AllDiffer;
        }
        let largest = largest_groups(friends, all);
        match largest[..] {
            [group] if 2 * group.count() > all.count() => Self::Against(all.without(group)),
            [a, b] if a.without(b) == a && a.count() + b.count() == all.count() => {
                if a.has(0) {
                    Self::Halves(a, b)
                } else {
                    Self::Halves(b, a)
                }
            }
            _ => Self::Unclear,
        }
    }

    /// In words, by the names of the voters.
    pub fn words(self, names: &[impl AsRef<str>]) -> String {
        let list = |voters: Voters| {
            let named = voters.numbers().filter_map(|i| names.get(i)).map(AsRef::as_ref);
            join(&named.collect::<Vec<_>>())
        };
        match self {
            Self::Agree => "all agree".to_owned(),
            Self::Against(odd) if odd.count() == 1 => format!("{} stands alone", list(odd)),
            Self::Against(odd) => format!("{} are against the majority", list(odd)),
            Self::Halves(a, b) => {
                let counts = Counted(a.count());
                format!("{counts} against {counts}: {} against {}", list(a), list(b))
            }
            Self::AllDiffer => "all differ".to_owned(),
            Self::Unclear => "there is no majority".to_owned(),
        }
    }

    /// Its name in JSON.
    pub fn id(self) -> &'static str {
        match self {
            Self::Agree => "agree",
            Self::Against(_) => "against",
            Self::Halves(..) => "halves",
            Self::AllDiffer => "all_differ",
            Self::Unclear => "unclear",
        }
    }

    /// Whom the majority, if there is one, does not agree with.
    pub fn dissenters(self) -> Voters {
        if let Self::Against(odd) = self { odd } else { Voters::NONE }
    }
}

/// The largest sets of voters of whom any two agree, each once.
fn largest_groups(friends: &[Voters], all: Voters) -> Vec<Voters> {
    let mut best: Vec<Voters> = Vec::new();
    for bits in 1..=all.0 {
        let group = Voters(bits);
        let least = best.first().map_or(1, |known| known.count());
        if group.count() < least || !group.is_within(all) {
            continue;
        }
        if group.numbers().all(|i| group.is_within(friends[i])) {
            if group.count() > least {
                best.clear();
            }
            best.push(group);
        }
    }
    best
}

/// "a", "a and b", "a, b and c".
pub(super) fn join(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// A small number as a word.
struct Counted(u32);

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const WORDS: [&str; 9] =
            ["none", "one", "two", "three", "four", "five", "six", "seven", "eight"];
        match WORDS.get(self.0 as usize) {
            Some(word) => f.write_str(word),
            None => write!(f, "{}", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What voters say whose values are these, and agree where they are at most 1 apart.
    #[track_caller]
    fn check(values: &[f64], expected: &str) {
        let opinion = Opinion::of(values.len(), |a, b| (values[a] - values[b]).abs() <= 1.0);
        let names = ["a", "b", "c", "d", "e", "f"];
        assert_eq!(opinion.words(&names), expected, "{values:?}");
    }

    #[test]
    fn the_odd_one_out_is_found() {
        check(&[], "all agree");
        check(&[f64::NAN], "all agree");
        check(&[0.0, 0.0, f64::NAN], "c stands alone");
        check(&[f64::NAN, f64::NAN, f64::NAN], "all differ");
        check(&[0.0, 5.0], "all differ");
        check(&[0.0, 1.0], "all agree");
        check(&[0.0, 5.0, 0.0], "b stands alone");
        check(&[9.0, 5.0, 5.0, 5.0], "a stands alone");
        check(&[0.0, 5.0, 0.0, 9.0, 0.0], "b and d are against the majority");
        check(&[0.0, 5.0, 10.0], "all differ");
        check(&[0.0, 5.0, 5.0, 0.0], "two against two: a and d against b and c");
        check(
            &[5.0, 0.0, 0.0, 5.0, 5.0, 0.0],
            "three against three: a, d and e against b, c and f",
        );
    }

    #[test]
    fn without_a_majority_nobody_is_odd() {
        check(&[0.0, 0.0, 5.0, 9.0], "there is no majority");
        check(&[0.0, 0.0, 5.0, 5.0, 9.0], "there is no majority");
        // b agrees with both, a and c do not agree.
        check(&[0.0, 1.0, 2.0], "there is no majority");
        check(&[0.0, 1.0, 2.0, 1.0], "there is no majority");
        // d agrees with one of the majority only.
        check(&[0.0, 0.0, 1.0, 2.0, 0.0], "d stands alone");
    }

    #[test]
    fn the_most_voters_are_heard_in_no_time() {
        let odd = Opinion::of(MOST_VOTERS, |a, b| a != 3 && b != 3);
        assert_eq!(odd, Opinion::Against(Voters::NONE.with(3)));
        assert_eq!(odd.dissenters().only(), Some(3));
        assert_eq!(Opinion::of(99, |_, _| true), Opinion::Agree);
        assert_eq!(Voters::first(99).count(), 8);
    }
}
