//! `markdown`: a scorecard as a page of Markdown.

use std::fmt::Write as _;

use harness::report::{markdown_code as code, markdown_text as prose};
use harness::suite::Suite;

use super::{Answered, Card, Cell, Column, Row, Standing, Suspicion, Tally};
use crate::consensus::{FEWEST_VOTERS, GOLDRAY, Opinion, Share, Told};
use crate::result::held_to;
use crate::{Outcome, outcome};

/// So many failures of a renderer have a row.
const MOST_ROWS: usize = 200;

/// So many regions of a fixture are told.
const MOST_REGIONS: usize = 5;

/// The card in words. Whatever a renderer or a fixture says is shown as it is written:
/// nothing of it is taken for Markdown or HTML.
pub fn markdown(card: &Card) -> String {
    let mut page = "# Scorecard\n\n".to_owned();
    if card.is_empty() {
        return page + "No renderer was asked for a picture.\n";
    }
    if let Some(selection) = &card.selection {
        // Writing to a String cannot fail.
        let _ = write!(page, "{}.\n\n", prose(&selection.words()));
    }
    page += &renderers(card);
    page += &features(card);
    for (i, column) in card.renderers.iter().enumerate() {
        page += &failures(card, i, column);
    }
    page + &consensus(card)
}

/// An error as people read it.
pub(crate) fn error(error: f64) -> String {
    // Two digits.
    let short: f64 = format!("{error:.1e}").parse().unwrap_or(error);
    if short == 0.0 || short.abs() >= 1e-2 { short.to_string() } else { format!("{short:e}") }
}

/// So many of something, by its words for one and for others.
pub(crate) fn counted(count: u64, one: &str, others: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { others })
}

fn renderers(card: &Card) -> String {
    let mut table =
        "| renderer | version | pass | the others | tolerance | worst interior error | edge \
                     pixels that differ |\n|---|---|---|---|---|---|---|\n"
            .to_owned();
    for Column { info, tolerance, edge_reach, tally } in &card.renderers {
        let version = info.version.lines().next().unwrap_or_default();
        // Writing to a String cannot fail.
        let _ = writeln!(
            table,
            "| {} | {} | {} of {} | {} | {} | {} | {} |",
            prose(&info.name),
            prose(version),
            tally.passed(),
            tally.total(),
            tally.rest_words(),
            held_to(*tolerance, *edge_reach),
            worst(tally),
            edges(tally),
        );
    }
    for Column { info, tally, .. } in &card.renderers {
        if tally.passed() == 0 && tally.count(Outcome::Fail) > 0 {
            let _ = writeln!(
                table,
                "\nNo picture of {} is right: what is wrong may be common to all, such as the transfer \
                 curve, the order of rows or where samples are taken.",
                prose(&info.name)
            );
        }
    }
    table
}

fn worst(tally: &Tally) -> String {
    tally.worst.as_ref().map_or(String::new(), |worst| {
        let at = worst.at.map_or(String::new(), |(x, y)| format!(" ({x}, {y})"));
        match worst.error {
            0.0 => error(worst.error),
            _ => format!("{} in {}{at}", error(worst.error), code(&worst.fixture)),
        }
    })
}

fn edges(tally: &Tally) -> String {
    format!("{} of {}", tally.edge_off, tally.edge_pixels)
}

fn features(card: &Card) -> String {
    let mut text =
        "\n## Features\n\nIn each cell: what the run says of the feature, and how many of the \
                    fixtures that ask for it pass, where any was rendered.\n"
            .to_owned();
    let mut family = "";
    for row in &card.rows {
        if row.feature.family() != family {
            family = row.feature.family();
            let names = card.renderers.iter().map(|column| prose(&column.info.name));
            let _ = write!(
                text,
                "\n| {family} | {} |\n|---|{}\n",
                names.collect::<Vec<_>>().join(" | "),
                "---|".repeat(card.renderers.len())
            );
        }
        text += &feature(row);
    }
    text += "\n";
    for standing in Standing::ALL {
        let _ = writeln!(text, "- **{}**: {}", standing.words(), standing.meaning());
    }
    if !card.unasked.is_empty() {
        let names: Vec<_> = card.unasked.iter().map(|feature| feature.name()).collect();
        let _ = writeln!(text, "\nNo fixture asks for: {}.", names.join(", "));
    }
    text
}

fn feature(Row { feature, cells }: &Row) -> String {
    let cell = |Cell { standing, tally }: &Cell| match standing {
        Standing::NotAsked | Standing::Unsupported => standing.words().to_owned(),
        _ => format!("{} {}/{}", standing.words(), tally.passed(), tally.total()),
    };
    let cells: Vec<_> = cells.iter().map(cell).collect();
    format!("| {feature} | {} |\n", cells.join(" | "))
}

fn failures(card: &Card, i: usize, column: &Column) -> String {
    let answers = card
        .fixtures
        .iter()
        .filter_map(|(name, entry)| Some((name, entry.results.get(i)?.as_ref()?)));
    let failing: Vec<_> =
        answers.filter(|(_, answered)| outcome::is_failure(answered.result.outcome)).collect();
    if failing.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\n## What fails with {}\n\n| fixture | outcome | why | what it may be |\n|---|---|---|---|\n",
        prose(&column.info.name)
    );
    for (name, answered) in failing.iter().take(MOST_ROWS) {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            code(name),
            outcome::words(answered.result.outcome),
            why(name, answered),
            prose(&answered.suspicion.as_ref().map_or(String::new(), suspicion))
        );
    }
    let more = failing.len().saturating_sub(MOST_ROWS);
    if more > 0 {
        let _ = writeln!(text, "\n{more} more are in `scorecard.json`.");
    }
    text
}

fn why(name: &str, answered: &Answered) -> String {
    let mut reasons: Vec<_> = answered.result.findings.iter().map(|f| prose(f)).collect();
    if let Some(numbers) = answered.result.numbers.filter(|numbers| numbers.interior_off > 0) {
        let at = numbers.worst_at.map_or(String::new(), |(x, y)| format!(" at ({x}, {y})"));
        let on = answered.worst_on.as_ref();
        let on = on.map(|on| format!(", on {}", on.words(&Suite::fixture_label(name))));
        let off = format!(
            "{} off, the worst by {}{at}{}",
            counted(numbers.interior_off, "interior pixel is", "interior pixels are"),
            error(numbers.worst_interior),
            on.unwrap_or_default()
        );
        reasons.push(prose(&off));
    }
    reasons.join("<br>")
}

/// What a failure may be put down to, in words.
pub(crate) fn suspicion(suspicion: &Suspicion) -> String {
    if !suspicion.features.is_empty() {
        let names: Vec<_> = suspicion.features.iter().map(|feature| feature.name()).collect();
        return names.join(" or ");
    }
    if !suspicion.pairs.is_empty() {
        let names: Vec<_> = suspicion.pairs.iter().map(|(a, b)| format!("{a} with {b}")).collect();
        return names.join(" or ");
    }
    "all that it asks for passes elsewhere, also in pairs".to_owned()
}

fn consensus(card: &Card) -> String {
    let sum = &card.consensus;
    let mut text = "\n## Consensus\n\n".to_owned();
    if sum.fixtures == 0 {
        let _ = writeln!(
            text,
            "No scene has pictures of {FEWEST_VOTERS} renderers or more, goldray's own included: nobody can be \
             the odd one out."
        );
        return text;
    }
    let _ = writeln!(
        text,
        "Of {} that {FEWEST_VOTERS} renderers or more have a picture of, goldray included, all \
         agree in every interior pixel of {}. In {} there is no majority.\n\n\
         | renderer | scenes | stands alone, interior pixels | in scenes | edge pixels | against the \
         majority with others |\n|---|---|---|---|---|---|",
        counted(sum.fixtures, "scene", "scenes"),
        sum.agreed,
        counted(sum.undecided, "interior pixel", "interior pixels")
    );
    for id in std::iter::once(GOLDRAY).chain(card.ids().filter(|id| *id != GOLDRAY)) {
        let Some(share) = sum.voters.get(id) else { continue };
        let Share { heard, alone, with_others, alone_in } = share;
        let _ = writeln!(
            text,
            "| {} | {heard} | {} | {} | {} | {} |",
            prose(card.name(id)),
            alone.interior,
            alone_in.len(),
            alone.edge,
            with_others.interior
        );
    }
    text += "\n";
    for (name, entry) in &card.fixtures {
        for line in entry.told.iter().flat_map(|told| sentences(name, told, &card.names(told))) {
            let _ = writeln!(text, "- {}", prose(&line));
        }
    }
    text
}

/// What is said of a fixture by these voters' names, a sentence for each opinion of its interior pixels: "a
/// stands alone in 412 px of shadow/x, in 3 regions, the largest (40 px) at (10, 20)..(40, 60), on
/// the Torus of fixtures/shadow/x.ron:10:9".
pub fn sentences(name: &str, told: &Told, voters: &[&str]) -> Vec<String> {
    let mut opinions: Vec<_> = told
        .opinions
        .iter()
        .filter(|(opinion, pixels)| **opinion != Opinion::Agree && pixels.interior > 0)
        .collect();
    opinions.sort_by_key(|(_, pixels)| std::cmp::Reverse(pixels.interior));
    let sentence = |(opinion, pixels): (&Opinion, &crate::consensus::Pixels)| {
        let regions: Vec<_> = told.regions.iter().filter(|r| r.opinion == *opinion).collect();
        let mut line = format!("{} in {} px of {name}", opinion.words(voters), pixels.interior);
        let Some(largest) = regions.first() else { return line };
        let ((left, top), (right, bottom)) = (largest.from, largest.to);
        // Regions are told largest first, so all of a small number are there.
        let count = match (regions.len(), told.untold.0) {
            (1, 0) => "in one region".to_owned(),
            (n, 0) => format!("in {n} regions, the largest of {} px", largest.pixels),
            (1, _) => format!("in one region or more, the largest of {} px", largest.pixels),
            (n, _) => format!("in {n} regions or more, the largest of {} px", largest.pixels),
        };
        let _ = write!(line, ", {count} at ({left}, {top})..({right}, {bottom})");
        if let Some((seen, _)) = &largest.on {
            let _ = write!(line, ", on {}", seen.words(&Suite::fixture_label(name)));
        }
        line
    };
    let more = opinions.len().saturating_sub(MOST_REGIONS);
    let mut lines: Vec<_> = opinions.into_iter().take(MOST_REGIONS).map(sentence).collect();
    if more > 0 {
        lines.push(format!("{more} other opinions about {name} are in scorecard.json"));
    }
    lines
}
