//! `Group`: a program with all that it starts.

use std::process::{Child, Command, ExitStatus};

/// A running program, which is killed with all that it has started when this
/// goes away.
#[derive(Debug)]
pub struct Group {
    child: Child,
    /// The variable that it passes on to those that it starts, `NAME=value`.
    mark: Option<String>,
    /// Whether its end was heard: its number may then be another one's.
    is_over: bool,
}

/// The name of the variable.
const MARK: &str = "GOLDRAY_RUN";

impl Group {
    /// Starts a program in a group of its own.
    ///
    /// # Errors
    /// It cannot be started.
    pub fn start(command: &mut Command) -> std::io::Result<Self> {
        own_group(command);
        command.spawn().map(|child| Self { child, mark: None, is_over: false })
    }

    /// The same, so that what leaves the group can be found as well.
    ///
    /// # Errors
    /// It cannot be started.
    pub fn marked(command: &mut Command) -> std::io::Result<Self> {
        use std::sync::atomic::{AtomicU64, Ordering};
        static RUNS: AtomicU64 = AtomicU64::new(0);
        let run = RUNS.fetch_add(1, Ordering::Relaxed);
        // No other run of this program has it, nor of another that runs.
        let value = format!("{}-{run}", std::process::id());
        command.env(MARK, &value);
        let mut group = Self::start(command)?;
        group.mark = Some(format!("{MARK}={value}"));
        Ok(group)
    }

    /// The program, to be heard.
    pub fn child(&mut self) -> &mut Child {
        &mut self.child
    }

    /// Whether the program has ended by itself. Until [`Group::wait`] its number is
    /// not another one's.
    ///
    /// # Errors
    /// The system does not tell.
    pub fn has_ended(&mut self) -> std::io::Result<bool> {
        #[cfg(target_os = "linux")]
        {
            use nix::sys::wait::{Id, WaitPidFlag, WaitStatus, waitid};
            let flags = WaitPidFlag::WEXITED | WaitPidFlag::WNOHANG | WaitPidFlag::WNOWAIT;
            match waitid(Id::Pid(self.pid()), flags) {
                Ok(status) => Ok(status != WaitStatus::StillAlive),
                // Somebody has waited for it already.
                Err(nix::Error::ECHILD) => Ok(true),
                Err(nix::Error::EINTR) => Ok(false),
                Err(error) => Err(error.into()),
            }
        }
        #[cfg(not(target_os = "linux"))]
        Ok(self.child.try_wait()?.is_some())
    }

    /// Kills what the program has left in its group, then hears how it ended.
    ///
    /// # Errors
    /// The system does not tell.
    pub fn wait(&mut self) -> std::io::Result<ExitStatus> {
        if !self.is_over {
            self.signal(Signal::Kill);
        }
        let status = self.child.wait()?;
        self.is_over = true;
        Ok(status)
    }

    /// Asks the group to end, and gives it a moment.
    pub fn ask_to_end(&mut self) {
        use std::time::{Duration, Instant};
        const MOMENT: Duration = Duration::from_millis(300);
        const LOOK_EVERY: Duration = Duration::from_millis(5);
        self.signal(Signal::End);
        let asked = Instant::now();
        while asked.elapsed() < MOMENT && matches!(self.has_ended(), Ok(false)) {
            std::thread::sleep(LOOK_EVERY);
        }
    }

    /// Kills the program, its group, and whoever else has its mark.
    pub fn kill(&mut self) {
        if !self.is_over {
            self.signal(Signal::Kill);
            let _ = self.child.kill();
            let _ = self.child.wait();
            self.is_over = true;
        }
        self.kill_marked();
    }

    /// Kills whoever has the mark, until there is nobody. What starts others
    /// without end could go on for ever, so there is an end to this.
    #[cfg(unix)]
    fn kill_marked(&self) {
        const ROUNDS: usize = 50;
        const PAUSE: std::time::Duration = std::time::Duration::from_millis(2);
        let Some(mark) = &self.mark else { return };
        for _ in 0..ROUNDS {
            let found = harness::store::processes_with(mark);
            if found.is_empty() {
                return;
            }
            for process in found {
                let process = nix::unistd::Pid::from_raw(process);
                // What has ended by itself need not be killed.
                let _ = nix::sys::signal::kill(process, nix::sys::signal::Signal::SIGKILL);
            }
            std::thread::sleep(PAUSE);
        }
    }

    #[cfg(not(unix))]
    fn kill_marked(&self) {}

    #[cfg(unix)]
    fn pid(&self) -> nix::unistd::Pid {
        // Numbers of processes are positive and fit.
        nix::unistd::Pid::from_raw(self.child.id().cast_signed())
    }

    /// To all of the group; what has ended by itself does not hear it.
    #[cfg(unix)]
    fn signal(&mut self, signal: Signal) {
        use nix::sys::signal::{Signal as Unix, killpg};
        let signal = match signal {
            Signal::End => Unix::SIGTERM,
            Signal::Kill => Unix::SIGKILL,
        };
        let _ = killpg(self.pid(), signal);
    }

    #[cfg(not(unix))]
    fn signal(&mut self, signal: Signal) {
        if matches!(signal, Signal::Kill) {
            let _ = self.child.kill();
        }
    }
}

impl Drop for Group {
    fn drop(&mut self) {
        self.kill();
    }
}

#[derive(Debug, Clone, Copy)]
enum Signal {
    End,
    Kill,
}

#[cfg(unix)]
fn own_group(command: &mut Command) {
    std::os::unix::process::CommandExt::process_group(command, 0);
}

#[cfg(not(unix))]
fn own_group(_: &mut Command) {}
