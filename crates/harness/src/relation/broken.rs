//! `Broken`: how a relation is not held.

use std::fmt;

/// How a relation is not held, in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Broken {
    /// The pictures are not as alike as they must be.
    Differs(String),
    /// Nobody can tell: there is no related picture, or nothing to see in it.
    Undecided(String),
}

impl Broken {
    /// The same in other words.
    pub(super) fn map(self, words: impl FnOnce(String) -> String) -> Self {
        match self {
            Self::Differs(why) => Self::Differs(words(why)),
            Self::Undecided(why) => Self::Undecided(words(why)),
        }
    }

    /// Whether it is known that the pictures differ.
    pub fn differs(&self) -> bool {
        matches!(self, Self::Differs(_))
    }
}

/// Whatever kept a related picture from being made.
impl From<String> for Broken {
    fn from(why: String) -> Self {
        Self::Undecided(why)
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Differs(why) | Self::Undecided(why) => f.write_str(why),
        }
    }
}
