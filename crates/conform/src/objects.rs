//! `Objects`: what each pixel of a fixture shows, by the names of its file.

use harness::fixture::{Build, Fixture};
use harness::suite::Suite;
use scene::Place;
use tracer::objects_seen;

/// What is in the middle of each pixel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Objects {
    /// The object's number, `None` for the background; row by row from the top.
    seen: Vec<Option<u32>>,
    /// Where each object is written, by number.
    places: Vec<Place>,
}

/// What the pixels of a fixture of a suite show; `None` where it is none.
pub fn objects_of(suite: &Suite, name: &str) -> Option<Objects> {
    let label = Suite::fixture_label(name);
    let fixture = Fixture::open(&label, &suite.fixture_path(name), Build::default());
    fixture.ok().as_ref().map(Objects::of)
}

impl Objects {
    /// What the pixels of this fixture show.
    pub fn of(fixture: &Fixture) -> Self {
        let seen = objects_seen(&fixture.scene);
        let seen = seen.into_iter().map(|object| object.map(|object| object.0)).collect();
        Self { seen, places: fixture.object_places() }
    }

    /// What a pixel shows, by its place in the rows, as the rest of a sentence
    /// that begins with "on": "the Torus of line 10", "the background".
    pub fn at(&self, pixel: usize) -> Option<Seen> {
        Some(self.seen_as(*self.seen.get(pixel)?))
    }

    /// What most of these pixels show, the first of equals, and how many do.
    pub fn most(&self, pixels: impl Iterator<Item = usize>) -> Option<(Seen, u64)> {
        let mut counts: Vec<(Option<u32>, u64)> = Vec::new();
        for object in pixels.filter_map(|pixel| self.seen.get(pixel)) {
            match counts.iter_mut().find(|(known, _)| known == object) {
                Some((_, count)) => *count += 1,
                None => counts.push((*object, 1)),
            }
        }
        // `max_by_key` takes the last of equals.
        let (object, count) = counts.into_iter().rev().max_by_key(|(_, count)| *count)?;
        Some((self.seen_as(object), count))
    }

    fn seen_as(&self, object: Option<u32>) -> Seen {
        Seen { object: object.and_then(|number| self.places.get(number as usize).cloned()) }
    }
}

/// An object, or the background.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Seen {
    /// Where it is written; `None` for the background.
    pub object: Option<Place>,
}

impl Seen {
    /// In words, with the file that it is written in: "the Torus of
    /// fixtures/a.ron:10:9", "the background".
    pub fn words(&self, file: &str) -> String {
        match &self.object {
            Some(Place { kind, line, column }) => format!("the {kind} of {file}:{line}:{column}"),
            None => "the background".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scene::NoAssets;

    const TWO: &str = "(version: 1, image: (4, 1), show: Silhouette,
        camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 1),
        objects: [
            Box(min: (-2, -2, 0), max: (-1, 2, 0)),
            Group(objects: [Box(min: (-1, -2, 0), max: (1, 2, 0))]),
        ])";

    #[test]
    fn pixels_are_told_by_what_is_in_their_middle() {
        let fixture = Fixture::read("two", TWO, &NoAssets, Build::Bvh).unwrap();
        let objects = Objects::of(&fixture);
        let at = |pixel| objects.at(pixel).map(|seen| seen.words("f"));
        assert_eq!(at(0).unwrap(), "the Box of f:4:13");
        assert_eq!(at(1).unwrap(), "the Box of f:5:29");
        assert_eq!(at(3).unwrap(), "the background");
        assert_eq!(at(4), None);
        let most = |pixels: &[usize]| {
            let most = objects.most(pixels.iter().copied());
            most.map(|(seen, count)| (seen.object.map(|place| place.line), count))
        };
        assert_eq!(most(&[0, 1, 2, 3]), Some((Some(5), 2)));
        assert_eq!(most(&[3, 0]), Some((None, 1)), "the first of equals");
        assert_eq!(most(&[]), None);
        assert_eq!(most(&[9]), None);
    }
}
