//! `completions`: what a shell needs to complete a command line.

use clap_complete::{Shell, generate};

use crate::Answer;

/// Flags of `completions`.
#[derive(Debug, clap::Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Args {
    /// For which shell
    shell: Shell,
}

/// What completes: a shell completes by the first word, which here is cargo's.
const COMMAND: &str = "goldray";

const AFTER_HELP: &str = "\
A shell completes by the first word, and that of `cargo xtask` is cargo's. So give goldray a name
of its own, and complete that: goldray check --last-<TAB>

Examples:
  bash, with its package bash-completion; the function also in ~/.bashrc:
    goldray() { cargo xtask \"$@\"; }
    cargo xtask completions bash > ~/.local/share/bash-completion/completions/goldray
  zsh, where fpath has ~/.zfunc before compinit; the function also in ~/.zshrc:
    goldray() { cargo xtask \"$@\"; }
    cargo xtask completions zsh > ~/.zfunc/_goldray
  fish:
    function goldray; cargo xtask $argv; end; funcsave goldray
    cargo xtask completions fish > ~/.config/fish/completions/goldray.fish
  PowerShell; both also in $PROFILE, with the output in a file:
    function goldray { cargo xtask @args }
    cargo xtask completions powershell | Out-String | Invoke-Expression";

/// The same for what is called by its own name already.
pub(crate) const INSTALLED: &str = "\
Examples:
  goldray completions bash > ~/.local/share/bash-completion/completions/goldray
  goldray completions zsh > ~/.zfunc/_goldray
  goldray completions fish > ~/.config/fish/completions/goldray.fish
  goldray completions powershell | Out-String | Invoke-Expression";

pub(crate) fn run(mut command: clap::Command, args: &Args) -> Answer {
    // Printed here and not there, where a reader that leaves would be a panic.
    let mut script = Vec::new();
    generate(args.shell, &mut command, COMMAND, &mut script);
    print!("{}", String::from_utf8_lossy(&script));
    Answer::Yes
}
