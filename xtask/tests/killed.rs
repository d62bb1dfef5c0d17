//! `bless` killed in the middle of writing, again and again: every golden is the
//! old or the new one, and the last run completes what the others began.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use tree::{SQUARE, Tree};

const COUNT: usize = 500;

/// Killed once so many goldens are new: at the start, at the first one, and
/// twice in the middle.
const MOMENTS: [usize; 4] = [0, 1, COUNT / 3, 2 * COUNT / 3];

/// A suite of many fixtures, of which every other one has a golden, and that
/// an old one.
struct Many {
    tree: Tree,
    old: Vec<u8>,
    new: Vec<u8>,
}

impl Many {
    fn new() -> Self {
        let changed = SQUARE.replace("image: (16, 12)", "image: (32, 24)");
        let golden = |text: &str| {
            let tree = Tree::blessed(&[("a", text)]);
            fs::read(tree.path("golden/a.png")).unwrap()
        };
        let tree = Tree::new(&[]);
        let many = Self { tree, old: golden(SQUARE), new: golden(&changed) };
        for i in 0..COUNT {
            many.tree.write(&format!("fixtures/{}.ron", name(i)), changed.as_bytes());
            if let Some(old) = many.before(i) {
                many.tree.write(&format!("golden/{}.png", name(i)), old);
            }
        }
        many
    }

    fn golden(&self, i: usize) -> PathBuf {
        self.tree.path(&format!("golden/{}.png", name(i)))
    }

    fn before(&self, i: usize) -> Option<&[u8]> {
        i.is_multiple_of(2).then_some(self.old.as_slice())
    }

    /// By their sizes, as no time is to be lost.
    fn count_new(&self) -> usize {
        let size = self.new.len() as u64;
        assert_ne!(size, self.old.len() as u64);
        (0..COUNT).filter(|&i| fs::metadata(self.golden(i)).is_ok_and(|m| m.len() == size)).count()
    }

    /// Starts blessing everything and kills it at that moment.
    fn bless_and_kill(&self, moment: usize) {
        let mut command = self.tree.command(&["bless", "--all"]);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        while self.count_new() < moment && child.try_wait().unwrap().is_none() {}
        // SIGKILL, where there are signals.
        let _ = child.kill();
        child.wait().unwrap();
    }
}

fn name(i: usize) -> String {
    format!("area-{}/f{i:03}", i % 7)
}

/// Half-written files below a folder.
fn temporaries(folder: &Path) -> usize {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let count = |path: PathBuf| {
        if path.is_dir() {
            return temporaries(&path);
        }
        usize::from(path.extension().is_some_and(|ending| ending == "tmp"))
    };
    entries.map(count).sum()
}

#[test]
fn every_golden_is_whole_and_the_last_run_completes() {
    let many = Many::new();
    let golden = many.tree.path("golden");
    let mut in_the_middle = 0;
    for moment in MOMENTS {
        many.bless_and_kill(moment);
        for i in 0..COUNT {
            let found = fs::read(many.golden(i)).ok();
            let is_new = found.as_ref() == Some(&many.new);
            assert!(is_new || found.as_deref() == many.before(i), "{} is torn", name(i));
        }
        let new = many.count_new();
        assert!(new >= moment);
        in_the_middle += usize::from(0 < new && new < COUNT);
        println!("killed at {moment}: {new} of {COUNT} new, {} half-written", temporaries(&golden));
        let listed = many.tree.run(&["list"]).expect_code(0).stdout();
        assert_eq!(listed.lines().count(), COUNT, "nothing is taken for a golden");
    }
    assert!(in_the_middle > 0, "no kill came in the middle");
    many.tree.write("golden/area-0/.goldray-half.tmp", &many.new[..9]);
    many.tree.run(&["bless", "--all"]).expect_code(0);
    assert_eq!((many.count_new(), temporaries(&golden)), (COUNT, 0));
    many.tree.run(&["check"]).expect_code(0).expect("500 judged: 500 match");
}
