//! The kill matrix for people, and for machines.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::floor::Kills;
use super::matrix::{Matrix, Row, Status};
use super::trial::{Evidence, Fate, Trial};

/// The version of the JSON document.
const SCHEMA: u32 = 1;

/// A line for each fault, then all that is not as it should be, then the sums.
pub fn text(matrix: &Matrix) -> String {
    let mut text = format!(
        "{:<29} {:>7} {:>7} {:>7} {:>7}  {:<46} {}\n",
        "fault", "reached", "killed", "golden", "paper", "strongest", "weakest"
    );
    let kills = matrix.kills();
    for row in &matrix.rows {
        let counts = kills.get(&row.fault.name()).copied().unwrap_or_default();
        let [strongest, weakest] = row
            .strongest_and_weakest()
            .map_or([String::new(), String::new()], |ends| ends.map(evidence));
        let line = format!(
            "{:<29} {:>7} {:>7} {:>7} {:>7}  {strongest:<46} {weakest}",
            row.fault.name(),
            row.reached(),
            counts.all,
            counts.golden,
            counts.paper,
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    for (status, title) in [
        (Status::Survived, "survived: made, and noticed by no fixture"),
        (Status::NotApplied, "not applied: no fixture needs the place"),
        (Status::Crashed, "crashed: no picture wherever it was made"),
    ] {
        let rows: Vec<_> = matrix.rows.iter().filter(|row| row.status() == status).collect();
        if !rows.is_empty() {
            let _ = writeln!(text, "\n{title}");
        }
        for row in rows {
            let _ = writeln!(text, "  {}: {}{}", row.fault.name(), row.fault.words(), reason(row));
        }
    }
    let count = |status| matrix.rows.iter().filter(|row| row.status() == status).count();
    let _ = writeln!(
        text,
        "\n{} faults: {} killed, {} survived, {} not applied, {} crashed",
        matrix.rows.len(),
        count(Status::Killed),
        count(Status::Survived),
        count(Status::NotApplied),
        count(Status::Crashed)
    );
    text
}

/// The matrix as a page: what each fault does, and how many fixtures notice it.
pub fn markdown(matrix: &Matrix) -> String {
    let fixtures = matrix.rows.iter().map(|row| row.trials.len()).max().unwrap_or(0);
    let mut page = format!(
        "# What the suite notices\n\n{} mistakes that renderers are known to make, each seeded into \
         the tracer alone, against {fixtures} fixtures. *Needed by*: fixtures whose picture asks the \
         place where the mistake is made. *Noticed by*: those that fail, of them by their golden, \
         and by an expectation or a relation, which need none. *Weakest*: the failing fixture whose \
         picture is nearest to its golden; \"on paper\" where it is its golden, and only an \
         expectation or relation fails.\n\nWritten by `cargo xtask faults --markdown docs/faults.md`; \
         [trust.md](trust.md#seeded-faults) says how.\n\n\
         | mistake | needed by | noticed by | golden | on paper | weakest |\n\
         |---|--:|--:|--:|--:|---|\n",
        matrix.rows.len()
    );
    let kills = matrix.kills();
    for row in &matrix.rows {
        let counts = kills.get(&row.fault.name()).copied().unwrap_or_default();
        let weakest = row.strongest_and_weakest().map_or(String::new(), |[_, end]| evidence(end));
        let (needed, words) = (row.reached(), row.fault.words());
        let Kills { all, golden, paper } = counts;
        let _ = writeln!(
            page,
            "| `{}`: {words} | {needed} | {all} | {golden} | {paper} | {weakest} |",
            row.fault.name()
        );
    }
    page
}

/// A fixture and how far its picture is off.
fn evidence((fixture, evidence): (&str, &Evidence)) -> String {
    match evidence.differing_pixels {
        0 => format!("{fixture} (on paper)"),
        n => format!("{fixture} ({n} px, {}/255)", evidence.max_abs),
    }
}

/// Why there was no picture, if there was none.
fn reason(row: &Row) -> String {
    let first = row.trials.iter().find_map(|trial| match &trial.fate {
        Fate::Refused(why) | Fate::Crashed(why) => Some(format!(" {}: {why}", trial.fixture)),
        Fate::Survived | Fate::Killed(_) => None,
    });
    first.unwrap_or_default()
}

/// `{"schema":1,"faults":[{"name","what","status","reached","killed_by",
/// "by_golden","on_paper","without_picture","evidence"}]}`: `killed_by` are the
/// names of the fixtures that fail, `by_golden` and `on_paper` those among them
/// whose golden and whose expectations or relations say so, `without_picture`
/// those that had none, and `evidence` has the fixture that is farthest off as
/// `strongest` and the one that is nearest as `weakest`, null without kills.
pub fn json(matrix: &Matrix) -> Value {
    let faults: Vec<_> = matrix.rows.iter().map(row_json).collect();
    json!({ "schema": SCHEMA, "faults": faults })
}

fn row_json(row: &Row) -> Value {
    let names = |has: fn(&Evidence) -> bool| -> Vec<_> {
        row.kills().filter(|(_, evidence)| has(evidence)).map(|(name, _)| name).collect()
    };
    let has_none = |trial: &&Trial| matches!(trial.fate, Fate::Refused(_) | Fate::Crashed(_));
    let without: Vec<_> = row.trials.iter().filter(has_none).map(|trial| &trial.fixture).collect();
    let ends = row.strongest_and_weakest().map(|[strongest, weakest]| {
        json!({ "strongest": evidence_json(strongest), "weakest": evidence_json(weakest) })
    });
    json!({
        "name": row.fault.name(),
        "what": row.fault.words(),
        "status": row.status().id(),
        "reached": row.reached(),
        "killed_by": names(|_| true),
        "by_golden": names(|evidence| evidence.golden),
        "on_paper": names(|evidence| evidence.on_paper > 0),
        "without_picture": without,
        "evidence": ends,
    })
}

fn evidence_json((fixture, evidence): (&str, &Evidence)) -> Value {
    json!({
        "fixture": fixture,
        "differing_pixels": evidence.differing_pixels,
        "max_abs": evidence.max_abs,
        "ssim_min": evidence.ssim_min,
        "on_paper": evidence.on_paper,
    })
}

#[cfg(test)]
mod tests {
    use tracer::fault::Fault;

    use super::super::matrix::tests::trial;
    use super::*;

    fn matrix() -> Matrix {
        let row = |fault, trials| Row { fault, trials };
        let refused = Trial { fate: Fate::Refused("no eye".into()), ..trial("c", 0, 0) };
        let unreached = Trial { reached: false, ..trial("a", 0, 0) };
        let rows = vec![
            row(Fault::GammaTwice, vec![trial("a", 7, 0), trial("b", 2, 1), trial("c", 0, 0)]),
            row(Fault::SampleLost, vec![trial("a", 0, 0)]),
            row(Fault::FovNotHalved, vec![refused]),
            row(Fault::TileLost, vec![unreached]),
        ];
        Matrix { rows }
    }

    #[test]
    fn every_fault_has_a_line_and_those_that_get_by_are_named() {
        let text = text(&matrix());
        let line = text.lines().nth(1).unwrap();
        assert!(line.starts_with("gamma-twice"), "{line}");
        assert!(line.ends_with("b (2 px, 0/255)") && line.contains("a (7 px, 0/255)"), "{line}");
        for words in [
            "by no fixture\n  sample-lost: A pixel's last sample is lost.\n",
            "not applied: no fixture needs the place\n  tile-lost",
            "field of view is not halved. c: no eye",
            "4 faults: 1 killed, 1 survived, 1 not applied, 1 crashed\n",
        ] {
            assert!(text.contains(words), "{words}\n{text}");
        }
    }

    #[test]
    fn the_page_has_a_row_for_each() {
        let page = markdown(&matrix());
        let row =
            "| `gamma-twice`: The curve is applied twice. | 3 | 2 | 2 | 1 | b (2 px, 0/255) |";
        assert!(page.contains(row), "{page}");
        assert!(page.contains("| `tile-lost`") && page.contains("4 mistakes"), "{page}");
        assert!(page.contains("against 3 fixtures"), "{page}");
    }

    #[test]
    fn json_has_the_promised_keys() {
        let json = json(&matrix());
        let killed = &json["faults"][0];
        assert_eq!(json["schema"], 1);
        assert_eq!(killed["status"], "killed");
        assert_eq!(killed["killed_by"], json!(["a", "b"]));
        assert_eq!(killed["on_paper"], json!(["b"]));
        assert_eq!(killed["evidence"]["strongest"]["fixture"], "a");
        assert_eq!(json["faults"][2]["without_picture"], json!(["c"]));
        assert!(json["faults"][1]["evidence"].is_null());
    }
}
