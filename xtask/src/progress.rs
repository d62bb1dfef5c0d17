//! How far a run is, on standard error: a bar on a terminal, lines of plain
//! text elsewhere.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Counts fixtures, or whatever else is done one by one; shared between threads.
pub struct Progress(ProgressBar);

impl Progress {
    /// Starts counting to `total` fixtures; `doing` is "checking" or the like.
    pub fn start(doing: &'static str, total: usize) -> Self {
        Self::of(doing, "fixture", total)
    }

    /// Starts counting to `total` of what is called `thing`.
    pub fn of(doing: &'static str, thing: &str, total: usize) -> Self {
        let bar = bar(total as u64, "{prefix} [{bar:40}] {pos}/{len} {wide_msg}");
        if bar.is_hidden() {
            let s = if total == 1 { "" } else { "s" };
            eprintln!("{doing} {total} {thing}{s}");
        }
        bar.set_prefix(doing);
        Self(bar)
    }

    /// Counts for nobody.
    pub fn silent() -> Self {
        Self(ProgressBar::hidden())
    }

    /// Starts counting to nobody knows where.
    pub fn counting(doing: &'static str) -> Self {
        let bar = bar(0, "{prefix} {pos} {wide_msg}");
        bar.set_prefix(doing);
        Self(bar)
    }

    /// One more is done, the last of them being this.
    pub fn advance(&self, last: &str) {
        self.0.set_message(last.to_owned());
        self.0.inc(1);
    }

    /// Does something that prints, with the bar out of its way.
    pub fn beside<T>(&self, print: impl FnOnce() -> T) -> T {
        self.0.suspend(print)
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }
}

/// Counts the cases of a stress run, which may take hours.
pub struct CaseProgress {
    bar: ProgressBar,
    /// When a line was last printed in place of the bar.
    said: Instant,
}

impl CaseProgress {
    /// How often a line is printed in place of the bar.
    const SAY_EVERY: Duration = Duration::from_secs(30);

    /// Starts at `done` of `total`.
    pub fn start(done: u64, total: u64) -> Self {
        let bar = bar(total, "stressing [{bar:40}] {percent} %, {eta} to go {wide_msg}");
        if bar.is_hidden() {
            eprintln!("stressing with {total} cases");
        }
        bar.set_position(done);
        bar.reset_eta();
        Self { bar, said: Instant::now() }
    }

    /// So many are done, the last of them of this family.
    pub fn reach(&mut self, done: u64, family: &str) {
        self.bar.set_message(family.to_owned());
        self.bar.set_position(done);
        if self.bar.is_hidden() && self.said.elapsed() > Self::SAY_EVERY {
            let total = self.bar.length().unwrap_or(done).max(1);
            eprintln!("{:.1} % of the cases, at {family}", 100.0 * done as f64 / total as f64);
            self.said = Instant::now();
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

fn bar(total: u64, template: &str) -> ProgressBar {
    let bar = ProgressBar::new(total);
    let style =
        ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    bar.set_style(style.progress_chars("=> "));
    bar
}
