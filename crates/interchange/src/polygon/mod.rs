//! Polygons cut into triangles that are their corners', by ear clipping.
//!
//! Every decision is exact, taken on the polygon's own coordinates with one axis
//! left out. So for a polygon that does not cross itself the triangles cover it
//! once, whatever its corners, and use every corner that is not a repetition:
//! neighbors that share its edges have no cracks between.

mod chain;
mod predicate;
mod ring;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;

use tracer::glam::DVec3;

use chain::{Chain, Reach};
use predicate::{Point, orientation, to_size, turn};
use ring::Ring;

/// Why a polygon is not cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Problem {
    /// It has no area: fewer than three corners, all on one line, or a way there and
    /// back again.
    NoArea,
    /// The edges that begin at these corners, from 0, go right through each other.
    Crossing(usize, usize),
    /// It goes around some of its inside more than once, or backwards, without
    /// such edges.
    Tangled,
    /// Cutting it, with those before, takes more work than is allowed.
    TooMuchWork,
}

impl Problem {
    /// What the polygon is, as the end of a sentence: "has no area".
    pub fn text(self) -> &'static str {
        match self {
            Self::NoArea => "has no area",
            Self::Crossing(..) => "crosses itself",
            Self::Tangled => "is wound around itself",
            Self::TooMuchWork => "is one of too many with too many corners",
        }
    }
}

/// What a polygon may take for each of its corners: as much as most borders take,
/// about `n log n` in all.
const LOOKS: u64 = 100;

/// Cuts polygons, and counts the work that they are, in looks at a box, a corner
/// or an edge.
#[derive(Debug, Clone)]
pub struct Cutter {
    /// What the polygon at hand may still take.
    own: u64,
    /// What all together may take beyond that.
    shared: u64,
}

impl Default for Cutter {
    fn default() -> Self {
        /// Some seconds, and six spirals of 20,000 corners.
        const SHARED: u64 = 100_000_000;
        Self { own: 0, shared: SHARED }
    }
}

impl Cutter {
    /// One that has nothing left beyond what each polygon may take of its own.
    #[cfg(test)]
    pub(crate) fn spent() -> Self {
        Self { own: 0, shared: 0 }
    }

    /// The triangles of a polygon, as indices of its corners, turning as it
    /// does.
    ///
    /// A triangle is left as it is; of a convex polygon they are a fan around
    /// its first corner. One that touches itself is cut as well, as where a
    /// bridge leads to a hole. Corners need not be in a plane: the polygon is
    /// what it is as seen along an axis, the one that its normal is nearest to.
    /// One without a normal, as its parts cancel, is seen from where they are
    /// largest.
    ///
    /// # Errors
    /// See [`Problem`].
    pub fn cut(&mut self, corners: &[DVec3]) -> Result<Vec<[usize; 3]>, Problem> {
        if corners.len() == 3 {
            return Ok(vec![[0, 1, 2]]);
        }
        let ring = without_repetitions(corners);
        if ring.len() < 3 {
            return Err(Problem::NoArea);
        }
        self.own = LOOKS.saturating_mul(ring.len() as u64);
        for axis in axes(corners) {
            let points = flattened(corners, &ring, axis);
            if is_straight(&points) {
                continue;
            }
            if is_convex(&points) {
                return Ok((2..ring.len()).map(|i| [ring[0], ring[i - 1], ring[i]]).collect());
            }
            // Before the area, as parts on both sides of a crossing may cancel.
            if let Some((a, b)) = self.crossing(&points)? {
                return Err(Problem::Crossing(ring[a], ring[b]));
            }
            let triangles = self.clip(&points)?;
            if !triangles.is_empty() {
                return Ok(triangles.into_iter().map(|corners| corners.map(|i| ring[i])).collect());
            }
        }
        Err(Problem::NoArea)
    }

    fn spend(&mut self, looks: u64) -> Result<(), Problem> {
        let beyond = looks.saturating_sub(self.own);
        self.own = self.own.saturating_sub(looks);
        self.shared = self.shared.checked_sub(beyond).ok_or(Problem::TooMuchWork)?;
        Ok(())
    }

    /// Two edges that have a point in common that is inside both, by where they
    /// begin: the first that there are.
    fn crossing(&mut self, points: &[Point]) -> Result<Option<(usize, usize)>, Problem> {
        let n = points.len();
        let edge = |i: usize| (points[i], points[(i + 1) % n]);
        let chain = Chain::of_edges(points);
        let opposite = |x: Ordering, y: Ordering| x.is_ne() && x == y.reverse();
        for i in 0..n {
            let (a, b) = edge(i);
            let cuts = |j: usize| {
                let (c, d) = edge(j);
                opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b))
            };
            let may_hold = |reach: &Reach| !reach.is_beside(a, b);
            let (found, looks) = chain.first(i + 2, &[a, b], may_hold, cuts);
            self.spend(looks)?;
            if let Some(j) = found {
                return Ok(Some((i, j)));
            }
        }
        Ok(None)
    }

    /// Takes off ears, corners with nothing of the polygon in their triangle. All
    /// triangles turn left, so that together they cover each point as often as
    /// the polygon goes around it.
    fn clip(&mut self, points: &[Point]) -> Result<Vec<[usize; 3]>, Problem> {
        let mut ring = Ring::new(points);
        let mut triangles = Vec::with_capacity(points.len());
        let mut from = 0;
        let mut has_cut = false;
        while ring.len() > 3 {
            let Some(corner) = ring.next_open(from) else {
                if !has_cut {
                    return Err(Problem::Tangled);
                }
                // What is no ear stays none until one beside it is gone, but where the
                // border touches itself.
                ring.open_all();
                has_cut = false;
                continue;
            };
            let (is_ear, looks) = ring.is_ear(corner);
            self.spend(looks)?;
            if is_ear {
                let [a, b, c] = ring.around(corner);
                triangles.push([a, b, c]);
                ring.remove(b);
                has_cut = true;
                // The corner after next, so that triangles do not all share one.
                from = c + 1;
            } else {
                ring.close(corner);
                from = corner + 1;
            }
        }
        if let [a, b, c] = ring.corners()[..] {
            match turn(points[a], points[b], points[c]) {
                Ordering::Greater => triangles.push([a, b, c]),
                Ordering::Equal => {}
                Ordering::Less => return Err(Problem::Tangled),
            }
        }
        Ok(triangles)
    }
}

/// Whether a triangle covers anything from any side.
pub fn has_area(triangle: &[DVec3; 3]) -> bool {
    (0..3).any(|axis| !is_straight(&flattened(triangle, &[0, 1, 2], axis)))
}

/// How far the corner farthest from a polygon's plane is off it, in shares of
/// the polygon's size; 0 for one without an area.
pub fn off_plane(corners: &[DVec3]) -> f64 {
    let Some(&first) = corners.first() else { return 0.0 };
    let normal = newell(corners).normalize_or_zero();
    let size = corners.iter().fold(0.0, |most: f64, &p| most.max((p - first).length()));
    let off = corners.iter().fold(0.0, |most: f64, &p| most.max(normal.dot(p - first).abs()));
    if size > 0.0 { off / size } else { 0.0 }
}

/// Twice the area along the normal.
///
/// Source: M. Newell, in I. Sutherland, R. Sproull, R. Schumacker, "A
/// Characterization of Ten Hidden-Surface Algorithms", 1974.
fn newell(corners: &[DVec3]) -> DVec3 {
    let Some(&first) = corners.first() else { return DVec3::ZERO };
    corners.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum()
}

/// Indices of the corners that are not where the one before is.
fn without_repetitions(corners: &[DVec3]) -> Vec<usize> {
    let mut ring: Vec<usize> = Vec::with_capacity(corners.len());
    for (i, &corner) in corners.iter().enumerate() {
        if ring.last().is_none_or(|&last| corners[last] != corner) {
            ring.push(i);
        }
    }
    while ring.len() > 1 && ring.last().is_some_and(|&last| corners[last] == corners[ring[0]]) {
        ring.pop();
    }
    ring
}

/// The axes, from the one that a polygon is best seen along.
fn axes(corners: &[DVec3]) -> [usize; 3] {
    /// A normal that is shorter than this share of what it is the sum of may be
    /// what rounding to `f32` left where the parts cancel.
    const NOISE: f64 = 1e-6;
    let first = corners.first().copied().unwrap_or_default();
    let parts = corners.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first).abs());
    let parts: DVec3 = parts.sum();
    let normal = newell(corners).abs();
    let is_noise = normal.max_element() <= NOISE * parts.max_element();
    let along = if is_noise { parts } else { normal }.to_array();
    let mut axes = [2, 1, 0];
    axes.sort_by(|&a, &b| along[b].total_cmp(&along[a]));
    axes
}

/// The corners with one coordinate left out, so that they go counter-clockwise
/// where they go around more of one way than of the other.
fn flattened(corners: &[DVec3], ring: &[usize], axis: usize) -> Vec<Point> {
    let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut points: Vec<Point> = ring.iter().map(|&i| [corners[i][x], corners[i][y]]).collect();
    to_size(&mut points);
    if orientation(&points).is_lt() {
        for point in &mut points {
            point.reverse();
        }
    }
    points
}

/// Whether all points are on one line.
fn is_straight(points: &[Point]) -> bool {
    let Some(&a) = points.first() else { return true };
    let Some(&b) = points.iter().find(|&&b| b != a) else { return true };
    points.iter().all(|&c| turn(a, b, c).is_eq())
}

/// Whether a polygon turns left at every corner and goes around once.
fn is_convex(points: &[Point]) -> bool {
    let n = points.len();
    let rises = |i: usize| points[i % n] < points[(i + 1) % n];
    let lowest = (0..n).filter(|&i| !rises(i) && rises(i + 1)).count();
    lowest == 1 && (0..n).all(|i| turn(points[i], points[(i + 1) % n], points[(i + 2) % n]).is_gt())
}
