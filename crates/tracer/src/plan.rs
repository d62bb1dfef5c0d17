//! `Plan`: what a picture needs of its scene, found before the first ray, so
//! that nothing else is done.
//!
//! Whatever is skipped cannot change a bit of the picture: the harness holds
//! every fixture, and the stress suite random scenes, against the same picture
//! made without skipping.

mod tiles;

use crate::camera::Seen;
use crate::meter::Event;
use crate::shape::Shape;
use crate::{Light, Material, Rgb, Scene, Show};
use tiles::{Members, REST, SIDE, Tiles, bit_of};

/// Whether what cannot change the picture is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Skipping {
    /// It is, always but to show that it may be.
    #[default]
    On,
    /// Every pixel sends its rays, every hit is lit by every light that the
    /// shading's formulas ask for, and each for its shadow, whatever comes of
    /// it.
    Off,
}

/// Up to this many members that a tile shows are tested one by one, which is
/// sooner done than asking which of them a ray meets: it meets most.
const FEW: u32 = 2;

/// What is done for a picture, and what is not.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    skipping: Skipping,
    tiles: Tiles,
    /// Members that are groups: two of them are sooner asked for by their boxes
    /// than entered one by one.
    groups: Members,
    notes: Vec<String>,
}

impl Plan {
    /// What this scene's picture needs.
    pub fn new(scene: &Scene, skipping: Skipping) -> Self {
        let size = scene.size();
        let census = Census::of(scene);
        if skipping == Skipping::Off {
            let notes = vec!["skips nothing, as it was asked to".to_owned()];
            return Self { skipping, tiles: Tiles::all(size, Members::MAX), groups: 0, notes };
        }
        let mut tiles = Tiles::all(size, 0);
        for (member, seen) in &census.seen {
            tiles.mark(scene.camera(), size, bit_of(*member), *seen);
        }
        let notes = census.notes(scene, &tiles);
        let groups = scene.world().inner_groups().fold(0, |all, member| all | bit_of(member));
        Self { skipping, tiles, groups, notes }
    }

    /// What is needed and what is skipped, a line each, for people.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Whether anything is skipped.
    pub fn skipping(&self) -> Skipping {
        self.skipping
    }

    /// Who may be seen in pixel `(i, j)`, row 0 at the bottom.
    pub(crate) fn candidates(&self, i: u32, j: u32) -> Candidates {
        match self.tiles.seen_in(i, j) {
            0 => Candidates::None,
            all if all & REST != 0 => Candidates::All,
            one if one.is_power_of_two() => Candidates::These(one),
            few if few.count_ones() <= FEW && few & self.groups == 0 => Candidates::These(few),
            _ => Candidates::All,
        }
    }
}

/// Which members of a group a ray may meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Candidates {
    /// None.
    None,
    /// Those whose bits are set, few enough to be tested one by one.
    These(u64),
    /// Any.
    All,
}

/// Who lives in a scene.
struct Census {
    /// Where the objects of each member are seen.
    seen: Vec<(usize, Seen)>,
    /// How many of each shape; of meshes, their triangles.
    shapes: Vec<(Event, usize)>,
    /// How many objects are lit, and how many with a highlight.
    lit: usize,
    highlights: usize,
    /// How many send rays on.
    sending: usize,
}

impl Census {
    /// Objects in groups that round more than this are taken to be seen
    /// everywhere.
    const WORST: f64 = 1e6;

    fn of(scene: &Scene) -> Self {
        let mut census =
            Self { seen: Vec::new(), shapes: Vec::new(), lit: 0, highlights: 0, sending: 0 };
        let camera = scene.camera();
        scene.world().visit(&mut |member, object, boxes, placed| {
            let (shape, material) = (object.shape(), object.material());
            match shape {
                Shape::Plane(plane) if !placed.moved => {
                    census.seen.push((member, camera.sees_plane(plane.point(), plane.across())));
                }
                _ if !(placed.rounding < Self::WORST) => {
                    census.seen.push((member, Seen::Everywhere));
                }
                _ => census.seen.extend(boxes.iter().map(|b| (member, camera.sees_box(b)))),
            }
            let (kind, count) = match shape {
                Shape::Mesh(mesh) => (Event::Triangle, mesh.triangle_count()),
                shape => (shape.event(), 1),
            };
            match census.shapes.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, sum)) => *sum += count,
                None => census.shapes.push((kind, count)),
            }
            census.lit += usize::from(material.is_lit());
            census.highlights += usize::from(material.has_highlight());
            census.sending += usize::from(material.sends_rays());
        });
        census
    }

    fn notes(&self, scene: &Scene, tiles: &Tiles) -> Vec<String> {
        let mut notes = Vec::new();
        let (seen, all) = tiles.counts();
        let samples = scene.samples().words();
        let more = match scene.error() {
            None => String::new(),
            Some(error) => format!(", more where neighbors differ, up to an error of {error}"),
        };
        notes.push(format!(
            "eye rays: {samples} a pixel{more}, in {seen} of {all} tiles of {SIDE} x {SIDE} pixels, held \
             against what the tile may show; the others are background"
        ));
        let reach = scene.filter().reach();
        notes.push(match reach {
            0 => format!("{}: a pixel is made of its own samples", scene.filter().words()),
            _ => format!(
                "{}: a pixel is made of the samples of {side} x {side} pixels",
                scene.filter().words(),
                side = 2 * reach + 1
            ),
        });
        let (mut there, mut not_there) = (Vec::new(), Vec::new());
        for kind in Event::ALL {
            let Some(words) = kind.primitive() else { continue };
            match self.shapes.iter().find(|(found, _)| *found == kind) {
                Some((_, n)) => there.push(counted(*n, words)),
                None => not_there.push(words.1),
            }
        }
        notes.push(format!(
            "shapes: {}; no code runs for {}",
            if there.is_empty() { "none".to_owned() } else { there.join(", ") },
            if not_there.is_empty() { "others".to_owned() } else { not_there.join(", ") }
        ));
        notes.extend(self.shading_notes(scene));
        notes
    }

    fn shading_notes(&self, scene: &Scene) -> Vec<String> {
        if scene.show() != Show::Shaded {
            return vec!["shading: none, the picture does not show light".to_owned()];
        }
        let mut notes = self.lit_notes(scene);
        if self.sending > 0 {
            let senders = counted(self.sending, ("object", "objects"));
            let times = counted(scene.bounces() as usize, ("time", "times"));
            notes.push(format!(
                "reflected and refracted rays: from {senders}, up to {times} one after the other, \
                 held against everything; none where it would add nothing"
            ));
        }
        notes
    }

    fn lit_notes(&self, scene: &Scene) -> Vec<String> {
        if self.lit == 0 {
            return vec!["shading: none, no object is lit".to_owned()];
        }
        let (dark, lights): (Vec<Light>, Vec<Light>) =
            scene.lights().iter().partition(|light| light.intensity() == Rgb::BLACK);
        let casting = lights.iter().filter(|light| light.casts_shadows()).count();
        let lit_by = counted(lights.len(), ("light", "lights"));
        let shading = match dark.len() {
            0 => format!("shading: {lit_by}"),
            n => format!("shading: {lit_by}; {n} of no intensity skipped"),
        };
        let shadows = match (casting, scene.shadows()) {
            (0, _) => "none, no light casts shadows".to_owned(),
            (_, false) => "none, the scene has no shadows".to_owned(),
            (n, true) => {
                let lights = counted(n, ("light", "lights"));
                format!("towards {lights}, from where that would add anything")
            }
        };
        let highlights = match self.highlights {
            0 => "none, no object has a highlight".to_owned(),
            n => format!("on {} with a highlight", counted(n, ("object", "objects"))),
        };
        vec![shading, format!("shadow rays: {shadows}"), format!("half vectors: {highlights}")]
    }
}

/// `1 thing` or `7 things`.
fn counted(n: usize, (one, many): (&str, &str)) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

impl Material {
    /// Whether light changes what it shows.
    fn is_lit(&self) -> bool {
        match self {
            Self::Lambert { .. }
            | Self::BlinnPhong { .. }
            | Self::Whitted { .. }
            | Self::Glazed { .. } => true,
            Self::Constant(_) | Self::Normal | Self::Mirror { .. } | Self::Dielectric { .. } => {
                false
            }
        }
    }

    /// Whether it has a highlight to compute.
    pub(crate) fn has_highlight(&self) -> bool {
        match self {
            Self::BlinnPhong { specular, .. }
            | Self::Whitted { specular, .. }
            | Self::Glazed { specular, .. } => *specular != Rgb::BLACK,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests;
