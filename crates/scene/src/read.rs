//! `read`: any text in the notation of scenes, with all problems of its form at
//! once.

use serde::de::DeserializeOwned;

use crate::Problem;
use crate::diagnose::{diagnose, ron_options};

/// What is written in a text, in the notation of scene files.
///
/// It is for the other files of a suite: what their values mean is the caller's
/// to judge, who finds the place of one by [`span_of`](crate::span_of).
///
/// # Errors
/// Every problem of its form, by place.
///
/// ```
/// use std::collections::BTreeMap;
/// let lengths = scene::read::<BTreeMap<String, f64>>(r#"{"a": 1, "b": 2.5}"#).unwrap();
/// assert_eq!(lengths["b"], 2.5);
/// let problems = scene::read::<BTreeMap<String, f64>>(r#"{"a": x, "b": y}"#).unwrap_err();
/// assert_eq!(problems.len(), 2);
/// ```
pub fn read<T: DeserializeOwned>(text: &str) -> Result<T, Vec<Problem>> {
    match ron_options().from_str(text) {
        Ok(value) => Ok(value),
        Err(_) => Err(diagnose::<T>(text).problems),
    }
}
