//! `Reader`: the scene element, part by part in the file's order.

use std::collections::BTreeMap;

use roxmltree::Node;
use scene::Assets;
use scene::format::{Light, Material, Object, Shading};

use super::element::{Element, Notes, name_of, written_name};
use super::{shading, specular};
use crate::import::files::Files;
use crate::import::report::Report;
use crate::import::sense::Sense;
use crate::import::text::Text;
use crate::import::{Imported, Unreadable, Wishes};

/// What is read so far, and what reading needs.
pub(super) struct Reader<'a> {
    pub(super) notes: Notes<'a>,
    pub(super) assets: &'a dyn Assets,
    pub(super) files: Files,
    pub(super) sense: Sense,
    pub(super) shading: Shading,
    pub(super) materials: BTreeMap<String, Material>,
    pub(super) lights: Vec<Light>,
    /// How many surfaces a ray is followed over.
    pub(super) bounces: u32,
}

impl<'a> Reader<'a> {
    /// A reader of this text.
    ///
    /// # Errors
    /// None that any text has.
    pub(super) fn new(text: &'a Text<'a>, assets: &'a dyn Assets) -> Result<Self, Vec<Unreadable>> {
        let sense = Sense::new().ok_or_else(|| {
            let message = "this build cannot judge scenes".to_owned();
            vec![Unreadable { place: None, message, help: None }]
        })?;
        let bounces = sense.blank().bounces;
        Ok(Self {
            bounces,
            notes: Notes { text, report: Report::default() },
            assets,
            files: Files::default(),
            sense,
            shading: Shading::default(),
            materials: BTreeMap::new(),
            lights: Vec::new(),
        })
    }

    /// Reads the whole file.
    pub(super) fn scene(
        mut self,
        root: Element<'_>,
        wishes: &Wishes,
    ) -> Result<Imported, Vec<Unreadable>> {
        if name_of(root) != "scene" {
            self.notes.unreadable(root, "expected the element scene", None);
            return self.notes.report.finish(self.sense.blank(), BTreeMap::new());
        }
        self.notes.only_attributes(root, &[]);
        self.notes.no_text(root);
        self.choose_shading(root, wishes);
        // Shaders first: a surface may name one that stands after it.
        let shaders = || root.children().filter(|node| name_of(*node) == "shader");
        let stand_last = [false, true].into_iter().flat_map(|on_another| {
            shaders().filter(move |node| specular::stands_on_another(node) == on_another)
        });
        stand_last.for_each(|node| self.named_shader(node));
        let mut file = self.sense.blank();
        let (mut camera, mut image) = (None, None);
        let (mut exposure, mut background) = (None, None);
        let mut objects: Vec<Object> = Vec::new();
        for node in root.children().filter(Node::is_element) {
            let before = match name_of(node).as_str() {
                "shader" => continue,
                "surface" => {
                    objects.extend(self.surface(node, 0));
                    continue;
                }
                "light" => {
                    self.light(node);
                    continue;
                }
                "camera" => camera.replace(node),
                "image" => image.replace(node),
                "exposure" => exposure.replace(node),
                "backcolor" | "background" => background.replace(node),
                _ => {
                    self.notes.lost(node, "is not known inside scene and is left out");
                    continue;
                }
            };
            if let Some(before) = before {
                self.notes.lost(before, "stands twice in one element: only the last one counts");
            }
        }
        file.shading = self.shading;
        if let Some(image) = self.image(image, wishes) {
            file.image = image;
        }
        if let Some(camera) = self.camera(camera, file.image, wishes) {
            file.camera = camera;
        }
        if let Some((node, [exposure])) = self.held(exposure) {
            file.exposure = exposure;
            let problems = self.sense.of(|file| file.exposure = exposure);
            self.judge(node, problems);
        }
        if let Some((node, background)) = self.held(background) {
            file.background = background;
            let problems = self.sense.of(|file| file.background = background);
            self.judge(node, problems);
        }
        file.objects = objects;
        file.materials = self.materials;
        file.lights = self.lights;
        file.bounces = self.bounces;
        self.notes.report.finish(file, self.files.into_map())
    }

    fn choose_shading(&mut self, root: Element<'_>, wishes: &Wishes) {
        if let Some(shading) = wishes.shading {
            self.notes.report.chose(format!("{shading:?} shading, as was asked"));
            self.shading = shading;
            return;
        }
        let (shading, why) = shading::guess(root);
        self.notes.report.chose(format!(
            "{shading:?} shading, as {why}: the file itself does not say which of the course's \
             three conventions it means"
        ));
        self.shading = shading;
    }

    /// The numbers of an element that need not be there.
    fn held<'t, const N: usize>(
        &mut self,
        node: Option<Element<'t>>,
    ) -> Option<(Element<'t>, [f64; N])> {
        let node = node?;
        self.notes.numbers(node).map(|numbers| (node, numbers))
    }

    /// The picture's size.
    fn image(&mut self, node: Option<Element<'_>>, wishes: &Wishes) -> Option<(u32, u32)> {
        /// No picture has more pixels on a side.
        const MOST: f64 = 1e9;
        let size = |numbers: [f64; 2]| {
            let is_whole = |x: &f64| x.fract() == 0.0 && (0.0..MOST).contains(x);
            numbers.iter().all(is_whole).then(|| (numbers[0] as u32, numbers[1] as u32))
        };
        if let Some(asked) = wishes.image {
            self.notes.report.chose(format!("{} x {} pixels, as was asked", asked.0, asked.1));
            return Some(asked);
        }
        let Some(node) = node else {
            let message = "expected an element image with the picture's size, found none";
            self.notes.report.missing(message, "say it beside the file, as 320x240");
            return None;
        };
        let numbers: [f64; 2] = self.notes.numbers(node)?;
        let Some(size) = size(numbers) else {
            self.notes.unreadable(node, "expected two whole numbers of pixels", None);
            return None;
        };
        let problems = self.sense.of(|file| file.image = size);
        self.judge(node, problems).then_some(size)
    }

    /// Reports what makes no sense in an element; whether nothing did.
    pub(super) fn judge(&mut self, node: Element<'_>, problems: Vec<String>) -> bool {
        let makes_sense = problems.is_empty();
        for problem in problems {
            self.notes.unreadable(node, &problem, None);
        }
        makes_sense
    }

    /// The type of an element in lower case; `default` where it has none, or a
    /// problem where there is no default.
    pub(super) fn kind(&mut self, node: Element<'_>, default: Option<&str>) -> Option<String> {
        let written = super::element::attribute(node, "type").or(default);
        if written.is_none() {
            let what = format!("expected {} type=\"...\"", written_name(node));
            self.notes.unreadable(node, &what, None);
        }
        written.map(str::to_ascii_lowercase)
    }
}
