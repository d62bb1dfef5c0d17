//! What the outcomes are called, where people and machines read them.

use crate::Outcome;

/// All outcomes, the best first.
pub const ALL: [Outcome; 8] = [
    Outcome::Pass,
    Outcome::Fail,
    Outcome::WrongSize,
    Outcome::BadPicture,
    Outcome::NoPicture,
    Outcome::Crashed,
    Outcome::TimedOut,
    Outcome::Unsupported,
];

/// Its name in JSON.
pub fn id(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Pass => "pass",
        Outcome::Fail => "fail",
        Outcome::WrongSize => "wrong_size",
        Outcome::BadPicture => "bad_picture",
        Outcome::NoPicture => "no_picture",
        Outcome::Crashed => "crashed",
        Outcome::TimedOut => "timed_out",
        Outcome::Unsupported => "unsupported",
    }
}

/// Its name for people.
pub fn words(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Pass => "pass",
        Outcome::Fail => "fail",
        Outcome::WrongSize => "wrong size",
        Outcome::BadPicture => "bad picture",
        Outcome::NoPicture => "no picture",
        Outcome::Crashed => "crashed",
        Outcome::TimedOut => "timed out",
        Outcome::Unsupported => "unsupported",
    }
}

/// Whether the renderer was asked and did not give the right picture.
pub fn is_failure(outcome: Outcome) -> bool {
    !matches!(outcome, Outcome::Pass | Outcome::Unsupported)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_is_called_what_a_run_calls_it() {
        for outcome in ALL {
            let written = serde_json::to_value(outcome).unwrap();
            assert_eq!(written, id(outcome));
            assert_eq!(words(outcome), id(outcome).replace('_', " "));
        }
        let distinct: std::collections::BTreeSet<_> = ALL.into_iter().collect();
        assert_eq!(distinct.len(), ALL.len());
    }
}
