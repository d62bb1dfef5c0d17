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
    assert!(check_place(path.parent().unwrap()).is_err() && check_place(&path).is_ok());
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
    // Another program's mark says that it may empty the folder, not that we may.
    for mark in [&b"Signature: 8a477f597d28d172789f06886806bc55\n# Made by cargo.\n"[..], b""] {
        write(&theirs.join(ARTIFACTS_MARK.0), mark).unwrap();
        let error = empty_artifacts(&theirs).unwrap_err().to_string();
        assert!(error.contains("not made by goldray: move it"), "{error}");
        assert!(is_file(&theirs.join("a.png")));
    }
}

#[cfg(unix)]
#[test]
fn a_link_is_never_emptied_even_to_a_folder_of_ours() {
    let folder = tempfile::tempdir().unwrap();
    let (ours, link) = (folder.path().join("ours"), folder.path().join("target/goldray"));
    empty_artifacts(&ours).unwrap();
    for name in ["a.png", ".goldray-dead.tmp"] {
        write(&ours.join(name), b"1").unwrap();
    }
    fs::create_dir(folder.path().join("target")).unwrap();
    for to in [ours.as_path(), Path::new("nowhere")] {
        std::os::unix::fs::symlink(to, &link).unwrap();
        let error = empty_artifacts(&link).unwrap_err().to_string();
        assert!(error.contains("is a link: remove it"), "{error}");
        remove(&link).unwrap();
    }
    for name in ["a.png", ".goldray-dead.tmp"] {
        assert!(is_file(&ours.join(name)), "{name}");
    }
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
    let missing = folder.path().join("missing");
    for inside in ["missing", "missing/a.png", "golden/../missing/a.png", "new/../missing/b/a"] {
        assert!(is_inside(&folder.path().join(inside), &missing), "{inside}");
    }
    assert!(!is_inside(&folder.path().join("missing/../a.png"), &missing));
}

#[cfg(unix)]
#[test]
fn what_is_inside_is_told_as_the_system_goes_through_links() {
    let folder = tempfile::tempdir().unwrap();
    let golden = folder.path().join("golden");
    write(&golden.join("s/a.png"), b"").unwrap();
    write(&folder.path().join("out/a.png"), b"").unwrap();
    let link = |to: &str, at: &str| {
        std::os::unix::fs::symlink(folder.path().join(to), folder.path().join(at)).unwrap();
    };
    link("golden/s", "lnk");
    link("golden/s/a.png", "file.png");
    link("out", "golden/away");
    link(".", "same");
    for inside in [
        "lnk/b.png",
        "lnk/../ball.png",
        "new/../lnk/../ball.png",
        "same/golden/a.png",
        "lnk/../x/y",
    ] {
        assert!(is_inside(&folder.path().join(inside), &golden), "{inside}");
    }
    // A file is written in a link's place, not through it.
    for outside in ["file.png", "lnk/../../a.png", "golden/away/a.png", "golden/away/../a.png"] {
        assert!(!is_inside(&folder.path().join(outside), &golden), "{outside}");
    }
    // Goldens that are kept elsewhere, and a suite that is reached through a link.
    let linked = folder.path().join("linked");
    link("out", "linked");
    assert!(is_inside(&folder.path().join("out/b.png"), &linked));
    assert!(is_inside(&folder.path().join("missing/b.png"), &folder.path().join("same/missing")));
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
    for odd in ["a.png/b.ron", "deep/a.PNG/b.ron", "a.Ron/b.ron", "a.png/empty/c.txt"] {
        let folder = tempfile::tempdir().unwrap();
        write(&folder.path().join("a.ron"), b"").unwrap();
        write(&folder.path().join("png/.png/c.ron"), b"").unwrap();
        assert_eq!(names(folder.path(), "ron").unwrap(), ["a"]);
        write(&folder.path().join(odd), b"").unwrap();
        for ending in ["ron", "png"] {
            let error = names(folder.path(), ending).unwrap_err().to_string();
            assert!(error.contains("give the folder a name without"), "{odd}: {error}");
        }
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
