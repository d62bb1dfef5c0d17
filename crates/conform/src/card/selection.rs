//! `Selection`: the part of a suite that a card is about.

/// A part of a suite: what some filters select of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Selection {
    /// The filters, as they were given.
    pub filters: Vec<String>,
    /// How many fixtures they select.
    pub fixtures: u64,
    /// How many the suite has.
    pub of: u64,
}

impl Selection {
    /// What filters select, if it is a part and not all: filters that select everything
    /// leave nothing to be said.
    pub fn of(filters: &[String], fixtures: usize, of: usize) -> Option<Self> {
        (fixtures < of).then(|| Self {
            filters: filters.to_vec(),
            fixtures: fixtures as u64,
            of: of as u64,
        })
    }

    /// As the beginning of a page says it, without a full stop.
    pub fn words(&self) -> String {
        let filters: Vec<_> =
            self.filters.iter().map(|one| format!("\"{}\"", scene::visible(one))).collect();
        let (filters, Self { fixtures, of, .. }) = (filters.join(", "), self);
        let s = if self.filters.len() == 1 { "" } else { "s" };
        format!(
            "Only a part of the suite was asked for: {fixtures} of {of} fixtures, by the filter{s} {filters}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_said_and_all_is_not() {
        let of = |filters: &[&str], fixtures| {
            let filters: Vec<_> = filters.iter().map(|&one| one.to_owned()).collect();
            Selection::of(&filters, fixtures, 9).map(|part| part.words())
        };
        assert_eq!(of(&["*"], 9), None);
        let two =
            "Only a part of the suite was asked for: 3 of 9 fixtures, by the filters \"a\", \"b*\"";
        assert_eq!(of(&["a", "b*"], 3).as_deref(), Some(two));
        assert!(of(&["a"], 1).is_some_and(|words| words.ends_with("by the filter \"a\"")));
    }
}
