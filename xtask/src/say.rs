//! `Say`: how much is printed of what was judged, and in which colors.

use anstream::{AutoStream, ColorChoice};
use anstyle::{AnsiColor, Style};
use harness::called::command;
use harness::report::{Reader, Summary, brief_line, full_line, outcome_line};
use harness::slow::{SLOW_MS, slowest};
use harness::suite::Suite;
use harness::verdict::{Origin, Outcome, Verdict, shell_word};

/// Flags of what is printed.
#[derive(Debug, clap::Args)]
pub struct Say {
    /// Print failures without where to look and what to do, and the count
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Print a line for every fixture, with its times
    #[arg(short, long)]
    verbose: bool,
    /// Color the verdicts; auto does on a terminal, unless `NO_COLOR` is set
    #[arg(long, value_name = "WHEN", value_enum, default_value = "auto")]
    color: Color,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Color {
    Auto,
    Always,
    Never,
}

const GOOD: Style = AnsiColor::Green.on_default().bold();
const BAD: Style = AnsiColor::Red.on_default().bold();

impl Say {
    /// The text in a style, where there are colors.
    fn painted(&self, text: &str, style: Style) -> String {
        let is_colored = match self.color {
            // Knows terminals and the variables by which people ask for none.
            Color::Auto => AutoStream::choice(&std::io::stdout()) != ColorChoice::Never,
            Color::Always => true,
            Color::Never => false,
        };
        if is_colored { format!("{style}{text}{style:#}") } else { text.to_owned() }
    }

    /// A line for each that is to be seen.
    pub fn outcomes(&self, outcomes: &[Outcome], reader: &Reader) {
        for outcome in outcomes {
            let line = match (outcome.verdict, self.quiet, self.verbose) {
                (_, _, true) => full_line(outcome, reader),
                (Verdict::Match, ..) => continue,
                (_, true, _) => brief_line(outcome, reader),
                (_, false, _) => outcome_line(outcome, reader),
            };
            let words = outcome.verdict.words();
            let (words, rest) = line.split_at(words.len());
            let style = if outcome.verdict == Verdict::Match { GOOD } else { BAD };
            println!("{}{rest}", self.painted(words, style));
        }
    }

    /// Which fixtures were rendered although nothing had changed for them.
    pub fn audited(&self, outcomes: &[Outcome]) {
        const SHOWN: usize = 8;
        let is_audited = |o: &&Outcome| matches!(o.origin, Origin::Audited | Origin::Belied);
        let names: Vec<_> = outcomes.iter().filter(is_audited).map(|o| o.name.as_str()).collect();
        if names.is_empty() || self.quiet {
            return;
        }
        let more = match names.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!(" and {more} more, see --json"),
        };
        println!("audited: {}{more}", names[..names.len().min(SHOWN)].join(", "));
    }

    /// Which fixtures took long, and what their pictures need.
    pub fn slow(&self, suite: &Suite, outcomes: &[Outcome], reader: &Reader) {
        if self.quiet {
            return;
        }
        for slow in slowest(suite, outcomes, SLOW_MS) {
            let seconds = slow.render_ms / 1e3;
            let (flag, word) = (&reader.root_flag, shell_word(&slow.name));
            println!(
                "slow: {} took {seconds:.1} s beside the others: {} | all of it: {}{flag} \
                 render {word} --explain",
                slow.name,
                slow.needs,
                command()
            );
        }
    }

    /// How many of each verdict.
    pub fn summary(&self, summary: &Summary, seconds: f64) {
        let style = if summary.is_green() { GOOD } else { BAD };
        println!("{} ({seconds:.2} s)", self.painted(&summary.to_string(), style));
    }
}
