//! `Polygons`: polygons and patches by their fills; many of one become a mesh.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use scene::format::{Material, Object};
use tracer::glam::DVec3;

use super::reader::Reader;
use super::words::Word;
use crate::import::files::Files;
use crate::polygon::{Cutter, Problem, has_area};

/// The most corners of a polygon: what is above is no polygon that anybody drew.
const MOST_CORNERS: usize = 10_000;

/// The most triangles of a fill that stand in the scene themselves.
const MOST_INLINE: usize = 32;

/// What is gathered of one fill, and of one kind.
#[derive(Debug, Default)]
struct Gathered {
    corners: Vec<DVec3>,
    /// As many as corners, or none.
    normals: Vec<DVec3>,
    triangles: Vec<[usize; 3]>,
}

/// All polygons so far, by fill and whether they have normals.
#[derive(Debug)]
pub(super) struct Polygons {
    /// What the names of meshes begin with.
    stem: String,
    pub(super) cutter: Cutter,
    /// Whether it was said that cutting them is too much work.
    is_too_much: bool,
    gathered: BTreeMap<(Option<String>, bool), Gathered>,
}

impl Polygons {
    /// None; their meshes will be named like this file.
    pub(super) fn named_like(file: &str) -> Self {
        let name = file.rsplit(['/', '\\']).next().unwrap_or_default();
        let stem = name.split('.').next().unwrap_or_default();
        let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
        let stem: String = stem.chars().map(plain).collect();
        let stem = if stem.is_empty() { "scene".to_owned() } else { stem };
        let (cutter, gathered) = (Cutter::default(), BTreeMap::new());
        Self { stem, cutter, is_too_much: false, gathered }
    }

    /// All of them as objects, fill by fill; meshes are put into `files`.
    pub(super) fn objects(&self, files: &mut Files) -> Vec<Object> {
        let mut objects = Vec::new();
        for ((fill, has_normals), gathered) in &self.gathered {
            let material = fill.clone().map(Material::Named);
            if !has_normals && gathered.triangles.len() <= MOST_INLINE {
                let corner = |i: usize| gathered.corners[i].to_array();
                objects.extend(gathered.triangles.iter().map(|&[a, b, c]| Object::Triangle {
                    a: corner(a),
                    b: corner(b),
                    c: corner(c),
                    material: material.clone(),
                }));
            } else if !gathered.triangles.is_empty() {
                let kind = if *has_normals { "patches" } else { "polygons" };
                let fill = fill.as_deref().unwrap_or("plain");
                let name = format!("{}-{fill}-{kind}.obj", self.stem);
                let file = files.add(&name, gathered.obj().into_bytes());
                objects.push(Object::Mesh { file, flat: false, material });
            }
        }
        objects
    }
}

impl Gathered {
    /// As an OBJ file, in numbers that are read as the very same.
    fn obj(&self) -> String {
        let mut obj = String::new();
        // Writing to a String cannot fail.
        for DVec3 { x, y, z } in &self.corners {
            let _ = writeln!(obj, "v {x:?} {y:?} {z:?}");
        }
        for DVec3 { x, y, z } in &self.normals {
            let _ = writeln!(obj, "vn {x:?} {y:?} {z:?}");
        }
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|i| i + 1);
            let _ = if self.normals.is_empty() {
                writeln!(obj, "f {a} {b} {c}")
            } else {
                writeln!(obj, "f {a}//{a} {b}//{b} {c}//{c}")
            };
        }
        obj
    }
}

impl Reader<'_> {
    /// A polygon: a number of corners, then the corners.
    pub(super) fn polygon(&mut self, word: Word<'_>) -> Option<()> {
        let n = self.corner_count(word)?;
        let mut corners = Vec::with_capacity(n);
        for _ in 0..n {
            corners.push(DVec3::from_array(self.numbers(word)?));
        }
        self.cut(word, &corners, &[]);
        Some(())
    }

    /// A patch: a number of corners, then each corner with its normal.
    pub(super) fn patch(&mut self, word: Word<'_>) -> Option<()> {
        let n = self.corner_count(word)?;
        let (mut corners, mut normals) = (Vec::with_capacity(n), Vec::with_capacity(n));
        for _ in 0..n {
            let [x, y, z, nx, ny, nz] = self.numbers(word)?;
            corners.push(DVec3::new(x, y, z));
            normals.push(DVec3::new(nx, ny, nz));
        }
        if normals.contains(&DVec3::ZERO) {
            self.unreadable(word.at, "pp: expected normals, found one of length 0".to_owned());
            return Some(());
        }
        self.cut(word, &corners, &normals);
        Some(())
    }

    fn corner_count(&mut self, word: Word<'_>) -> Option<usize> {
        let [n] = self.numbers(word)?;
        let fits = n.fract() == 0.0 && (3.0..=MOST_CORNERS as f64).contains(&n);
        if !fits {
            let message = format!(
                "{}: expected a number of corners from 3 to {MOST_CORNERS}, found {n:?}",
                word.text
            );
            self.unreadable(word.at, message);
            return None;
        }
        Some(n as usize)
    }

    /// Cuts a polygon into triangles and keeps them under its fill.
    fn cut(&mut self, word: Word<'_>, corners: &[DVec3], normals: &[DVec3]) {
        self.report.chose(
            "polygons are seen from both sides; the format lets a renderer show their fronts alone",
        );
        let cut = match <&[DVec3; 3]>::try_from(corners) {
            // The cutter leaves a triangle as it is.
            Ok(triangle) if !has_area(triangle) => Err(Problem::NoArea),
            _ => self.polygons.cutter.cut(corners),
        };
        let triangles = match cut {
            Ok(triangles) => triangles,
            Err(Problem::NoArea) => {
                self.report.chose("polygons that cover nothing are left out, as nobody sees them");
                return;
            }
            Err(Problem::Crossing(a, b)) => {
                let message = format!(
                    "{}: expected a border that does not cross itself, found that the edges from \
                     corner {} and from corner {} cross",
                    word.text,
                    a + 1,
                    b + 1
                );
                self.unreadable(word.at, message);
                return;
            }
            Err(Problem::TooMuchWork) => {
                // Said once: the others are no worse.
                if !std::mem::replace(&mut self.polygons.is_too_much, true) {
                    let message = format!(
                        "{}: expected polygons that are cut with less work, found one of too many \
                         with too many corners",
                        word.text
                    );
                    let help = "cut those with the most corners into several";
                    self.report.unreadable(|| self.text.place(word.at), message, Some(help));
                }
                return;
            }
            Err(problem) => {
                let message = format!(
                    "{}: expected a border with an inside, found a polygon that {}",
                    word.text,
                    problem.text()
                );
                self.unreadable(word.at, message);
                return;
            }
        };
        let problems: Vec<String> = triangles
            .iter()
            .flat_map(|&t| {
                let [a, b, c] = t.map(|i| corners[i].to_array());
                self.sense.of_object(&Object::Triangle { a, b, c, material: None })
            })
            .collect();
        if !self.judge(word, problems) {
            return;
        }
        // Says so where there is none.
        self.material();
        let key = (self.fill.clone(), !normals.is_empty());
        let gathered = self.polygons.gathered.entry(key).or_default();
        let first = gathered.corners.len();
        gathered.corners.extend(corners);
        gathered.normals.extend(normals);
        gathered.triangles.extend(triangles.into_iter().map(|t| t.map(|i| i + first)));
    }
}
