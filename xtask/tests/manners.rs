//! What makes `check` pleasant every day, as the real binary does it.
#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod tree;

use std::fs;
use std::process::{Command, Stdio};

use tree::{SQUARE, Tree};

/// A square whose upper half is gone.
fn flat() -> String {
    SQUARE.replace("(1, 1, 1)", "(1, 0.5, 1)")
}

#[test]
fn the_last_failures_are_checked_again_and_nothing_is_never_green() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE), ("c", SQUARE)]);
    let again = |filters: &[&str]| tree.run(&[&["check", "--last-failed"], filters].concat());
    again(&[]).expect_code(2).expect("run `cargo xtask check` once");
    tree.run(&["check"]).expect_code(0);
    again(&[]).expect_code(2).expect("no fixture failed in the last check");

    tree.write("fixtures/a.ron", flat().as_bytes());
    tree.write("fixtures/b.ron", flat().as_bytes());
    tree.run(&["check", "--no-cache"]).expect_code(1);
    again(&[]).expect_code(1).expect("2 judged: 2 stale golden");
    again(&["b", "c"]).expect_code(1).expect("1 judged: 1 stale golden");
    again(&["c"]).expect_code(2).expect("none of the 2 that failed in the last check is selected");
    again(&["zzz"]).expect_code(2).expect("the filter \"zzz\" selects nothing");
    // A part leaves what is known of the others.
    tree.run(&["check", "c"]).expect_code(0);
    tree.run(&["bless", "a"]).expect_code(0);
    again(&["a"]).expect_code(0).expect("1 judged: 1 match");
    again(&[]).expect_code(1).expect("1 judged: 1 stale golden");
    // Where CI is set it is kept as well.
    fs::remove_file(tree.path("golden/c.png")).unwrap();
    tree.run_with(&["check"], &[("CI", "1")]).expect_code(1);
    again(&[]).expect_code(1).expect("1 missing golden");
    // What has gone since is not asked for.
    fs::remove_file(tree.path("fixtures/c.ron")).unwrap();
    again(&[]).expect_code(1).expect("1 judged: 1 stale golden");
    fs::remove_file(tree.path("fixtures/b.ron")).unwrap();
    again(&[]).expect_code(1).expect("1 judged: 1 orphan golden");
    fs::remove_file(tree.path("golden/b.png")).unwrap();
    again(&[]).expect_code(2).expect("is in the suite any more");
}

#[test]
fn repeats_render_anew_and_right_fixtures_are_steady() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    tree.run(&["check"]).expect_code(0);
    let ran = tree.run(&["check", "--repeat", "3", "--json", "a.json"]).expect_code(0);
    ran.expect("2 judged: 2 match");
    let json = fs::read_to_string(tree.path("a.json")).unwrap();
    assert!(!json.contains("\"cached\": true"), "{json}");
    for count in ["0", "1", "x"] {
        tree.run(&["check", "--repeat", count]).expect_code(2).expect("--repeat <COUNT>");
    }
}

#[test]
fn quiet_says_less_and_verbose_more() {
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    fs::remove_file(tree.path("golden/b.png")).unwrap();
    tree.run(&["check"]).expect_code(1);
    let ran = tree.run(&["check", "--quiet"]).expect_code(1);
    assert_eq!(ran.stderr(), "");
    let printed = ran.stdout();
    let lines: Vec<_> = printed.lines().collect();
    assert_eq!(lines[0], "missing golden      b: there is no golden");
    assert!(lines.len() == 2 && lines[1].starts_with("2 judged: 1 match, 1 missing golden"));

    let ran = tree.run(&["check", "--verbose", "--no-cache"]).expect_code(1);
    let ran = ran.expect("match               a: identical | 16 x 12, rendered in ");
    ran.expect("if meant: cargo xtask bless b | 16 x 12, rendered in ");
    tree.run(&["bless", "b"]).expect_code(0);
    tree.run(&["check"]).expect_code(0);
    tree.run(&["check", "-v"]).expect_code(0).expect(": unchanged since its last match");
    assert_eq!(tree.run(&["check", "-q"]).expect_code(0).stdout().lines().count(), 1);
    tree.run(&["check", "-q", "-v"]).expect_code(2).expect("cannot be used with");
}

#[test]
fn colors_are_for_terminals_and_whoever_asks() {
    let tree = Tree::new(&[("a", SQUARE)]);
    let colored = |args: &[&str], variables: &[(&str, &str)]| {
        let args = [&["check"], args].concat();
        let printed = tree.run_with(&args, variables).expect_code(1).stdout();
        let plain = anstream::adapter::strip_str(&printed).to_string();
        assert!(plain.starts_with("missing golden      a: there is no golden"), "{plain}");
        printed != plain
    };
    assert!(!colored(&[], &[]), "not into a pipe");
    assert!(colored(&["--color", "always"], &[]));
    assert!(!colored(&["--color", "never"], &[("CLICOLOR_FORCE", "1")]));
    assert!(!colored(&[], &[("NO_COLOR", "1"), ("CLICOLOR_FORCE", "1")]));
    tree.run(&["check", "--color", "green"]).expect_code(2).expect("[possible values: auto,");
}

#[test]
fn a_reader_that_leaves_a_check_gets_no_panic() {
    let tree = Tree::new(&[("a", SQUARE)]);
    for color in ["always", "never"] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = tree.command(&["check", "-q", "--color", color]);
        let ran = command.stdout(writer).stderr(Stdio::piped()).spawn().unwrap();
        let output = ran.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
        // What it wrote is there all the same.
        tree.run(&["check", "--last-failed"]).expect_code(1).expect("1 judged");
        fs::remove_dir_all(tree.path("target")).unwrap();
    }
}

#[test]
fn pointers_of_git_lfs_are_named() {
    let pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 9\n";
    let mesh = SQUARE.replace("Box(min: (-1, -1, -1), max: (1, 1, 1))", "Mesh(file: \"m.obj\")");
    let tree = Tree::blessed(&[("a", SQUARE), ("b", SQUARE)]);
    tree.write("golden/a.png", pointer);
    tree.write("fixtures/b.ron", mesh.as_bytes());
    tree.write("fixtures/m.obj", pointer);
    let ran = tree.run(&["check"]).expect_code(1);
    let pull = "run `git lfs pull`";
    let ran = ran.expect(&format!(
        "unreadable          a: the golden is a Git LFS pointer, not the picture: {pull}"
    ));
    ran.expect(&format!("mesh \"m.obj\" is a Git LFS pointer, not the mesh: {pull}"));
    // Nobody has looked at what it points to.
    let ran = tree.run(&["bless", "a"]).expect_code(1);
    ran.expect(&format!("refused   a: the golden is a Git LFS pointer, not the picture: {pull}"));
    assert_eq!(fs::read(tree.path("golden/a.png")).unwrap(), pointer);
    let said = tree.run(&["check", "a"]).expect_code(1).stdout();
    assert!(!said.contains("if meant"), "{said}");
    let ran = tree.run(&["compare", "golden/a.png", "golden/b.png"]).expect_code(2);
    ran.expect(&format!("golden/a.png: is a Git LFS pointer, not the picture: {pull}"));
    tree.write("fixtures/b.ron", pointer);
    let ran = tree.run(&["render", "b", "--out", "b.png"]).expect_code(2);
    ran.expect(&format!("fixtures/b.ron: is a Git LFS pointer, not the fixture: {pull}"));
}

#[test]
fn completions_complete() {
    let tree = Tree::new(&[]);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = tree.run(&["completions", shell]).expect_code(0).stdout();
        for word in ["goldray", "last-failed", "contact-sheet"] {
            assert!(script.contains(word), "{shell}: no {word}");
        }
    }
    tree.run(&["completions", "cmd"]).expect_code(2).expect("possible values: bash");
}

/// What bash makes of `goldray` and these words, of which the last is begun.
#[cfg(unix)]
fn completed(tree: &Tree, words: &str) -> Vec<String> {
    let ask = format!(
        "source <(\"$0\" completions bash) && COMP_WORDS=(goldray {words}) && \
         COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)) && \
         _goldray goldray \"${{COMP_WORDS[COMP_CWORD]}}\" \"${{COMP_WORDS[COMP_CWORD-1]}}\" && \
         printf '%s\\n' \"${{COMPREPLY[@]}}\""
    );
    let mut bash = Command::new("bash");
    bash.args(["-c", &ask, env!("CARGO_BIN_EXE_xtask")]).current_dir(tree.path(""));
    let output = bash.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[cfg(unix)]
#[test]
fn bash_completes_verbs_and_flags() {
    let tree = Tree::new(&[]);
    assert_eq!(completed(&tree, "contact"), ["contact-sheet"]);
    assert_eq!(completed(&tree, "check --last"), ["--last-failed"]);
    assert_eq!(completed(&tree, "check --color ''"), ["auto", "always", "never"]);
    let script = tree.run(&["completions", "bash"]).expect_code(0).stdout();
    tree.write("goldray.bash", script.as_bytes());
    let mut bash = Command::new("bash");
    let status = bash.arg("-n").arg(tree.path("goldray.bash")).status().unwrap();
    assert!(status.success());
}
