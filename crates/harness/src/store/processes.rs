//! Processes found by a variable of their environment.

use std::path::Path;

use walkdir::WalkDir;

use super::read;

/// The numbers of the processes that were started with this variable, `NAME=value`,
/// as far as they are this user's. Of a system without `/proc` none is known.
///
/// A process passes its environment on to those that it starts, whatever group,
/// session or parent they have; one that takes care to drop it is not found.
pub fn processes_with(variable: &str) -> Vec<i32> {
    /// More than an environment may take on Linux.
    const MOST: u64 = 8 << 20;
    let processes = WalkDir::new("/proc").min_depth(1).max_depth(1).into_iter();
    let number = |entry: walkdir::DirEntry| entry.file_name().to_str()?.parse::<i32>().ok();
    let is_marked = |process: &i32| {
        // Those of others, and what has ended meanwhile, cannot be read.
        let environment = read(Path::new(&format!("/proc/{process}/environ")), MOST);
        let environment = environment.ok().flatten().unwrap_or_default();
        environment.split(|&byte| byte == 0).any(|found| found == variable.as_bytes())
    };
    processes.filter_map(Result::ok).filter_map(number).filter(is_marked).collect()
}
