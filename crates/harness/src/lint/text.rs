//! Findings for people and for machines.

use serde_json::{Value, json};

use super::{Finding, MATCHES, RULES};
use crate::suite::Suite;

/// A finding as one line: `fixtures/a.ron:3: rule: what | what to do`.
pub fn finding_line(finding: &Finding, path_prefix: &str) -> String {
    let Finding { fixture, rule, line, message, help } = finding;
    let label = Suite::fixture_label(fixture);
    format!("{path_prefix}{label}:{line}: {rule}: {message} | {help}")
}

/// A line for each rule: what it asks, and how often it does not hold.
pub fn rule_lines(findings: &[Finding]) -> String {
    let line =
        |name: &str, asks: &str| format!("{:<18} {:>4}  {asks}\n", name, count(findings, name));
    let matches = line(MATCHES, MATCHES_ASKS);
    RULES.iter().map(|rule| line(rule.name, rule.asks)).chain([matches]).collect()
}

/// What [`MATCHES`] asks.
const MATCHES_ASKS: &str = "the fixture is a match: of one that is not, nothing else is asked";

/// `{"schema":1,"rules":[...],"findings":[...]}`.
///
/// A rule has `name`, `asks` and `findings`, their count; a finding has
/// `fixture`, `file`, `line`, `rule`, `message` and `help`. The rule `matches`
/// is of fixtures that no other can be asked of.
pub fn findings_json(findings: &[Finding]) -> Value {
    let rule = |name: &str, asks: &str| json!({ "name": name, "asks": asks, "findings": count(findings, name) });
    let matches = rule(MATCHES, MATCHES_ASKS);
    let rules = RULES.iter().map(|r| rule(r.name, r.asks)).chain([matches]);
    let findings = findings.iter().map(|f| {
        json!({
            "fixture": f.fixture,
            "file": Suite::fixture_label(&f.fixture),
            "line": f.line,
            "rule": f.rule,
            "message": f.message,
            "help": f.help,
        })
    });
    json!({
        "schema": 1,
        "rules": rules.collect::<Vec<_>>(),
        "findings": findings.collect::<Vec<_>>(),
    })
}

fn count(findings: &[Finding], rule: &str) -> usize {
    findings.iter().filter(|finding| finding.rule == rule).count()
}
