//! The page about all metrics: what each measures, what it misses, how it rates the corpus.

use std::fmt::Write;

use super::blind_spots::{BLIND_SPOTS, Shown};
use super::{Case, SCALES, corpus};
use crate::metric::{Direction, METRICS};

/// The page `docs/metrics.md`, in Markdown.
pub fn document() -> String {
    let cases = corpus();
    let mut page = format!("{INTRODUCTION}\n");
    metrics(&mut page);
    blind_spots(&mut page);
    ratings(&mut page, &cases);
    not_compared(&mut page, &cases);
    page
}

const INTRODUCTION: &str = "\
# What the metrics see, and what they miss

Written by `cargo xtask list --metrics --markdown`; a test holds it against the code.

A metric judges nothing: without limits a picture must be identical to its golden, and every change
of any code of any pixel is noticed. A fixture that states a limit accepts what its metric does not
see.
";

fn metrics(page: &mut String) {
    page.push_str(
        "## The metrics\n\n\
         A `tight` limit lets one code, one pixel or a hundredth of a score pass; a `loose` one lets\n\
         through what a glance at both pictures finds. The first value of a range is that of\n\
         identical pictures.\n\n\
         | metric | measures | range | unit | better | limits that decide by it | tight | loose |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    for (metric, scale) in METRICS.iter().zip(SCALES) {
        let better = match metric.direction {
            Direction::HigherIsBetter => "higher",
            Direction::LowerIsBetter => "lower",
        };
        let limit = metric.limit.unwrap_or("none, reported only");
        let _ = writeln!(
            page,
            "| `{}` | {} | {} | {} | {better} | {limit} | {} | {} |",
            metric.name, metric.measures, metric.range, metric.unit, scale.tight, scale.loose
        );
    }
}

fn blind_spots(page: &mut String) {
    page.push_str(
        "\n## Blind spots\n\n\
         Each is shown by a pair of the table below. `ssim` does not see the brightness of flat areas,\n\
         which `flip` sees; `flip` does not see what is finer than the eye resolves, which `ssim`\n\
         sees. A fixture may limit both.\n\n\
         | metric | cannot see | shown by |\n|---|---|---|\n",
    );
    for (metric, clause, shown) in BLIND_SPOTS {
        let shown = match shown {
            Shown::Passes(case) => format!("{case}: passes the tight limit"),
            Shown::Alike(one, other) => format!("{one}; {other}: the very same value"),
            Shown::Harsher(case, than) => format!("{case}: large, and not by `{than}`"),
        };
        let _ = writeln!(page, "| `{metric}` | {clause} | {shown} |");
    }
}

fn ratings(page: &mut String, cases: &[Case]) {
    page.push_str(
        "\n## How the metrics rate damage\n\n\
         `Same`: identical, and rated so. `Blind`: damaged, and within the tight limit. `Small`:\n\
         between the two limits. `Large`: beyond the loose one. Most pictures are 64 x 64, large ones\n\
         255 x 255; the formulas that draw them are in `crates/harness/src/metric/corpus/`.\n\n| pair |",
    );
    for metric in METRICS {
        let _ = write!(page, " `{}` |", metric.name);
    }
    let _ = writeln!(page, "\n|---|{}", "---|".repeat(METRICS.len()));
    for case in cases {
        if let Ok(ratings) = case.ratings() {
            let words: Vec<_> = ratings.into_iter().map(super::Rating::word).collect();
            let _ = writeln!(page, "| {} | {} |", case.name, words.join(" | "));
        }
    }
}

fn not_compared(page: &mut String, cases: &[Case]) {
    page.push_str(
        "\n## What is never compared\n\n\
         These are verdicts of their own, and no metric is asked.\n\n| pair | why |\n|---|---|\n",
    );
    for case in cases {
        if let Err(why) = case.ratings() {
            let _ = writeln!(page, "| {} | {why} |", case.name);
        }
    }
}
