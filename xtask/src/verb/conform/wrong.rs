//! What is said of fixtures that goldray does not match itself, and what to do: nobody is
//! judged by them, and nobody is asked.

use std::collections::BTreeSet;
use std::path::Path;

use conform::run::NotItself;
use harness::called::command;
use harness::verdict::shell_word;

/// How fixtures are left out.
#[derive(Debug, Clone, Copy)]
pub(crate) enum LeaveOut<'a> {
    /// By filters, of which there were none or some, behind the renderers' names.
    Filters { renderers: &'a [String], filters: &'a [String] },
    /// By another rubric than this.
    Rubric(&'a Path),
}

/// So many fixtures are named, and so many filters; more are not read.
const SHOWN: usize = 8;

/// All that is said, with the commands last. `names` are all that were asked for, `flag`
/// is what stands before a verb to name this suite.
pub(super) fn words(
    wrong: &[NotItself],
    names: &[String],
    flag: &str,
    leave_out: LeaveOut<'_>,
) -> String {
    let lines = wrong.iter().take(SHOWN).map(|w| format!("  {}: {}\n", w.name, w.why.trim_end()));
    let lines: String = lines.collect();
    let more = match wrong.len().saturating_sub(SHOWN) {
        0 => String::new(),
        more => format!("  and {more} more\n"),
    };
    format!(
        "nobody is judged by fixtures that goldray does not match itself, and {} of {} {} no match, so \
         that nothing was run:\n{lines}{more}{}\n{}",
        wrong.len(),
        names.len(),
        if wrong.len() == 1 { "is" } else { "are" },
        remedy(wrong, flag),
        without(wrong, names, flag, leave_out),
    )
}

/// What settles it.
fn remedy(wrong: &[NotItself], flag: &str) -> String {
    let called = format!("{}{flag}", command());
    let settled: Vec<_> = wrong.iter().filter(|w| w.can_be_blessed).collect();
    if settled.len() < wrong.len() || wrong.len() > SHOWN {
        return format!(
            "`{called} check` says more, `{called} review` shows pictures beside their goldens"
        );
    }
    let names: Vec<_> = settled.iter().map(|w| shell_word(&w.name)).collect();
    let names = names.join(" ");
    format!(
        "look at what `{called} check {names}` leaves; what is right is accepted by: {called} bless {names}"
    )
}

/// How the others are asked for.
fn without(wrong: &[NotItself], names: &[String], flag: &str, how: LeaveOut<'_>) -> String {
    let (renderers, given) = match how {
        LeaveOut::Filters { renderers, filters } => (renderers, filters),
        LeaveOut::Rubric(path) => {
            return format!("or leave them out of {}", path.display());
        }
    };
    let wrong: BTreeSet<_> = wrong.iter().map(|w| w.name.as_str()).collect();
    if wrong.len() == names.len() {
        return "there are no others to ask for".to_owned();
    }
    match others(&wrong, names, !given.is_empty()) {
        Some(others) => {
            let renderers = renderers.iter().map(|one| format!(" --renderer {}", shell_word(one)));
            let renderers: String = renderers.collect();
            let others: Vec<_> = others.iter().map(|one| shell_word(one)).collect();
            let called = command();
            format!("or ask for the others: {called}{flag} conform{renderers} {}", others.join(" "))
        }
        None => "or ask for others by filters that leave them out".to_owned(),
    }
}

/// Filters that select all but what is wrong: whole folders unless only a part of the
/// suite was asked for, else names. `None` where there would be too many of them.
fn others(wrong: &BTreeSet<&str>, names: &[String], is_part: bool) -> Option<BTreeSet<String>> {
    let folder = |name: &str| Some(format!("{}/", name.split_once('/')?.0));
    let filter = |name: &String| {
        folder(name)
            .filter(|folder| !is_part && !wrong.iter().any(|wrong| wrong.starts_with(folder)))
            .map_or_else(|| name.clone(), |folder| format!("{folder}*"))
    };
    let right = names.iter().filter(|name| !wrong.contains(name.as_str()));
    let filters: BTreeSet<_> = right.map(filter).collect();
    (filters.len() <= SHOWN).then_some(filters)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(wrong: &[&str], is_part: bool, expected: Option<&[&str]>) {
        let names = ["a/b", "a/c", "d", "e/f", "e/g"].map(str::to_owned);
        let found = others(&wrong.iter().copied().collect(), &names, is_part);
        let found: Option<Vec<_>> = found.map(|all| all.into_iter().collect());
        assert_eq!(found, expected.map(|all| all.iter().map(|&one| one.to_owned()).collect()));
    }

    #[test]
    fn all_but_what_is_wrong_is_selected() {
        check(&["a/b"], false, Some(&["a/c", "d", "e/*"]));
        check(&["d"], false, Some(&["a/*", "e/*"]));
        check(&["d"], true, Some(&["a/b", "a/c", "e/f", "e/g"]));
        let many: Vec<_> = (0..20).map(|i| format!("a/{i:02}")).collect();
        assert_eq!(others(&["a/00"].into(), &many, false), None, "nineteen names");
    }

    #[test]
    fn what_no_blessing_settles_is_looked_at_only() {
        let wrong = |can_be_blessed| NotItself {
            name: "a".to_owned(),
            why: "so".to_owned(),
            can_be_blessed,
        };
        assert!(remedy(&[wrong(true)], "").ends_with("cargo xtask bless a"));
        assert!(!remedy(&[wrong(true), wrong(false)], "").contains("bless"));
        let names = ["a".to_owned()];
        let rubric = words(&[wrong(true)], &names, "", LeaveOut::Rubric(Path::new("r.ron")));
        assert!(rubric.ends_with("\nor leave them out of r.ron"), "{rubric}");
    }
}
