//! Making a mesh: its numbers are checked, its triangles put into blocks.

use glam::DVec3;
use rayon::prelude::*;

use super::blocks::{Blocks, Corners, LANES, NOBODY};
use super::{Mesh, MeshNormals, Order};
use crate::accel::wide::{Candidates, Gathered, Leaf, MOST_PLACES, Options, Span, Wide};
use crate::accel::{Build, List};
use crate::math::max_abs;
use crate::refused::{Refusal, point, refuse_unless};
use crate::shape::triangle;
use crate::{Aabb, Refused};

/// How many places more than triangles there may be in the leaves, in shares of
/// those: long triangles then stand in several.
const EXTRA: f64 = 0.2;

/// How many times more than in `f64` hits are off that are met in `f32`.
const FAST_ROUNDING: f64 = f32::EPSILON as f64 / f64::EPSILON;

/// Up to this many triangles are met without a hierarchy: two blocks, which is
/// less work than a node.
const FEW: usize = 2 * LANES;

/// Corners and faces are checked by this many at a time.
const CHUNK: usize = 1 << 13;

/// Triangles, of which those count that have an area.
struct Triangles<'a> {
    corners: Corners<'a>,
    /// The largest coordinate of any vertex.
    largest: f64,
}

impl Candidates for Triangles<'_> {
    fn count(&self) -> u32 {
        self.corners.faces.len() as u32
    }
    #[inline(always)]
    fn bounds(&self, number: u32) -> Option<Aabb> {
        let corners = self.corners.of(number);
        triangle::has_normal(corners).then(|| triangle::bounds(corners))
    }
    #[inline(always)]
    fn corners(&self, number: u32) -> Option<[DVec3; 3]> {
        Some(self.corners.of(number))
    }
    fn largest(&self) -> f64 {
        self.largest
    }
}

/// What is known of all vertices.
#[derive(Clone, Copy)]
struct Vertices {
    /// The largest coordinate; anything where one is not finite.
    largest: f64,
    /// Whether all are numbers of `f32`.
    are_single: bool,
}

impl Vertices {
    const NONE: Self = Self { largest: 0.0, are_single: true };

    fn of(vertices: &[DVec3]) -> Self {
        let chunk = |some: &[DVec3]| {
            let (mut largest, mut are_single) = (DVec3::ZERO, true);
            for &v in some {
                largest = largest.max(v.abs());
                are_single &= v.as_vec3().as_dvec3() == v;
            }
            Self { largest: largest.max_element(), are_single }
        };
        vertices.par_chunks(CHUNK).map(chunk).reduce(|| Self::NONE, Self::with)
    }

    fn with(self, other: Self) -> Self {
        let are_single = self.are_single && other.are_single;
        Self { largest: self.largest.max(other.largest), are_single }
    }
}

/// The highest index of any face.
fn highest(faces: &[[u32; 3]]) -> Option<u32> {
    let chunk = |some: &[[u32; 3]]| some.as_flattened().iter().copied().max();
    faces.par_chunks(CHUNK).filter_map(chunk).max()
}

/// The first vertex that is not one.
fn bad_vertex(vertices: &[DVec3]) -> Option<Refusal> {
    vertices.par_iter().with_min_len(CHUNK).find_map_first(|&v| point("vertices", v))
}

fn normals_fit(normals: &MeshNormals, faces: usize) -> bool {
    let count = normals.normals.len();
    normals.faces.len() == faces
        && highest(&normals.faces).is_none_or(|i| (i as usize) < count)
        && normals.normals.iter().all(|n| n.is_finite())
}

impl Mesh {
    /// A mesh from its corners and, for each triangle, the indices of its
    /// three.
    ///
    /// # Errors
    /// Refuses a mesh without a triangle that has an area, corners or normals that are not
    /// finite, an index out of range, and normals for another number of
    /// triangles.
    // It stands for them from then on.
    #[allow(clippy::needless_pass_by_value)]
    pub fn new(
        vertices: Vec<DVec3>,
        faces: Vec<[u32; 3]>,
        normals: Option<MeshNormals>,
        build: Build,
    ) -> Result<Self, Refused> {
        let highest = highest(&faces);
        Refused::unless([
            bad_vertex(&vertices),
            refuse_unless(!faces.is_empty(), "faces", "at least one triangle", || "none".into()),
            refuse_unless(
                faces.len() <= MOST_PLACES,
                "faces",
                format!("at most {MOST_PLACES} triangles"),
                || faces.len().to_string(),
            ),
            refuse_unless(
                highest.is_none_or(|i| (i as usize) < vertices.len()),
                "faces",
                format!("corner indices below {}", vertices.len()),
                || highest.map_or("none".into(), |i| i.to_string()),
            ),
            refuse_unless(
                normals.as_ref().is_none_or(|n| normals_fit(n, faces.len())),
                "normals",
                "three indices of finite normals for each triangle",
                || "other ones".into(),
            ),
        ])?;
        let Vertices { largest, are_single } = Vertices::of(&vertices);
        let corners = Corners { vertices: &vertices, faces: &faces };
        let triangles = Triangles { corners, largest };
        let level = build.level();
        let options = Options { leaf_size: LANES, extra: EXTRA, level };
        let gathered = Gathered::new(&triangles, options);
        let bounds = gathered.bounds;
        Refused::unless([refuse_unless(
            gathered.count() > 0,
            "faces",
            "at least one triangle with an area",
            || format!("{} without", faces.len()),
        )])?;
        let is_fast = build == Build::Fast;
        let blocks = |leaves: &[Span], items: &[u32]| {
            Blocks::new(leaves, items, corners, are_single || is_fast)
        };
        let (order, blocks) = if build == Build::List || gathered.count() <= FEW {
            let is_list = build == Build::List;
            let order = if is_list { Order::List(List::new(faces.len())) } else { Order::Blocks };
            let items = gathered.numbers();
            (order, blocks(&in_fours(items.len()), &items))
        } else {
            let rounding = if is_fast { FAST_ROUNDING } else { 1.0 };
            let leaf = |number, span: Span| Leaf::new(number, span.count);
            let (wide, leaves, items) = Wide::new(gathered, &triangles, rounding, options, leaf);
            (Order::Wide(wide), blocks(&leaves, &items))
        };
        let places = places(&blocks, faces.len());
        let middle = bounds.center();
        let half = max_abs(bounds.max - middle).max(max_abs(middle - bounds.min));
        Ok(Self { blocks, places, normals, uvs: None, bounds, middle, half, order, is_fast, level })
    }
}

/// So many items, a block's worth at a time.
fn in_fours(count: usize) -> Vec<Span> {
    let firsts = (0..count).step_by(LANES);
    let span =
        |first: usize| Span { first: first as u32, count: (count - first).min(LANES) as u32 };
    firsts.map(span).collect()
}

/// For each triangle where it is among the blocks.
fn places(blocks: &Blocks, count: usize) -> Vec<u32> {
    let mut places = vec![NOBODY; count];
    for block in 0..blocks.len() {
        for (lane, number) in blocks.numbers(block).into_iter().enumerate() {
            if number != NOBODY {
                places[number as usize] = (block * LANES + lane) as u32;
            }
        }
    }
    places
}
