//! MTL: the materials of an OBJ file, as they are written.

use std::collections::BTreeMap;

use scene::format::Triple;

use super::map::Map;
use crate::import::Unreadable;
use crate::import::mesh::unreadable;
use crate::import::mesh::words::{MOST_WORDS, Place, Word, Words};

/// What a library says of a material, the last where it says something twice.
#[derive(Debug, Clone, Default)]
pub(super) struct Definition {
    /// The library's name and where the OBJ file names it.
    pub(super) file: String,
    pub(super) place: Place,
    /// Colors: ambient, diffuse, specular, emitted, and of what goes through.
    pub(super) ka: Option<Triple>,
    pub(super) kd: Option<Triple>,
    pub(super) ks: Option<Triple>,
    pub(super) ke: Option<Triple>,
    pub(super) tf: Option<Triple>,
    /// The highlight's exponent.
    pub(super) ns: Option<f64>,
    /// The index of refraction.
    pub(super) ni: Option<f64>,
    /// How opaque it is: 1 is fully.
    pub(super) d: Option<f64>,
    /// The model's number.
    pub(super) illum: Option<u32>,
    /// The texture of the diffuse color.
    pub(super) map_kd: Option<Map>,
    /// The lines of what is said, by keyword.
    pub(super) lines: BTreeMap<&'static str, usize>,
    /// What else is said: the line, the statement's keyword, what it is.
    pub(super) others: Vec<(usize, String, &'static str)>,
}

/// Adds the materials of a library; of one that is there already the first
/// counts, and that is said.
pub(super) fn read(
    file: &str,
    place: Place,
    bytes: &[u8],
    materials: &mut BTreeMap<String, Definition>,
    problems: &mut Vec<Unreadable>,
) {
    /// The most mistakes of a library that are told.
    const MOST_PROBLEMS: usize = 100;
    let mut current: Option<(String, Definition)> = None;
    let mut words = Words::with_comments(bytes);
    let mut statement = Vec::new();
    let keep = |done: Option<(String, Definition)>, all: &mut BTreeMap<String, Definition>| {
        let Some((name, definition)) = done else { return };
        if let Some(first) = all.get_mut(&name) {
            let line = definition.lines.get("newmtl").copied().unwrap_or_default();
            first.others.push((line, "newmtl".to_owned(), "a second material of the same name"));
        } else {
            all.insert(name, definition);
        }
    };
    while words.next_statement(&mut statement) && problems.len() < MOST_PROBLEMS {
        let [keyword, given @ ..] = &statement[..] else { continue };
        let line = keyword.place.0;
        if keyword.text == b"newmtl" {
            keep(current.take(), materials);
            let name = String::from_utf8_lossy(words.text(given)).into_owned();
            let mut definition =
                Definition { file: file.to_owned(), place, ..Definition::default() };
            definition.lines.insert("newmtl", line);
            current = Some((name, definition));
            continue;
        }
        let said = match &mut current {
            Some(_) if statement.len() > MOST_WORDS => Err("expected fewer words".to_owned()),
            Some((_, definition)) => definition.say(&words, keyword, given),
            None => Err(format!("expected `newmtl` before `{}`", keyword.shown())),
        };
        if let Err(why) = said {
            let message = format!("{file}:{line}:{}: {why}", keyword.place.1);
            problems.push(unreadable(place, message));
        }
    }
    keep(current, materials);
}

impl Definition {
    fn say<'a>(
        &mut self,
        words: &Words<'a>,
        keyword: &Word<'a>,
        given: &[Word<'a>],
    ) -> Result<(), String> {
        let line = keyword.place.0;
        let lower = keyword.text.to_ascii_lowercase();
        let colors: [(&[u8], &'static str, &mut Option<Triple>); 5] = [
            (b"ka", "Ka", &mut self.ka),
            (b"kd", "Kd", &mut self.kd),
            (b"ks", "Ks", &mut self.ks),
            (b"ke", "Ke", &mut self.ke),
            (b"tf", "Tf", &mut self.tf),
        ];
        for (name, shown, field) in colors {
            if lower == name {
                if given.first().is_some_and(|word| matches!(word.text, b"spectral" | b"xyz")) {
                    let what = "a color by its spectrum or in CIE XYZ";
                    self.others.push((line, shown.to_owned(), what));
                } else {
                    *field = Some(color(given)?);
                    self.lines.insert(shown, line);
                }
                return Ok(());
            }
        }
        let mut set = |name: &'static str, field: fn(&mut Self) -> &mut Option<f64>, x: f64| {
            *field(self) = Some(x);
            self.lines.insert(name, line);
        };
        match &lower[..] {
            b"ns" => set("Ns", |all| &mut all.ns, one(given)?),
            b"ni" => set("Ni", |all| &mut all.ni, one(given)?),
            b"tr" => set("Tr", |all| &mut all.d, 1.0 - share(given)?),
            b"d" => {
                if let [halo, rest @ ..] = given
                    && halo.text == b"-halo"
                {
                    self.others.push((line, "d -halo".to_owned(), "opacity by the angle"));
                    share(rest)?;
                } else {
                    set("d", |all| &mut all.d, share(given)?);
                }
            }
            b"illum" => {
                let [word] = given else { return Err(expected("one whole number", given)) };
                self.illum = Some(word.whole()?);
                self.lines.insert("illum", line);
            }
            b"map_kd" => {
                self.map_kd = Some(Map::of(given, |file| words.text(file))?);
                self.lines.insert("map_Kd", line);
            }
            // How sharp reflections of an environment are, of which there is none,
            // and whether textures are smoothed beyond one pixel.
            b"sharpness" | b"map_aat" => {}
            _ => self.others.push((line, keyword.shown(), other(&lower))),
        }
        Ok(())
    }
}

/// What a statement is that a picture here does not show.
fn other(lower: &[u8]) -> &'static str {
    match lower {
        b"bump" | b"map_bump" | b"norm" | b"disp" | b"map_disp" => "a surface's relief",
        b"refl" => "an environment that it reflects",
        b"pr" | b"pm" | b"ps" | b"pc" | b"pcr" | b"aniso" | b"anisor" => {
            "a property of physically based materials"
        }
        _ if lower.starts_with(b"map_") || lower == b"decal" => "a texture",
        _ => "a statement that MTL has not",
    }
}

fn color(given: &[Word<'_>]) -> Result<Triple, String> {
    match given {
        [gray] => Ok([positive(gray)?; 3]),
        [r, g, b] => Ok([positive(r)?, positive(g)?, positive(b)?]),
        _ => Err(expected("one or three numbers", given)),
    }
}

fn one(given: &[Word<'_>]) -> Result<f64, String> {
    let [word] = given else { return Err(expected("one number", given)) };
    positive(word)
}

fn share(given: &[Word<'_>]) -> Result<f64, String> {
    let x = one(given)?;
    if x <= 1.0 { Ok(x) } else { Err(format!("expected a number from 0 to 1, found {x}")) }
}

fn positive(word: &Word<'_>) -> Result<f64, String> {
    /// The tracer's own limit.
    const LARGEST: f64 = 1e60;
    let x = word.number()?;
    let is_fine = (0.0..=LARGEST).contains(&x);
    is_fine.then_some(x).ok_or_else(|| format!("expected a number from 0, found {}", word.shown()))
}

fn expected(what: &str, given: &[Word<'_>]) -> String {
    format!("expected {what}, found {} words", given.len())
}
