//! Wavefront OBJ with its materials: polygons, in one mesh for each material.
//!
//! All numbers are read as `f64`. Every statement is looked at: what has no
//! bearing on a picture (`o`, `g`, `s 0` and how it is displayed) is passed over,
//! what has is drawn or said to be lost.

mod corner;
mod geometry;
mod library;
mod map;
mod material;
mod mtl;

#[cfg(test)]
pub(super) mod tests;

use std::collections::BTreeMap;

use scene::Assets;

use super::mesh::stage::Stage;
use super::mesh::unreadable;
use super::mesh::words::{MOST_WORDS, Place, Word, Words};
use super::{Imported, Source, Unreadable, Wishes};
use geometry::Geometry;
use library::Library;

/// The most mistakes that are told: nobody mends more at a time.
const MOST_PROBLEMS: usize = 100;

/// Reads an OBJ file, and of `assets` the libraries that it names.
///
/// # Errors
/// Statements that cannot be read, all of them, and libraries that are missing.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    assets: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let mut reader = Reader {
        geometry: Geometry::default(),
        library: Library::new(assets),
        materials: Vec::new(),
        by_name: BTreeMap::new(),
        current: None,
        is_smooth: false,
        stage: Stage::default(),
    };
    let mut problems = Vec::new();
    let mut words = Words::with_comments(source.bytes);
    let mut statement = Vec::new();
    while words.next_statement(&mut statement) {
        if let Err(mut more) = reader.statement(&words, &statement) {
            problems.append(&mut more);
            if problems.len() >= MOST_PROBLEMS {
                problems.truncate(MOST_PROBLEMS);
                break;
            }
        }
    }
    if problems.is_empty() { reader.finish(source.name, wishes) } else { Err(problems) }
}

/// What is read so far.
struct Reader<'a> {
    geometry: Geometry,
    library: Library<'a>,
    /// Names of materials in the order of their first use, and where that is.
    materials: Vec<(String, Place)>,
    by_name: BTreeMap<String, usize>,
    current: Option<usize>,
    is_smooth: bool,
    stage: Stage,
}

impl Reader<'_> {
    fn statement(&mut self, words: &Words<'_>, all: &[Word<'_>]) -> Result<(), Vec<Unreadable>> {
        let [keyword, given @ ..] = all else { return Ok(()) };
        let place = keyword.place;
        if all.len() > MOST_WORDS {
            let message = format!("expected at most {} words after a keyword", MOST_WORDS - 1);
            return Err(vec![unreadable(place, message)]);
        }
        let one = |error| vec![error];
        let lost = &mut self.stage.lost;
        let name = keyword.shown();
        let mut lose = |what: &str| lost.add(Some(place), format!("`{name}`"), what);
        match keyword.text {
            b"v" => self.geometry.vertex(keyword, given, lost).map_err(one)?,
            b"vt" => self.geometry.uv(keyword, given).map_err(one)?,
            b"vn" => self.geometry.normal(keyword, given).map_err(one)?,
            // What faces were called in the format's second version.
            b"f" | b"fo" => {
                let has_normals =
                    self.geometry.face(keyword, given, self.current, lost).map_err(one)?;
                if self.is_smooth && !has_normals {
                    let what = "faces without normals are asked to look smooth, and look flat";
                    self.stage.lost.add(Some(place), "`s`", what);
                }
            }
            b"usemtl" => {
                let name = String::from_utf8_lossy(words.text(given)).into_owned();
                if name.is_empty() {
                    let message = "expected the name of a material after `usemtl`, found none";
                    return Err(vec![unreadable(place, message)]);
                }
                self.current = Some(self.material(name, place));
            }
            b"mtllib" => self.library.open(words, keyword, given)?,
            b"s" => {
                self.is_smooth =
                    given.first().is_some_and(|word| !matches!(word.text, b"0" | b"off"));
            }
            // Names, and how a program draws it on its screen.
            b"o" | b"g" | b"bevel" | b"c_interp" | b"d_interp" | b"lod" => {}
            b"l" => lose("lines are left out"),
            b"p" => lose("points are left out"),
            b"usemap" | b"maplib" => lose("textures are left out"),
            b"shadow_obj" | b"trace_obj" => {
                lose("another body for shadows or reflections is left out");
            }
            b"call" => lose("another file is called, which is not read"),
            b"csh" => lose("a command is called, which is not run"),
            b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"surf"
            | b"parm" | b"trim" | b"hole" | b"scrv" | b"sp" | b"end" | b"con" | b"mg"
            | b"ctech" | b"stech" | b"bzp" | b"bsp" | b"cdc" | b"cdp" | b"res" => {
                lose("free-form curves and surfaces are left out");
            }
            _ => lose("a statement that OBJ has not is left out"),
        }
        Ok(())
    }

    fn material(&mut self, name: String, place: Place) -> usize {
        let number = self.materials.len();
        *self.by_name.entry(name).or_insert_with_key(|name| {
            self.materials.push((name.clone(), place));
            number
        })
    }

    fn finish(mut self, source: &str, wishes: &Wishes) -> Result<Imported, Vec<Unreadable>> {
        let bent = self.geometry.bent;
        if bent.count > 0 {
            self.stage.chosen.push(format!(
                "{} polygons are not flat, the first at line {}: they are cut as they look along \
                 the axis that their normal is nearest to",
                bent.count, bent.first.0
            ));
        }
        let mut problems = Vec::new();
        for (part, number) in self.geometry.into_parts() {
            let used = number.and_then(|number| self.materials.get(number));
            let Some((name, place)) = used else {
                self.stage.parts.push((part, None));
                continue;
            };
            let known = self.library.find(name);
            if let Some(definition) = known {
                if !self.stage.materials.contains_key(name) {
                    let assets = self.library.assets();
                    match material::of(name, definition, assets, &mut self.stage) {
                        Ok(material) => _ = self.stage.materials.insert(name.clone(), material),
                        Err(problem) => problems.push(problem),
                    }
                }
            } else {
                let element = format!("usemtl {name}");
                let what = "no library has it: its faces are of the default material";
                self.stage.lost.add(Some(*place), element, what);
            }
            self.stage.parts.push((part, known.map(|_| name.clone())));
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        self.stage.imported(source, wishes)
    }
}
