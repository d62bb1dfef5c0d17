//! Which names a command's filters select: the same rule for fixtures and for
//! everything else that has names.

use std::collections::BTreeSet;

use wildmatch::WildMatch;

/// Why filters select nothing.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FilterError {
    /// A filter that is about nothing.
    #[error("the filter \"{filter}\" selects nothing{hint}")]
    SelectsNothing {
        /// The filter.
        filter: String,
        /// What to do, after a semicolon.
        hint: String,
    },
    /// A filter that would select everything by accident.
    #[error("an empty filter selects nothing: leave it out to select everything")]
    Empty,
}

/// The names that any of the filters selects; none if there are no filters.
///
/// A filter selects exactly its name if there is one; with `*` or `?` in it,
/// the names it matches as a whole; else all names that contain it.
/// `list_command` is what shows all names.
///
/// # Errors
/// An empty filter, and one that selects nothing.
pub fn select(
    names: &BTreeSet<String>,
    filters: &[&str],
    list_command: &str,
) -> Result<BTreeSet<String>, FilterError> {
    let mut selected = BTreeSet::new();
    for &filter in filters {
        if filter.is_empty() {
            return Err(FilterError::Empty);
        }
        if let Some(exact) = names.get(filter) {
            selected.insert(exact.clone());
            continue;
        }
        let matching: Vec<_> = names.iter().filter(|name| selects(filter, name)).collect();
        if matching.is_empty() {
            let nearest = scene::nearest(filter, names.iter().map(String::as_str));
            let hint = nearest.map_or(format!("; `{list_command}` shows all names"), |name| {
                format!("; did you mean \"{name}\"?")
            });
            return Err(FilterError::SelectsNothing { filter: filter.to_owned(), hint });
        }
        selected.extend(matching.into_iter().cloned());
    }
    Ok(selected)
}

fn selects(filter: &str, name: &str) -> bool {
    if filter.contains(['*', '?']) {
        WildMatch::new(filter).matches(name)
    } else {
        name.contains(filter)
    }
}
