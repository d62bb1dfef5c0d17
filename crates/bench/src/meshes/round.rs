//! A closed bumpy ball of about as many triangles as wanted: the mesh that time
//! is plotted against size with.

use super::TriangleMesh;

/// A ball of rings and sectors has twice as many sectors as rings.
const SECTORS_PER_RING: u32 = 2;
/// How far bumps rise above the unit ball, and how many go around.
const BUMP_HEIGHT: f64 = 0.15;
const BUMP_WAVES: [f64; 3] = [7.0, 9.0, 8.0];

/// A closed surface of at most `triangles` triangles (at least 8, and never
/// fewer than three quarters of them from 100 on): bumps on the unit ball, one
/// corner at each pole.
pub(super) fn bumpy(triangles: u32) -> TriangleMesh {
    // `rings` bands of which the two at the poles have one triangle a sector
    // and the others two: 2 sectors (rings - 1) triangles.
    let mut rings = 2;
    while 2 * SECTORS_PER_RING * (rings + 1) * rings <= triangles {
        rings += 1;
    }
    let sectors = SECTORS_PER_RING * rings;
    let mut vertices = vec![corner(0.0, 0.0)];
    for ring in 1..rings {
        let polar = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
        vertices.extend((0..sectors).map(|sector| {
            corner(polar, std::f64::consts::TAU * f64::from(sector) / f64::from(sectors))
        }));
    }
    vertices.push(corner(std::f64::consts::PI, 0.0));
    let south = vertices.len() as u32 - 1;

    let at = |ring: u32, sector: u32| 1 + (ring - 1) * sectors + sector % sectors;
    let mut faces = Vec::new();
    for sector in 0..sectors {
        faces.push([0, at(1, sector), at(1, sector + 1)]);
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, sector), at(ring, sector + 1)];
            let [c, d] = [at(ring + 1, sector), at(ring + 1, sector + 1)];
            faces.extend([[a, c, d], [a, d, b]]);
        }
        faces.push([at(rings - 1, sector), south, at(rings - 1, sector + 1)]);
    }
    TriangleMesh { vertices, faces }
}

/// The point in a direction, raised by the bumps there.
fn corner(polar: f64, around: f64) -> [f32; 3] {
    // From `libm`, so that the mesh is the same on every system.
    let (sin, cos) = (libm::sin(polar), libm::cos(polar));
    let unit = [sin * libm::cos(around), cos, sin * libm::sin(around)];
    let waves = [0, 1, 2].map(|axis| libm::sin(BUMP_WAVES[axis] * unit[axis]));
    let radius = 1.0 + BUMP_HEIGHT * waves[0] * waves[1] * waves[2];
    unit.map(|x| (radius * x) as f32)
}
