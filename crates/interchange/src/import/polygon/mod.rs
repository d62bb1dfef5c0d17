//! Polygons cut into triangles, concave ones as well.
//!
//! The triangles cover exactly the polygon's inside, each once, and turn the
//! same way as it does. This holds for every polygon that is cut at all: the
//! signed sum of the triangles is the polygon, none of them is turned over, and
//! the border does not cross itself.

mod ears;
mod orientation;
#[cfg(test)]
mod tests;

use tracer::glam::{DVec2, DVec3};

use ears::Ears;
use orientation::{Turn, turn};

/// The most corners of a polygon: every edge is held against every other.
pub(super) const MOST_CORNERS: usize = 10_000;

/// Why a polygon is not cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NotCut {
    /// It covers nothing, so nobody would see it.
    NoArea,
    /// The edges that begin at these corners, from 0, cross.
    Crosses(usize, usize),
    /// Its border touches itself in a way that leaves its inside open.
    Tangled,
}

/// Three corners of each triangle by their numbers, in the polygon's own order.
/// Convex polygons are fans around their first corner.
///
/// It is looked at along the axis nearest to its normal, as if it were flat;
/// left and right are told without rounding.
///
/// # Errors
/// See [`NotCut`]; also `Tangled` for more corners than [`MOST_CORNERS`].
pub(super) fn cut(corners: &[DVec3]) -> Result<Vec<[usize; 3]>, NotCut> {
    if corners.len() > MOST_CORNERS {
        return Err(NotCut::Tangled);
    }
    let flat = flattened(corners).ok_or(NotCut::NoArea)?;
    // Corners that stand twice in a row have no edge between them.
    let mut ring: Vec<usize> = Vec::with_capacity(flat.len());
    for i in 0..flat.len() {
        if ring.last().is_none_or(|&last| flat[last] != flat[i]) {
            ring.push(i);
        }
    }
    while ring.len() > 1 && flat[ring[0]] == flat[ring[ring.len() - 1]] {
        ring.pop();
    }
    if ring.len() < 3 {
        return Err(NotCut::NoArea);
    }
    if let Some((a, b)) = crossing(&flat, &ring) {
        return Err(NotCut::Crosses(a, b));
    }
    match fan(&flat, &ring) {
        Some(triangles) => Ok(triangles),
        None => Ears::new(&flat, &ring).cut().ok_or(NotCut::Tangled),
    }
}

/// The corners seen along the axis nearest to the normal, turning to the left
/// and scaled to about 1; `None` without a normal.
///
/// Source: Newell's normal, in Sutherland, Sproull, Schumacker, "A
/// Characterization of Ten Hidden-Surface Algorithms", 1974.
fn flattened(corners: &[DVec3]) -> Option<Vec<DVec2>> {
    let largest = corners.iter().map(|c| c.abs().max_element()).fold(0.0, f64::max);
    if !(largest.is_finite() && largest > 0.0) {
        return None;
    }
    // By a power of two, which changes no digit.
    let power = libm::floor(libm::log2(largest)).max(-1_000.0);
    let scale = libm::ldexp(1.0, -(power as i32));
    let scaled: Vec<DVec3> = corners.iter().map(|&c| c * scale).collect();
    let first = *scaled.first()?;
    let pairs = scaled.iter().zip(scaled.iter().cycle().skip(1));
    // From the first corner, so that a far-away polygon keeps its digits.
    let normal: DVec3 = pairs.map(|(&a, &b)| (a - first).cross(b - first)).sum();
    let n = normal.abs();
    let project: fn(&DVec3) -> DVec2 = if n.x >= n.y && n.x >= n.z {
        if normal.x > 0.0 { |c| DVec2::new(c.y, c.z) } else { |c| DVec2::new(c.z, c.y) }
    } else if n.y >= n.z {
        if normal.y > 0.0 { |c| DVec2::new(c.z, c.x) } else { |c| DVec2::new(c.x, c.z) }
    } else if normal.z > 0.0 {
        |c| DVec2::new(c.x, c.y)
    } else {
        |c| DVec2::new(c.y, c.x)
    };
    (n.is_finite() && n.max_element() > 0.0).then(|| scaled.iter().map(project).collect())
}

/// Two edges that go right through each other.
fn crossing(flat: &[DVec2], ring: &[usize]) -> Option<(usize, usize)> {
    let edge = |i: usize| (flat[ring[i]], flat[ring[(i + 1) % ring.len()]]);
    for i in 0..ring.len() {
        let (a, b) = edge(i);
        let (low, high) = (a.min(b), a.max(b));
        for j in i + 2..ring.len() {
            let (c, d) = edge(j);
            let apart = c.max(d).cmplt(low).any() || c.min(d).cmpgt(high).any();
            if !apart
                && opposite(turn(a, b, c), turn(a, b, d))
                && opposite(turn(c, d, a), turn(c, d, b))
            {
                return Some((ring[i], ring[j]));
            }
        }
    }
    None
}

fn opposite(a: Turn, b: Turn) -> bool {
    matches!((a, b), (Turn::Left, Turn::Right) | (Turn::Right, Turn::Left))
}

/// The fan around the first corner, if nothing of it is turned over.
fn fan(flat: &[DVec2], ring: &[usize]) -> Option<Vec<[usize; 3]>> {
    let n = ring.len();
    let corner = |i: usize| flat[ring[i % n]];
    let bends_back = |i| turn(corner(i), corner(i + 1), corner(i + 2)) == Turn::Right;
    if (0..n).any(bends_back) {
        return None;
    }
    let mut triangles = Vec::with_capacity(n - 2);
    for i in 1..n - 1 {
        match turn(corner(0), corner(i), corner(i + 1)) {
            Turn::Left => triangles.push([ring[0], ring[i], ring[i + 1]]),
            Turn::Straight => {}
            Turn::Right => return None,
        }
    }
    (!triangles.is_empty()).then_some(triangles)
}
