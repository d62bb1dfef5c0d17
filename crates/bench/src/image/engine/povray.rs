//! POV-Ray 3.7, by its own program.

use std::fmt;
use std::process::{Command, Stdio};

use super::{Engine, Setting, Shot, Stage};
use crate::files;
use crate::image::picture::from_png16;

/// The file of a scene, its picture and what it says of its time.
pub(crate) const SCENE: &str = "scene.pov";
const PICTURE: &str = "povray.png";
const STATISTICS: &str = "povray.txt";

/// What it is called.
const PROGRAM: &str = "povray";

/// From this many objects on, its tree that cuts space is faster than its boxes,
/// by up to a seventh; below it is slower by as much.
const MANY: usize = 100;

/// How it looks for more samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Antialiasing {
    /// `+AM`: 1 fills pixels that differ from those beside them with a grid, 2
    /// cuts pixels whose corners differ; 0 is none.
    method: u32,
    /// `+R`: the side of the grid, or how often a pixel is halved.
    depth: u32,
    /// `+A`: the difference, of any channel after `+AG`'s gamma.
    threshold: f64,
    /// `+J`: how far samples are moved at random.
    jitter: f64,
}

impl fmt::Display for Antialiasing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.flags().join(" "))
    }
}

impl Antialiasing {
    const NONE: Self = Self { method: 0, depth: 1, threshold: 0.0, jitter: 0.0 };

    fn flags(self) -> Vec<String> {
        let Self { method, depth, threshold, jitter } = self;
        if method == 0 {
            return vec!["-A".into()];
        }
        let jitter = if jitter > 0.0 { format!("+J{jitter}") } else { "-J".into() };
        vec![format!("+AM{method}"), format!("+R{depth}"), format!("+A{threshold:?}"), jitter]
    }
}

/// A POV-Ray that was found.
pub(crate) struct Povray {
    version: String,
}

impl Povray {
    /// The one on the path.
    ///
    /// # Errors
    /// Says how to get it.
    pub(crate) fn find() -> Result<Self, String> {
        let missing = |why: String| {
            format!("{why}; install Debian's `povray` or run `cargo xtask bench peers --install`")
        };
        // It names itself among its complaints.
        let told = Command::new(PROGRAM)
            .arg("--version")
            .output()
            .map_err(|why| missing(format!("the program `{PROGRAM}` cannot be run: {why}")))?;
        let told = [told.stdout, told.stderr].concat();
        let told = String::from_utf8_lossy(&told);
        let version = told.split_whitespace().skip_while(|word| *word != "POV-Ray").nth(1);
        let version = version.ok_or_else(|| {
            missing(format!("expected `{PROGRAM} --version` to tell its version, found \"{told}\""))
        })?;
        Ok(Self { version: version.into() })
    }
}

impl Engine for Povray {
    fn name(&self) -> &'static str {
        "povray"
    }

    fn version(&self) -> String {
        self.version.clone()
    }

    fn ladders(&self) -> Vec<Vec<Setting>> {
        let ladder = |method, threshold, jitter: f64, depths: &[u32]| {
            let all = depths
                .iter()
                .map(|&depth| Setting::Povray(Antialiasing { method, depth, threshold, jitter }));
            all.collect::<Vec<_>>()
        };
        let mut ladders = vec![vec![Setting::Povray(Antialiasing::NONE)]];
        // What turns out best comes first: then the others are soon left.
        for threshold in [0.3, 0.1, 0.03, 0.01, 0.003] {
            ladders.push(ladder(2, threshold, 0.0, &[1, 2, 3, 4, 5, 6, 7, 9]));
        }
        for threshold in [0.3, 0.1, 0.03, 0.01, 0.0] {
            ladders.push(ladder(1, threshold, 0.0, &[2, 3, 5, 9]));
        }
        ladders.push(ladder(1, 0.03, 1.0, &[3, 5, 9]));
        ladders
    }

    fn shoot(&mut self, stage: &Stage, setting: Setting) -> Result<Shot, String> {
        let Setting::Povray(antialiasing) = setting else {
            return Err(format!("POV-Ray has no setting \"{setting}\""));
        };
        let size = stage.size();
        let status = Command::new(PROGRAM)
            .current_dir(&stage.folder)
            .args([format!("+I{SCENE}"), format!("+O{PICTURE}"), format!("+GS{STATISTICS}")])
            .args([format!("+W{}", size.width), format!("+H{}", size.height)])
            // 16 bits, linear, one thread, no window, nothing on the terminal.
            .args(["+FN16", "File_Gamma=1.0", "+WT1", "-D", "-V", "-GA", "+MB1"])
            .arg(if stage.read.file.objects.len() < MANY { "+BM1" } else { "+BM2" })
            .args(antialiasing.flags())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status();
        let file = stage.folder.join(SCENE);
        let failed = |why: String| format!("POV-Ray on {}, {setting}: {why}", file.display());
        let status = status.map_err(|why| failed(why.to_string()))?;
        if !status.success() {
            return Err(failed(format!("it ended with {status}; run it by hand to see why")));
        }
        let told = files::read(&stage.folder.join(STATISTICS))?;
        let seconds = trace_seconds(&String::from_utf8_lossy(&told)).map_err(failed)?;
        let bytes = files::read(&stage.folder.join(PICTURE))?;
        Ok(Shot { seconds, picture: from_png16(&bytes, size).map_err(failed)? })
    }
}

/// The CPU seconds of tracing in POV-Ray's statistics.
fn trace_seconds(told: &str) -> Result<f64, String> {
    let mut lines = told.lines().skip_while(|line| !line.trim().starts_with("Trace Time:")).skip(1);
    let line = lines.next().unwrap_or("").trim();
    let mut words = line.split_whitespace().skip_while(|word| *word != "with");
    match (words.nth(1).map(str::parse), words.next()) {
        (Some(Ok(seconds)), Some("CPU-seconds")) => Ok(seconds),
        _ => Err(format!("expected CPU-seconds after `Trace Time`, found \"{line}\"")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_of_tracing_is_found() {
        let told = "  Parse Time: 0 hours\n using 1 thread(s) with 7.000 CPU-seconds total\n  \
                    Trace Time:       0 hours  0 minutes  0 seconds (0.112 seconds)\n              \
                    using 1 thread(s) with 0.109 CPU-seconds total\n";
        assert_eq!(trace_seconds(told), Ok(0.109));
        assert!(trace_seconds("  Trace Time: long\n").unwrap_err().contains("found \"\""));
        assert!(
            trace_seconds("Trace Time:\n with no CPU-seconds").unwrap_err().contains("with no")
        );
    }

    #[test]
    fn settings_are_its_flags() {
        let jitter = Antialiasing { method: 2, depth: 3, threshold: 0.03, jitter: 0.5 };
        assert_eq!(jitter.to_string(), "+AM2 +R3 +A0.03 +J0.5");
        assert_eq!(Antialiasing { jitter: 0.0, ..jitter }.to_string(), "+AM2 +R3 +A0.03 -J");
        assert_eq!(Antialiasing::NONE.to_string(), "-A");
    }
}
