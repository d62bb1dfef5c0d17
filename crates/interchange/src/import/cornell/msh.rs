//! The course's own mesh files, `.msh`, as OBJ files.
//!
//! A number of vertices, a number of triangles, then sections: `vertices` with
//! three numbers each, `triangles` with three indices from 0 each, and
//! optionally `texcoords` (two for each vertex) and `normals` (three for each).
//! Numbers keep their digits.

use std::fmt::Write as _;

use crate::import::text::{Text, number, shown};

/// The OBJ file of a mesh.
///
/// # Errors
/// What is wrong with it, as the end of a sentence that begins with its name.
pub(super) fn to_obj(bytes: &[u8]) -> Result<String, String> {
    let text = Text::of(bytes).map_err(|problem| problem.message)?;
    let mut words = Words { text: &text, rest: text.text };
    let (vertices, triangles) = (words.count("vertices")?, words.count("triangles")?);
    words.section("vertices")?;
    let mut obj = String::new();
    for _ in 0..vertices {
        let [x, y, z] = [words.number()?, words.number()?, words.number()?];
        // Writing to a String cannot fail.
        let _ = writeln!(obj, "v {x} {y} {z}");
    }
    words.section("triangles")?;
    let mut faces = Vec::new();
    for _ in 0..triangles {
        faces.push([words.index(vertices)?, words.index(vertices)?, words.index(vertices)?]);
    }
    let (mut has_texture, mut has_normals) = (false, false);
    while let Some((section, place)) = words.next() {
        match section {
            "texcoords" if !has_texture && !has_normals => {
                has_texture = true;
                for _ in 0..vertices {
                    let [u, v] = [words.number()?, words.number()?];
                    let _ = writeln!(obj, "vt {u} {v}");
                }
            }
            "normals" if !has_normals => {
                has_normals = true;
                for _ in 0..vertices {
                    let [x, y, z] = [words.number()?, words.number()?, words.number()?];
                    let _ = writeln!(obj, "vn {x} {y} {z}");
                }
            }
            other => {
                let expected = "the section texcoords or normals, or the end";
                return Err(expected_at(place, expected, Some(other)));
            }
        }
    }
    for face in faces {
        obj.push('f');
        for i in face {
            let _ = match (has_texture, has_normals) {
                (true, true) => write!(obj, " {i}/{i}/{i}"),
                (true, false) => write!(obj, " {i}/{i}"),
                (false, true) => write!(obj, " {i}//{i}"),
                (false, false) => write!(obj, " {i}"),
            };
        }
        obj.push('\n');
    }
    Ok(obj)
}

/// The words of a file, one after the other.
struct Words<'a> {
    text: &'a Text<'a>,
    rest: &'a str,
}

impl<'a> Words<'a> {
    /// The next word and the byte where it begins.
    fn next(&mut self) -> Option<(&'a str, (usize, usize))> {
        let start = self.rest.trim_start();
        let end = start.find(char::is_whitespace).unwrap_or(start.len());
        let (word, rest) = start.split_at(end);
        self.rest = rest;
        let byte = self.text.text.len() - start.len();
        (!word.is_empty()).then(|| (word, self.text.place(byte)))
    }

    fn read<T>(
        &mut self,
        expected: &str,
        read: impl FnOnce(&'a str) -> Option<T>,
    ) -> Result<T, String> {
        let end = self.text.place(self.text.text.len());
        let (word, place) = self.next().unzip();
        let found = word.and_then(read);
        found.ok_or_else(|| expected_at(place.unwrap_or(end), expected, word))
    }

    /// How many of these follow.
    fn count(&mut self, of: &str) -> Result<u32, String> {
        self.read(&format!("the number of {of}"), |word| word.parse().ok())
    }

    fn section(&mut self, name: &str) -> Result<(), String> {
        self.read(&format!("the section {name}"), |word| (word == name).then_some(()))
    }

    /// A number, as it is written.
    fn number(&mut self) -> Result<&'a str, String> {
        self.read("a finite number", |word| number(word).ok().map(|_| word))
    }

    /// An index of one of so many vertices, counted from 1.
    fn index(&mut self, vertices: u32) -> Result<u32, String> {
        let expected = format!("the number of a vertex, below {vertices}");
        self.read(&expected, |word| {
            word.parse().ok().filter(|index| *index < vertices).map(|index: u32| index + 1)
        })
    }
}

fn expected_at((line, column): (usize, usize), expected: &str, found: Option<&str>) -> String {
    let found = found.map_or("the end".to_owned(), |word| format!("\"{}\"", shown(word)));
    format!("has a mistake at {line}:{column}: expected {expected}, found {found}")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: &str = "3\n1\nvertices\n0\n0\n0\n1.50\n0\n0\n0\n1e0\n0\ntriangles\n0\n1\n2\n";

    #[test]
    fn sections_become_lines() {
        #[track_caller]
        fn check(more: &str, face: &str) {
            let obj = to_obj(format!("{TRIANGLE}{more}").as_bytes()).unwrap();
            assert!(obj.starts_with("v 0 0 0\nv 1.50 0 0\nv 0 1e0 0\n"), "{obj}");
            assert!(obj.ends_with(&format!("\nf {face}\n")), "{obj}");
        }
        check("", "1 2 3");
        check("texcoords 0 0 1 0 0 1", "1/1 2/2 3/3");
        check("normals\n0 0 1 0 0 1 0 0 1", "1//1 2//2 3//3");
        check("texcoords 0 0 1 0 0 1 normals 0 0 1 0 0 1 0 0 1", "1/1/1 2/2/2 3/3/3");
    }

    #[test]
    fn mistakes_are_told_with_their_place() {
        #[track_caller]
        fn check(text: &str, expected: &str) {
            let why = to_obj(text.as_bytes()).unwrap_err();
            assert!(why.contains(expected), "{why}");
        }
        check("", "1:1: expected the number of vertices, found the end");
        check("-3\n1", "1:1: expected the number of vertices, found \"-3\"");
        check("4294967295\n1\nvertices\n0", "4:2: expected a finite number, found the end");
        check(&TRIANGLE.replace("1.50", "nan"), "7:1: expected a finite number, found \"nan\"");
        check(&TRIANGLE.replace("\n2\n", "\n3\n"), "below 3, found \"3\"");
        check(&TRIANGLE.replace("triangles", "faces"), "the section triangles, found \"faces\"");
        check(&format!("{TRIANGLE}7"), "texcoords or normals, or the end, found \"7\"");
        check(&TRIANGLE[..TRIANGLE.len() - 2], "found the end");
    }
}
