//! `Progress`: a bar on a terminal, one line of plain text elsewhere.

use indicatif::{ProgressBar, ProgressStyle};

/// Shows how far a run is, on standard error.
pub(crate) struct Progress(ProgressBar);

impl Progress {
    /// Starts counting to `total`; `doing` is "checking" or the like.
    pub(crate) fn start(doing: &'static str, total: usize) -> Self {
        let bar = ProgressBar::new(total as u64);
        if bar.is_hidden() {
            let s = if total == 1 { "" } else { "s" };
            eprintln!("{doing} {total} fixture{s}");
        }
        let template = "{prefix} [{bar:40}] {pos}/{len} {wide_msg}";
        let style =
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        bar.set_style(style.progress_chars("=> "));
        bar.set_prefix(doing);
        Self(bar)
    }

    /// Starts counting the cases of a stress run.
    pub(crate) fn of_cases(total: u64) -> Self {
        let bar = ProgressBar::new(total);
        if bar.is_hidden() {
            eprintln!("stressing with {total} cases");
        }
        let template = "stressing [{bar:40}] {percent}% {elapsed}, {eta} to go {wide_msg}";
        let style =
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        bar.set_style(style.progress_chars("=> "));
        Self(bar)
    }

    /// So many are done, the last of them in this.
    pub(crate) fn reach(&self, done: u64, last: &str) {
        self.0.set_message(last.to_owned());
        self.0.set_position(done);
    }

    /// One more is done, the last of them being this.
    pub(crate) fn advance(&self, last: &str) {
        self.0.set_message(last.to_owned());
        self.0.inc(1);
    }

    /// Takes the bar away.
    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}
