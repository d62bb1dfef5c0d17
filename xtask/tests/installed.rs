//! A second project: a folder of its own, with nothing of goldray in it but the
//! installed binary.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tree::{Ran, SQUARE, Tree};

/// The project, and the binary in a folder that knows nothing of a repository.
struct Project {
    tree: Tree,
    bin: tempfile::TempDir,
}

impl Project {
    fn new() -> Self {
        let bin = tempfile::tempdir().unwrap();
        // By another process: what this one has open for writing, a program that another
        // test starts just then has open as well, and as long as it has, it is no program.
        let copied = Command::new("cp")
            .args([Path::new(env!("CARGO_BIN_EXE_goldray")), &program(bin.path())])
            .status();
        assert!(copied.unwrap().success());
        Self { tree: Tree::new(&[]), bin }
    }

    fn run(&self, args: &[&str]) -> Ran {
        let mut command = self.tree.command_of(&program(self.bin.path()), args);
        // Nothing of a toolchain is to be had.
        command.env_remove("CARGO").env("PATH", self.bin.path());
        let ran = Ran(command.output().unwrap());
        let all = format!("{}{}", ran.stdout(), ran.stderr());
        // But for what only goldray's own repository can be asked.
        let in_repository = all.contains("expected a folder inside goldray's repository");
        assert!(in_repository || !all.contains("xtask"), "{args:?} names another program:\n{all}");
        ran
    }

    fn read(&self, path: &str) -> String {
        fs::read_to_string(self.tree.path(path)).unwrap()
    }
}

fn program(folder: &Path) -> PathBuf {
    folder.join(format!("goldray{}", std::env::consts::EXE_SUFFIX))
}

#[test]
fn it_lives_by_the_binary_alone() {
    let project = Project::new();
    // What is missing is said each time, with what to do.
    project.run(&["check"]).expect_code(2).expect("then: goldray new area/name");
    fs::create_dir(project.tree.path("fixtures")).unwrap();
    project.run(&["check"]).expect_code(2).expect("to write one: goldray new area/name");
    project.run(&["new", "first/ball"]).expect_code(0).expect("goldray bless first/ball");
    project.run(&["check"]).expect_code(1).expect("if meant: goldray bless first/ball");
    project.run(&["bless", "first/ball"]).expect_code(0);
    project.run(&["check"]).expect_code(0).expect("1 judged: 1 match");
    assert!(project.read("target/goldray/report.html").contains("first/ball"));

    // Another picture is found, by whom and what helps.
    let fixture = "fixtures/second.ron";
    project.tree.write(fixture, SQUARE.as_bytes());
    project.run(&["bless", "second"]).expect_code(0);
    project.tree.write(fixture, SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)").as_bytes());
    project.run(&["check"]).expect_code(1).expect("goldray bless second");
    let report = project.read("target/goldray/report.html");
    assert!(report.contains("goldray bless second") && !report.contains("cargo xtask"));
    let outputs = ["--junit", "j.xml", "--summary", "s.md", "--json", "r.json"];
    project.run(&[&["check"][..], &outputs].concat()).expect_code(1);
    for file in ["j.xml", "s.md", "r.json"] {
        let text = project.read(file);
        assert!(text.contains("goldray bless second") && !text.contains("xtask"), "{file}: {text}");
    }
    project.run(&["bless", "--all"]).expect_code(0);
    project.run(&["check", "--last-failed"]).expect_code(0);
    project.run(&["lint"]).expect_code(0);
}

#[test]
fn its_help_names_no_other_program() {
    let project = Project::new();
    let help = project.run(&["--help"]).expect_code(0).expect("goldray check sphere").stdout();
    let verbs = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let verbs = verbs.take_while(|line| !line.is_empty());
    let verbs: Vec<_> = verbs.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(verbs.len() > 10 && !verbs.contains(&"stress") && !verbs.contains(&"bench"), "{help}");
    for verb in verbs.iter().filter(|verb| **verb != "help") {
        project.run(&[verb, "--help"]).expect_code(0).expect(&format!("goldray {verb}"));
    }
    project.run(&["completions", "bash"]).expect_code(0).expect("complete -F _goldray");
    project.run(&["stress"]).expect_code(2).expect("expected a folder inside goldray's repository");
}
