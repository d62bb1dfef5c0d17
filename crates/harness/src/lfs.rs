//! `lfs`: files of which a clone without Git LFS has only a pointer.

/// How every version of the pointers begins, by their specification.
const START: &[u8] = b"version https://git-lfs";

/// What is wrong with these bytes where they are no `thing` but a pointer to
/// one, as the rest of a sentence.
pub(crate) fn pointer_problem(bytes: &[u8], thing: &str) -> Option<String> {
    let is_pointer = bytes.starts_with(START);
    is_pointer.then(|| format!("is a Git LFS pointer, not the {thing}: run `git lfs pull`"))
}

/// Whether this was said of a picture's pointer.
pub(crate) fn is_of_pointer(problem: &str) -> bool {
    pointer_problem(START, "picture").is_some_and(|said| said == problem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_pointers_are_pointers() {
        let pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 9\n";
        let said = pointer_problem(pointer, "mesh").unwrap();
        assert_eq!(said, "is a Git LFS pointer, not the mesh: run `git lfs pull`");
        for other in
            [&b""[..], b"version", b"\x89PNG", b"(version: 1)", b" version https://git-lfs"]
        {
            assert_eq!(pointer_problem(other, "mesh"), None);
        }
        assert!(is_of_pointer(&pointer_problem(pointer, "picture").unwrap()));
        assert!(!is_of_pointer(&said) && !is_of_pointer("is not a readable PNG"));
    }
}
