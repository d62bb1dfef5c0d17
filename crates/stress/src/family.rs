//! `Family`: one cell of the stress matrix, a kind of case for one primitive
//! with the kernels that answer it and what they are held to.

use crate::{Case, Metric, Random, Tally};

/// How many cases a family runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Volume {
    /// In a run of everything in under a minute.
    pub quick: u64,
    /// With `--full`.
    pub full: u64,
}

/// One way of answering the cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kernel {
    /// Its name in the table.
    pub name: &'static str,
    /// Whether it is held to the targets; textbook kernels are only shown.
    pub contract: bool,
}

impl Kernel {
    /// What renders.
    pub const GOLDRAY: Self = Self { name: "goldray", contract: true };

    /// A formula that is shown beside it.
    pub const fn textbook(name: &'static str) -> Self {
        Self { name, contract: false }
    }
}

/// Makes a case.
pub type Generate = Box<dyn Fn(&mut Random) -> Case + Send + Sync>;

/// Puts a case to every kernel and adds to the tally of each, in the order of
/// [`Family::kernels`].
pub type Judge = Box<dyn Fn(&Case, &mut [Tally]) + Send + Sync>;

/// A kind of case for one primitive.
pub struct Family {
    /// The primitive's name.
    pub primitive: &'static str,
    /// The name of this kind of case, among the primitive's.
    pub name: String,
    /// Who answers.
    pub kernels: Vec<Kernel>,
    /// What is measured, and the largest value that passes; `None` is shown
    /// only.
    pub targets: Vec<(Metric, Option<f64>)>,
    /// How many cases.
    pub volume: Volume,
    /// Makes a case from random numbers.
    pub generate: Generate,
    /// Judges a case.
    pub judge: Judge,
}

impl Family {
    /// `primitive/family`, which filters match and seeds come from.
    pub fn label(&self) -> String {
        format!("{}/{}", self.primitive, self.name)
    }

    /// What is measured, and that few cases are ties.
    pub fn all_targets(&self) -> Vec<(Metric, Option<f64>)> {
        /// In a million, for families that do not say: what falls next to an
        /// edge by chance.
        const TIES_PPM: f64 = 1000.0;
        let mut all = self.targets.clone();
        if !all.iter().any(|(metric, _)| *metric == Metric::Ties) {
            all.push((Metric::Ties, Some(TIES_PPM)));
        }
        all
    }

    /// The family, held to at most `most` of this metric.
    #[must_use]
    pub fn held_to(mut self, metric: Metric, most: f64) -> Self {
        self.targets.retain(|(other, _)| *other != metric);
        self.targets.push((metric, Some(most)));
        self
    }

    /// The family, which is made so close to the edge that up to this many
    /// cases in a million are ties.
    #[must_use]
    pub fn with_ties(self, ppm: f64) -> Self {
        self.held_to(Metric::Ties, ppm)
    }

    /// An empty tally for each kernel.
    pub fn tallies(&self) -> Vec<Tally> {
        self.kernels.iter().map(|kernel| Tally::new(&self.targets, kernel.contract)).collect()
    }

    /// The tallies of this case alone.
    pub fn judge_alone(&self, case: &Case) -> Vec<Tally> {
        let mut tallies = self.tallies();
        (self.judge)(case, &mut tallies);
        tallies
    }

    /// Whether a kernel under contract misses a target on this case alone.
    pub fn offends(&self, case: &Case) -> bool {
        crate::tally::take_offense(&mut self.judge_alone(case))
    }
}
