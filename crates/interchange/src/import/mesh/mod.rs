//! What the readers of mesh files have in common: words of text files, triangles
//! that become OBJ files, and the scene around them.

pub(super) mod names;
pub(super) mod part;
pub(super) mod pictures;
pub(super) mod shot;
pub(super) mod stage;
pub(super) mod tally;
pub(super) mod words;

use super::Unreadable;
use words::Place;

/// A reason why there is no scene, at a place of the file.
pub(super) fn unreadable(place: Place, message: impl Into<String>) -> Unreadable {
    Unreadable { place: Some(place), message: message.into(), help: None }
}

/// One without a place.
pub(super) fn unreadable_at_all(message: impl Into<String>) -> Unreadable {
    Unreadable { place: None, message: message.into(), help: None }
}
