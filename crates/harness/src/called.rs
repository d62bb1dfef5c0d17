//! `called`: by which command the reader of a message asks for a verb.

use std::sync::OnceLock;

/// Within the repository; see `.cargo/config.toml`.
const IN_REPOSITORY: &str = "cargo xtask";

static NAME: OnceLock<&'static str> = OnceLock::new();

/// The command of a program that is called otherwise than in the repository, said
/// once, before anything else is.
pub fn call(name: &'static str) {
    // Whoever was first is right: one program has one name.
    let _ = NAME.set(name);
}

/// What stands before a verb in messages: `cargo xtask`, or `goldray` where that
/// is installed.
pub fn command() -> &'static str {
    NAME.get().copied().unwrap_or(IN_REPOSITORY)
}
