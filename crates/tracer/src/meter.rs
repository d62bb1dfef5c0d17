//! `Meter`: what a render does, counted where somebody asks and free where
//! nobody does.
//!
//! Everything on the way of a ray takes a meter as a type parameter. The
//! pictures are made with [`Unmetered`], of which nothing is left when it is
//! compiled.

use std::cell::Cell;
use std::ops::AddAssign;

use crate::Skipping;
use crate::group::Occluder;
use crate::simd::{self, Level};

/// Something that is counted.
pub(crate) trait Meter {
    /// It happened once more.
    fn count(&self, event: Event);
    /// It happened so many times more; they are counted only if that is asked.
    fn count_many(&self, event: Event, times: impl FnOnce() -> usize);
    /// Does work that is counted like this, at this level or plainly.
    fn run<W: simd::Work>(level: Level, work: W) -> W::Output;
}

/// Counts nothing.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Unmetered;

impl Meter for Unmetered {
    #[inline(always)]
    fn count(&self, _: Event) {}
    #[inline(always)]
    fn count_many(&self, _: Event, _: impl FnOnce() -> usize) {}
    #[inline(always)]
    fn run<W: simd::Work>(level: Level, work: W) -> W::Output {
        level.run(work)
    }
}

/// Counts everything, for one thread.
#[derive(Debug, Default)]
pub(crate) struct Counter([Cell<u64>; Event::ALL.len()]);

impl Meter for Counter {
    #[inline]
    fn count(&self, event: Event) {
        self.count_many(event, || 1);
    }
    #[inline]
    fn count_many(&self, event: Event, times: impl FnOnce() -> usize) {
        let cell = &self.0[event as usize];
        cell.set(cell.get() + times() as u64);
    }
    /// Plainly, so that the counts are the same on every processor of a kind.
    #[inline]
    fn run<W: simd::Work>(_: Level, work: W) -> W::Output {
        simd::run_plainly(work)
    }
}

macro_rules! events {
    ($($(#[$doc:meta])* $name:ident $word:literal,)*) => {
        /// What is counted.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Event {
            $($(#[$doc])* $name,)*
        }

        impl Event {
            /// Every event, in the order of their declaration.
            pub const ALL: [Self; [$(Event::$name,)*].len()] = [$(Self::$name,)*];

            /// Its name in files and tables.
            pub fn name(self) -> &'static str {
                match self { $(Self::$name => $word,)* }
            }
        }
    };
}

events! {
    /// A pixel whose samples were traced.
    Pixel "pixels",
    /// A pixel of a tile that nothing is seen in, so that no ray was sent.
    SkippedPixel "pixels_skipped",
    /// A pixel that got more samples, as its neighborhood differs.
    RefinedPixel "pixels_refined",
    /// A ray from the camera: one for each sample.
    EyeRay "eye_rays",
    /// A hit whose light was added up.
    ShadedHit "shaded_hits",
    /// A half vector between light and eye, and its power.
    HalfVector "half_vectors",
    /// A ray towards a light.
    ShadowRay "shadow_rays",
    /// One that was not needed, as its light would add nothing.
    SkippedShadowRay "shadow_rays_skipped",
    /// A ray that a surface reflects.
    ReflectedRay "reflected_rays",
    /// A ray that a surface lets through.
    RefractedRay "refracted_rays",
    /// A ray taken into a group's space.
    Group "groups_entered",
    /// A ray held against the boxes of a node of a hierarchy, eight together.
    Node "node_tests",
    /// A ray held against a sphere.
    Sphere "sphere_tests",
    /// A ray held against a triangle, alone or of a mesh.
    Triangle "triangle_tests",
    /// A ray held against a box.
    AxisBox "box_tests",
    /// A ray held against a plane.
    Plane "plane_tests",
    /// A ray held against a disk.
    Disk "disk_tests",
    /// A ray held against a cylinder.
    Cylinder "cylinder_tests",
    /// A ray held against a cone.
    Cone "cone_tests",
    /// A ray held against a torus.
    Torus "torus_tests",
    /// A ray sent through a mesh.
    Mesh "meshes_entered",
}

impl Event {
    /// Whether it is a ray held against a primitive.
    pub fn is_primitive_test(self) -> bool {
        self.primitive().is_some()
    }

    /// The primitive that a ray is held against, and several of it; `None` if
    /// it is another event.
    pub(crate) fn primitive(self) -> Option<(&'static str, &'static str)> {
        match self {
            Self::Sphere => Some(("sphere", "spheres")),
            Self::Triangle => Some(("triangle", "triangles")),
            Self::AxisBox => Some(("box", "boxes")),
            Self::Plane => Some(("plane", "planes")),
            Self::Disk => Some(("disk", "disks")),
            Self::Cylinder => Some(("cylinder", "cylinders")),
            Self::Cone => Some(("cone", "cones")),
            Self::Torus => Some(("torus", "tori")),
            Self::Pixel
            | Self::SkippedPixel
            | Self::RefinedPixel
            | Self::EyeRay
            | Self::ShadedHit
            | Self::HalfVector
            | Self::ShadowRay
            | Self::SkippedShadowRay
            | Self::ReflectedRay
            | Self::RefractedRay
            | Self::Group
            | Self::Node
            | Self::Mesh => None,
        }
    }
}

/// What those who trace one row of pixels carry along.
pub(crate) struct Work<M> {
    /// Counts what they do.
    pub(crate) meter: M,
    /// Whether what changes nothing is left out.
    pub(crate) skipping: Skipping,
    /// For each light, who was last in its way: likely to be again.
    pub(crate) occluders: Vec<Cell<Option<Occluder>>>,
}

impl<M: Meter> Work<M> {
    /// Nothing done yet, for this many lights.
    pub(crate) fn new(meter: M, skipping: Skipping, lights: usize) -> Self {
        Self { meter, skipping, occluders: vec![Cell::new(None); lights] }
    }

    /// It happened once more.
    pub(crate) fn count(&self, event: Event) {
        self.meter.count(event);
    }

    /// Whether what changes nothing is left out.
    pub(crate) fn skips(&self) -> bool {
        self.skipping == Skipping::On
    }
}

/// How often everything happened while a picture was made. The same for any
/// number of threads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stats([u64; Event::ALL.len()]);

impl Stats {
    /// How often this happened.
    pub fn get(&self, event: Event) -> u64 {
        self.0[event as usize]
    }

    /// How many times a ray was held against a primitive, of any kind.
    pub fn primitive_tests(&self) -> u64 {
        let tests = Event::ALL.into_iter().filter(|event| event.is_primitive_test());
        tests.map(|event| self.get(event)).sum()
    }
}

impl From<Counter> for Stats {
    fn from(counter: Counter) -> Self {
        Self(counter.0.map(Cell::into_inner))
    }
}

impl AddAssign for Stats {
    fn add_assign(&mut self, other: Self) {
        for (mine, others) in self.0.iter_mut().zip(other.0) {
            *mine += others;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_add_up() {
        let counter = Counter::default();
        for event in [Event::Sphere, Event::Triangle, Event::Sphere, Event::Node] {
            counter.count(event);
        }
        let mut stats = Stats::from(counter);
        stats += stats;
        assert_eq!((stats.get(Event::Sphere), stats.get(Event::Node)), (4, 2));
        assert_eq!(stats.primitive_tests(), 6);
    }
}
