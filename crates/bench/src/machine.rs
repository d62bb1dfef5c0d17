//! `Machine`: what the figures of a run hold for.

use std::path::Path;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

use serde::{Deserialize, Serialize};

use crate::place;

/// The machine, the versions and the day.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Machine {
    /// The processor's name.
    pub(crate) cpu: String,
    /// How many threads it runs at once.
    pub(crate) threads: usize,
    /// The levels of instructions that a program can choose among.
    pub(crate) levels: Vec<String>,
    /// The system.
    pub(crate) system: String,
    /// The compiler.
    pub(crate) rustc: String,
    /// The commit that was measured, marked with `+` if files differ from it.
    pub(crate) commit: String,
    /// The day, as `2026-11-25`.
    pub(crate) date: String,
    /// How many programs wanted the processor when the run began, on average
    /// over a minute.
    pub(crate) load: Option<f64>,
}

impl Machine {
    /// This one, today.
    pub(crate) fn here() -> Self {
        let line = |path: &str, key: &str| {
            let text = place::text(Path::new(path)).ok().flatten()?;
            let line = text.lines().find(|line| line.starts_with(key))?.to_owned();
            Some(line.split([':', '=']).next_back()?.trim().trim_matches('"').to_owned())
        };
        let load = || place::text(Path::new("/proc/loadavg")).ok().flatten();
        let unknown = || "unknown".to_owned();
        let commit = said("git", &["rev-parse", "--short", "HEAD"]);
        let differs = said("git", &["status", "--porcelain", "--untracked-files=no"]);
        Self {
            cpu: line("/proc/cpuinfo", "model name").unwrap_or_else(unknown),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            levels: levels(),
            system: line("/etc/os-release", "PRETTY_NAME").unwrap_or_else(unknown),
            rustc: rustc(),
            commit: commit.map_or_else(unknown, |commit| {
                format!("{commit}{}", if differs.is_some_and(|d| !d.is_empty()) { "+" } else { "" })
            }),
            date: date(SystemTime::now()),
            load: load().and_then(|text| text.split_whitespace().next()?.parse().ok()),
        }
    }

    /// In one paragraph.
    pub(crate) fn sentence(&self) -> String {
        let load = self.load.map_or_else(String::new, |load| format!(", load {load}"));
        format!(
            "{}, {} threads ({}), {}, {}, commit {}, {}{load}",
            self.cpu,
            self.threads,
            self.levels.join(", "),
            self.system,
            self.rustc,
            self.commit,
            self.date
        )
    }
}

/// The compiler of this folder, as it names itself.
pub(crate) fn rustc() -> String {
    said("rustc", &["--version"]).unwrap_or_else(|| "rustc, version unknown".to_owned())
}

/// The levels of instructions that the program can choose among while it runs.
pub(crate) fn levels() -> Vec<String> {
    #[cfg(target_arch = "x86_64")]
    let found = [
        ("sse4.2", std::is_x86_feature_detected!("sse4.2")),
        ("avx2", std::is_x86_feature_detected!("avx2")),
        ("fma", std::is_x86_feature_detected!("fma")),
        ("avx512f", std::is_x86_feature_detected!("avx512f")),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let found = [(std::env::consts::ARCH, true)];
    found.into_iter().filter(|(_, has)| *has).map(|(name, _)| name.to_owned()).collect()
}

/// What a program prints, if it can be run and succeeds.
fn said(program: &str, args: &[&str]) -> Option<String> {
    let output = Command::new(program).args(args).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

/// The day of a time, in UTC.
///
/// Source: Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms",
/// `civil_from_days`, whose years begin in March.
fn date(time: SystemTime) -> String {
    const SECONDS_A_DAY: u64 = 86_400;
    /// Days of 400 years, of 100 and of 4, and of a year.
    const ERA: u64 = 146_097;
    const CENTURY: u64 = 36_524;
    const FOUR_YEARS: u64 = 1_460;
    const YEAR: u64 = 365;
    /// Days from the start of the year 0 to that of 1970.
    const TO_1970: u64 = 719_468;
    let days = time.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs()) / SECONDS_A_DAY;
    let z = days + TO_1970;
    let (era, doe) = (z / ERA, z % ERA);
    let yoe = (doe - doe / FOUR_YEARS + doe / CENTURY - doe / (ERA - 1)) / YEAR;
    let doy = doe - (YEAR * yoe + yoe / 4 - yoe / 100);
    let mp = (5 * doy + 2) / 153;
    let day = doy - (153 * mp + 2) / 5 + 1;
    let month = if mp < 10 { mp + 3 } else { mp - 9 };
    let year = yoe + era * 400 + u64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn days_have_their_dates() {
        let date = |days: u64| date(UNIX_EPOCH + Duration::from_secs(days * 86_400 + 3));
        assert_eq!(date(0), "1970-01-01");
        assert_eq!(date(59), "1970-03-01");
        assert_eq!(date(89), "1970-03-31");
        assert_eq!(date(364), "1970-12-31");
        assert_eq!(date(11_016), "2000-02-29");
        assert_eq!(date(11_017), "2000-03-01");
        assert_eq!(date(20_782), "2026-11-25");
    }

    #[test]
    fn the_machine_comes_back_from_json() {
        let here = Machine::here();
        let text = serde_json::to_string(&here).unwrap();
        assert_eq!(serde_json::from_str::<Machine>(&text).unwrap(), here);
        assert!(here.sentence().contains(&here.cpu));
    }
}
