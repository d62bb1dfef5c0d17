//! `Instructions`: a level of instructions that can be asked for by name.

use super::Level;

/// A set of instructions that this processor has; see
/// [`Build::With`](crate::accel::Build::With).
///
/// No picture depends on it. It is there so that this can be shown: who wants
/// a picture soon leaves the choice to the tracer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Instructions(Level);

impl Instructions {
    /// All that this processor has and this build was compiled for, the best
    /// last. Plain arrays are among them where there is no other level, and
    /// where debug assertions are on.
    pub fn all() -> Vec<Self> {
        Level::all().into_iter().map(Self).collect()
    }

    /// `"portable"`, `"sse2"` or `"avx2"`.
    pub fn name(self) -> &'static str {
        match self.0 {
            #[cfg(any(test, debug_assertions, not(target_arch = "x86_64")))]
            Level::Portable => "portable",
            #[cfg(target_arch = "x86_64")]
            Level::Sse(_) => "sse2",
            #[cfg(target_arch = "x86_64")]
            Level::Avx2(_) => "avx2",
        }
    }

    pub(crate) fn level(self) -> Level {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::Build;

    #[test]
    fn the_best_comes_last_and_is_what_is_used() {
        let all = Instructions::all();
        assert_eq!(all.last().map(|last| last.level()), Some(Level::best()));
        assert_eq!(all[0].name(), "portable");
        for instructions in all {
            assert_eq!(Build::With(instructions).level(), instructions.level());
        }
        assert_eq!(Build::Bvh.level(), Level::best());
    }
}
