//! What is read, written, emptied, listed and swept away, and what is not.

use super::*;

#[test]
fn a_file_over_the_bound_is_refused_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    write(&path, b"12345").unwrap();
    assert_eq!(read(&path, 5).unwrap().as_deref(), Some(&b"12345"[..]));
    assert!(read(&path, 4).unwrap_err().to_string().contains("larger than 4 bytes"));
    assert!(read(&folder.path().join("b"), 5).unwrap().is_none());
    assert!(read(folder.path(), 5).unwrap_err().to_string().contains("is no file"));
}

#[test]
fn only_files_are_replaced_and_only_when_meant() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep/a");
    write_new(&path, b"1").unwrap();
    assert!(write_new(&path, b"2").is_err());
    assert!(write(path.parent().unwrap(), b"3").is_err(), "a folder");
    assert_eq!(read(&path, 9).unwrap().as_deref(), Some(&b"1"[..]));
    write(&path, b"4").unwrap();
    assert_eq!(read(&path, 9).unwrap().as_deref(), Some(&b"4"[..]));
}

#[test]
fn only_what_nobody_is_writing_is_swept_away() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let left = path("deep/.goldray-dead.tmp");
    for name in ["deep/.goldray-dead.tmp", "deep/a.png", ".goldray-a.png", "a.tmp"] {
        write(&path(name), b"1").unwrap();
    }
    write_then(&path("deep/b.png"), b"2", |file| {
        sweep(folder.path());
        assert!(is_file(file.path()), "it is being written");
        assert!(!is_file(&left));
        file.persist(path("deep/b.png")).map(drop).map_err(|error| error.error)
    })
    .unwrap();
    for name in ["deep/a.png", "deep/b.png", ".goldray-a.png", "a.tmp"] {
        assert!(is_file(&path(name)), "{name}");
    }
    sweep(&path("nowhere"));
}

#[test]
fn a_folder_that_is_not_ours_is_never_emptied() {
    let folder = tempfile::tempdir().unwrap();
    let artifacts = folder.path().join("target/goldray");
    empty_artifacts(&artifacts).unwrap();
    write(&artifacts.join("a.png"), b"1").unwrap();
    empty_artifacts(&artifacts).unwrap();
    assert!(!is_file(&artifacts.join("a.png")));
    assert!(is_file(&artifacts.join(ARTIFACTS_MARK.0)), "the mark of a run cut short");
    let theirs = folder.path().join("theirs");
    write(&theirs.join("a.png"), b"1").unwrap();
    assert!(empty_artifacts(&theirs).is_err());
    assert!(is_file(&theirs.join("a.png")));
}

#[test]
fn what_is_inside_is_told_before_it_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let golden = folder.path().join("golden");
    write(&golden.join("a.png"), b"").unwrap();
    for inside in ["golden/a.png", "golden/new/deep/b.png", "new/../golden/b.png"] {
        assert!(is_inside(&folder.path().join(inside), &golden), "{inside}");
    }
    for outside in ["a.png", "new/a.png", "golden/../a.png", "golden.png"] {
        assert!(!is_inside(&folder.path().join(outside), &golden), "{outside}");
    }
}

#[test]
fn nothing_that_looks_like_a_fixture_is_passed_over() {
    for odd in ["b.RON", ".b.ron", ".ron", "x.ron/y.txt", "a\nb.ron"] {
        let folder = tempfile::tempdir().unwrap();
        write(&folder.path().join("a.ron"), b"").unwrap();
        assert_eq!(names(folder.path(), "ron").unwrap(), ["a"]);
        write(&folder.path().join(odd), b"").unwrap();
        assert!(names(folder.path(), "ron").is_err(), "{odd:?}");
    }
}

#[cfg(unix)]
#[test]
fn links_to_files_count_and_links_to_folders_are_errors() {
    use std::os::unix::fs::symlink;
    let folder = tempfile::tempdir().unwrap();
    write(&folder.path().join("in/a.ron"), b"").unwrap();
    symlink("a.ron", folder.path().join("in/b.ron")).unwrap();
    assert_eq!(names(&folder.path().join("in"), "ron").unwrap(), ["a", "b"]);
    symlink("nowhere", folder.path().join("in/c.ron")).unwrap();
    assert!(names(&folder.path().join("in"), "ron").is_err(), "a link to nothing");
    remove(&folder.path().join("in/c.ron")).unwrap();
    symlink(folder.path(), folder.path().join("in/d")).unwrap();
    assert!(names(&folder.path().join("in"), "ron").is_err(), "a link to a folder");
}

#[test]
fn a_check_that_begins_does_not_disturb_one_that_writes() {
    use std::sync::atomic::{AtomicBool, Ordering};
    const FILES: usize = 60;
    let folder = tempfile::tempdir().unwrap();
    let artifacts = folder.path().join("target/goldray");
    empty_artifacts(&artifacts).unwrap();
    let is_done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let emptying = scope.spawn(|| {
            while !is_done.load(Ordering::Relaxed) {
                empty_artifacts(&artifacts)?;
            }
            Ok::<_, StoreError>(())
        });
        let write_one = |i: usize| write(&artifacts.join(format!("area/deep/{i}.png")), b"1");
        let written: Result<Vec<_>, _> = (0..FILES).map(write_one).collect();
        is_done.store(true, Ordering::Relaxed);
        emptying.join().unwrap().unwrap();
        written.unwrap();
    });
}
