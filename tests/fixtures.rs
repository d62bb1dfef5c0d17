//! The suite seen through `cargo test`: one named test for each fixture and
//! each golden without one, on the same path as `cargo xtask check`.
#![allow(clippy::expect_used)]

use std::process::ExitCode;

use conformance::repository_suite;
use harness::report::numbers;
use harness::run::judge_fixture;
use harness::verdict::Verdict;
use libtest_mimic::{Arguments, Failed, Trial};

fn main() -> ExitCode {
    let suite = repository_suite();
    let selection = suite.select(&[]).expect("the suite can be listed");
    let mut trials = vec![Trial::test("the_suite_has_at_least_48_fixtures", {
        let count = selection.fixtures.len();
        move || {
            if count >= 48 { Ok(()) } else { Err(format!("found {count}").into()) }
        }
    })];
    for name in selection.fixtures {
        let suite = suite.clone();
        trials.push(Trial::test(name.clone(), move || {
            let judgment = judge_fixture(&suite, &name).judgment;
            if judgment.verdict == Verdict::Match {
                return Ok(());
            }
            let mut why = vec![judgment.verdict.words()];
            why.extend(judgment.findings);
            why.extend(judgment.comparison.as_ref().map(numbers));
            why.push(format!("look: cargo xtask check {name}"));
            Err(Failed::from(why.join("\n")))
        }));
    }
    for name in selection.orphans {
        let why = format!("golden/{name}.png has no fixture: cargo xtask bless --prune {name}");
        trials.push(Trial::test(name, move || Err(why.into())));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}
