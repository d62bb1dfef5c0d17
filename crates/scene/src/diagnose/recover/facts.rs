//! What the runs learned about types.

use std::any::type_name;
use std::collections::HashMap;

/// Facts by the name of a visitor, and of the variant it reads if it is one's.
///
/// serde derives one visitor per type, but gives those of an enum's variants the same name.
#[derive(Debug, Default)]
pub(super) struct Facts {
    types: HashMap<(&'static str, String), Fact>,
}

/// What is known of a type.
#[derive(Debug, Default)]
pub(super) struct Fact {
    /// The fields it cannot do without.
    pub(super) required: Vec<&'static str>,
    /// Whether it refuses names that it does not know.
    pub(super) closed: bool,
    /// Whether it refuses fewer values than it asks for.
    pub(super) exact: bool,
}

impl Facts {
    /// What is known of the type that `V` visits, or of its variant.
    pub(super) fn of<V>(&mut self, variant: &str) -> &mut Fact {
        self.types.entry((type_name::<V>(), variant.to_owned())).or_default()
    }
}
