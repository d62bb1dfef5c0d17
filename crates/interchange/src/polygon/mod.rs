//! Polygons cut into triangles that are their corners', by ear clipping.
//!
//! Every decision is exact, taken on the polygon's own coordinates with one axis
//! left out. So for a polygon that does not cross itself the triangles cover it
//! once, whatever its corners, and use every corner that is not a repetition:
//! neighbors that share its edges have no cracks between.

mod predicate;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;

use tracer::glam::DVec3;

use predicate::{Point, orientation, to_size, turn};

/// Why a polygon is not cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Problem {
    /// It has no area: fewer than three corners, or all on one line.
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

/// Cuts polygons, and counts the work that they are.
#[derive(Debug, Clone)]
pub struct Cutter {
    work_left: u64,
}

impl Default for Cutter {
    fn default() -> Self {
        /// Looks at a corner or a pair of edges: some ten seconds of them, and
        /// one polygon of 20,000 corners.
        const WORK: u64 = 2_000_000_000;
        Self { work_left: WORK }
    }
}

impl Cutter {
    /// The triangles of a polygon, as indices of its corners, turning as it
    /// does.
    ///
    /// A triangle is left as it is; of a convex polygon they are a fan around
    /// its first corner. One that touches itself is cut as well, as where a
    /// bridge leads to a hole. Corners need not be in a plane: the polygon is
    /// what it is as seen along an axis, the one that its normal is nearest to.
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
        let points = flattened(corners, &ring).ok_or(Problem::NoArea)?;
        if is_convex(&points) {
            return Ok((2..ring.len()).map(|i| [ring[0], ring[i - 1], ring[i]]).collect());
        }
        self.spend(points.len().saturating_mul(points.len()))?;
        if let Some((a, b)) = crossing(&points) {
            return Err(Problem::Crossing(ring[a], ring[b]));
        }
        let triangles = self.clip(&points)?;
        Ok(triangles.into_iter().map(|corners| corners.map(|i| ring[i])).collect())
    }

    fn spend(&mut self, work: usize) -> Result<(), Problem> {
        self.work_left = self.work_left.checked_sub(work as u64).ok_or(Problem::TooMuchWork)?;
        Ok(())
    }

    /// Takes off ears, corners with nothing of the polygon in their triangle. All
    /// triangles turn left, so that together they cover each point as often as
    /// the polygon goes around it.
    fn clip(&mut self, points: &[Point]) -> Result<Vec<[usize; 3]>, Problem> {
        let mut left: Vec<usize> = (0..points.len()).collect();
        trim(points, &mut left);
        let mut triangles = Vec::with_capacity(points.len());
        let mut at = 0;
        let mut failed = 0;
        while left.len() > 3 {
            let n = left.len();
            let [a, b, c] = [at + n - 1, at, at + 1].map(|i| i % n);
            self.spend(n)?;
            if is_ear(points, &left, [a, b, c]) {
                triangles.push([left[a], left[b], left[c]]);
                left.remove(b);
                if [b, b + n - 2].iter().any(|i| is_spike(points, &left, i % (n - 1))) {
                    trim(points, &mut left);
                }
                failed = 0;
                // The corner after next, so that triangles do not all share one.
                at = b + 1;
            } else if failed < n {
                failed += 1;
                at += 1;
            } else {
                return Err(Problem::Tangled);
            }
        }
        if let [a, b, c] = left[..] {
            match turn(points[a], points[b], points[c]) {
                Ordering::Greater => triangles.push([a, b, c]),
                Ordering::Equal => {}
                Ordering::Less => return Err(Problem::Tangled),
            }
        }
        Ok(triangles)
    }
}

/// Whether a polygon covers anything from any side.
pub fn has_area(corners: &[DVec3]) -> bool {
    let ring = without_repetitions(corners);
    ring.len() > 2 && flattened(corners, &ring).is_some()
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

/// The corners with one coordinate left out, so that they go counter-clockwise;
/// `None` where they have no area from any side.
fn flattened(corners: &[DVec3], ring: &[usize]) -> Option<Vec<Point>> {
    let normal = newell(corners).abs().to_array();
    let mut axes = [2, 1, 0];
    axes.sort_by(|&a, &b| normal[b].total_cmp(&normal[a]));
    axes.into_iter().find_map(|axis| {
        let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut points: Vec<Point> = ring.iter().map(|&i| [corners[i][x], corners[i][y]]).collect();
        to_size(&mut points);
        match orientation(&points) {
            Ordering::Greater => Some(points),
            Ordering::Less => {
                for point in &mut points {
                    point.reverse();
                }
                Some(points)
            }
            Ordering::Equal => None,
        }
    })
}

/// Whether a polygon turns left at every corner and goes around once.
fn is_convex(points: &[Point]) -> bool {
    let n = points.len();
    let rises = |i: usize| points[i % n] < points[(i + 1) % n];
    let lowest = (0..n).filter(|&i| !rises(i) && rises(i + 1)).count();
    lowest == 1 && (0..n).all(|i| turn(points[i], points[(i + 1) % n], points[(i + 2) % n]).is_gt())
}

/// Two edges that have a point in common that is inside both, by where they begin.
fn crossing(points: &[Point]) -> Option<(usize, usize)> {
    let n = points.len();
    let edge = |i: usize| (points[i], points[(i + 1) % n]);
    let apart = |(a, b): (Point, Point), (c, d): (Point, Point)| {
        (0..2).any(|k| a[k].max(b[k]) < c[k].min(d[k]) || c[k].max(d[k]) < a[k].min(b[k]))
    };
    let opposite = |x: Ordering, y: Ordering| x.is_ne() && x == y.reverse();
    (0..n).find_map(|i| {
        let first = edge(i);
        let cuts = |j: &usize| {
            let ((a, b), (c, d)) = (first, edge(*j));
            !apart((a, b), (c, d))
                && opposite(turn(a, b, c), turn(a, b, d))
                && opposite(turn(c, d, a), turn(c, d, b))
        };
        (i + 2..n).find(cuts).map(|j| (i, j))
    })
}

/// Takes out all ways there and back again, which have no area.
fn trim(points: &[Point], left: &mut Vec<usize>) {
    let mut i = 0;
    let mut passed = 0;
    // Until all have been passed by since the last that was taken out.
    while passed < left.len() && left.len() > 2 {
        i %= left.len();
        if is_spike(points, left, i) {
            left.remove(i);
            i = (i + left.len() - 1) % left.len();
            passed = 0;
        } else {
            (i, passed) = (i + 1, passed + 1);
        }
    }
}

/// Whether a corner is where the next or the one before is, or the way goes back
/// there.
fn is_spike(points: &[Point], left: &[usize], i: usize) -> bool {
    let n = left.len();
    let [a, b, c] = [(i + n - 1) % n, i, (i + 1) % n].map(|k| points[left[k]]);
    let to = |p: Point| [0, 1].map(|k| p[k].partial_cmp(&b[k]));
    a == b || b == c || (turn(a, b, c).is_eq() && to(a) == to(c))
}

/// Whether three corners that follow each other make a triangle with no other
/// corner in it or on its rim, but where one of its own is.
fn is_ear(points: &[Point], left: &[usize], [a, b, c]: [usize; 3]) -> bool {
    let [pa, pb, pc] = [a, b, c].map(|i| points[left[i]]);
    if !turn(pa, pb, pc).is_gt() {
        return false;
    }
    let min = [0, 1].map(|k| pa[k].min(pb[k]).min(pc[k]));
    let max = [0, 1].map(|k| pa[k].max(pb[k]).max(pc[k]));
    left.iter().map(|&i| points[i]).all(|p| {
        let is_far = (0..2).any(|k| p[k] < min[k] || max[k] < p[k]);
        is_far
            || [pa, pb, pc].contains(&p)
            || turn(pa, pb, p).is_lt()
            || turn(pb, pc, p).is_lt()
            || turn(pc, pa, p).is_lt()
    })
}
