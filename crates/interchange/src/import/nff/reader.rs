//! `Reader`: the elements of a file, one after the other.

use std::collections::BTreeMap;

use scene::format::{Light, Material, Object};

use super::polygons::Polygons;
use super::view::View;
use super::words::{Word, Words};
use crate::import::files::Files;
use crate::import::report::Report;
use crate::import::sense::Sense;
use crate::import::text::{Text, shown};
use crate::import::{Imported, Unreadable, Wishes};

/// The most objects that are kept: more do not go into a scene file, whose
/// limit they pass with 40 bytes each.
const MOST_OBJECTS: usize = scene::MAX_SCENE_BYTES / 40;

/// What is read so far, and what reading needs.
pub(super) struct Reader<'a> {
    pub(super) text: &'a Text<'a>,
    pub(super) words: Words<'a>,
    pub(super) report: Report,
    pub(super) sense: Sense,
    pub(super) view: View,
    pub(super) background: Option<[f64; 3]>,
    /// Positions and colors, where they say one.
    lights: Vec<([f64; 3], Option<[f64; 3]>)>,
    pub(super) materials: BTreeMap<String, Material>,
    /// The material of what follows.
    pub(super) fill: Option<String>,
    pub(super) objects: Vec<Object>,
    pub(super) polygons: Polygons,
}

impl<'a> Reader<'a> {
    /// A reader of this text; meshes are named by its file's name.
    ///
    /// # Errors
    /// None that any text has.
    pub(super) fn new(text: &'a Text<'a>, name: &str) -> Result<Self, Vec<Unreadable>> {
        let sense = Sense::new().ok_or_else(|| {
            let message = "this build cannot judge scenes".to_owned();
            vec![Unreadable { place: None, message, help: None }]
        })?;
        Ok(Self {
            text,
            words: Words::of(text.text),
            report: Report::default(),
            sense,
            view: View::default(),
            background: None,
            lights: Vec::new(),
            materials: BTreeMap::new(),
            fill: None,
            objects: Vec::new(),
            polygons: Polygons::named_like(name),
        })
    }

    /// Reads the whole file.
    pub(super) fn scene(mut self, wishes: &Wishes) -> Result<Imported, Vec<Unreadable>> {
        while let Some(word) = self.words.next() {
            self.element(word);
            if self.objects.len() > MOST_OBJECTS {
                let message = format!(
                    "expected at most {MOST_OBJECTS} spheres, cones and cylinders, which is what a \
                     scene file can hold, found more"
                );
                let help = "make a smaller one: the databases' programs take a size";
                self.report.unreadable(|| self.text.place(word.at), message, Some(help));
                break;
            }
        }
        let mut file = self.sense.blank();
        if let Some((camera, image)) = self.camera(wishes) {
            (file.camera, file.image) = (camera, image);
        }
        file.background = self.background.unwrap_or_default();
        file.lights = self.lights();
        if let Some(shading) = wishes.shading {
            file.shading = shading;
            self.report.chose(format!("{shading:?} shading, as was asked"));
        }
        let mut files = Files::default();
        let polygons = self.polygons.objects(&mut files);
        file.objects = self.objects;
        file.objects.extend(polygons);
        file.materials = self.materials;
        self.report.finish(file, files.into_map())
    }

    fn element(&mut self, word: Word<'a>) {
        let read = match word.text {
            "b" => self.background(word),
            "v" => {
                self.viewpoint(word);
                Some(())
            }
            "from" | "at" | "up" | "angle" | "hither" | "resolution" => self.view_field(word),
            "l" => self.light(word),
            "f" => self.fill(word),
            "s" => self.sphere(word),
            "c" => self.cone(word),
            "p" => self.polygon(word),
            "pp" => self.patch(word),
            _ if word.is_name() => {
                self.lost(word, "is not known and is left out");
                self.words.skip_element();
                Some(())
            }
            _ => {
                let message =
                    format!("expected an element's letter, found \"{}\"", shown(word.text));
                self.unreadable(word.at, message);
                None
            }
        };
        if read.is_none() {
            self.words.skip_element();
        }
    }

    /// `N` numbers; `None` with a problem.
    pub(super) fn numbers<const N: usize>(&mut self, of: Word<'_>) -> Option<[f64; N]> {
        let mut numbers = [0.0; N];
        for (i, slot) in numbers.iter_mut().enumerate() {
            match self.words.number() {
                Ok(number) => *slot = number,
                Err((at, why)) => {
                    let message = format!("{}, number {} of {N}: {why}", of.text, i + 1);
                    self.unreadable(at, message);
                    return None;
                }
            }
        }
        Some(numbers)
    }

    pub(super) fn unreadable(&mut self, at: usize, message: String) {
        self.report.unreadable(|| self.text.place(at), message, None);
    }

    pub(super) fn lost(&mut self, word: Word<'_>, what: impl Into<String>) {
        self.report.lost(|| self.text.place(word.at), word.text, what);
    }

    /// Reports what makes no sense in an element; whether nothing did.
    pub(super) fn judge(&mut self, word: Word<'_>, problems: Vec<String>) -> bool {
        let makes_sense = problems.is_empty();
        for problem in problems {
            self.unreadable(word.at, format!("{}: {problem}", word.text));
        }
        makes_sense
    }

    fn background(&mut self, word: Word<'_>) -> Option<()> {
        let color = self.numbers(word)?;
        if self.background.replace(color).is_some() {
            self.lost(word, "stands twice: only the last one counts");
        }
        let problems = self.sense.of(|file| file.background = color);
        self.judge(word, problems).then_some(())
    }

    /// A position, and a color where three more numbers are in the line.
    fn light(&mut self, word: Word<'_>) -> Option<()> {
        let position = self.numbers(word)?;
        let has_color = self.words.peek().is_some_and(|next| !next.begins_line && !next.is_name());
        let color = if has_color { Some(self.numbers(word)?) } else { None };
        let light = Light::Point { position, intensity: color.unwrap_or([1.0; 3]), falloff: None };
        let problems = self.sense.of(|file| file.lights = vec![light]);
        if self.judge(word, problems) {
            self.lights.push((position, color));
        }
        Some(())
    }

    /// All lights: `n` of them without a color are `sqrt(n) / (2 n)` bright.
    fn lights(&mut self) -> Vec<Light> {
        let n = self.lights.len() as f64;
        let equal = n.sqrt() / (2.0 * n);
        if self.lights.iter().any(|(_, color)| color.is_none()) {
            let what =
                format!("lights without a color are sqrt(n)/(2n) = {equal:?} bright, n = {n}");
            self.report.chose(what);
        }
        let light = |&(position, color): &([f64; 3], Option<[f64; 3]>)| Light::Point {
            position,
            intensity: color.unwrap_or([equal; 3]),
            falloff: None,
        };
        self.lights.iter().map(light).collect()
    }
}
