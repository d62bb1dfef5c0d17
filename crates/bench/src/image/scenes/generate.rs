//! Scenes of many objects, made by code.

use std::fmt::Write as _;

/// The seed of all that is placed at random.
const SEED: u64 = 2011;

/// A small generator of random numbers, the same everywhere.
///
/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", 2014; its constants are theirs.
struct Random(u64);

impl Random {
    /// A number from `lo` to `hi`.
    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        /// As many of the upper bits as an `f64` holds exactly.
        const BITS: u32 = 53;
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        let share = (z >> (u64::BITS - BITS)) as f64 / (1_u64 << BITS) as f64;
        lo + share * (hi - lo)
    }
}

/// What all of these scenes share: a floor, one light, and palette.
fn scene(camera: &str, light: &str, objects: &str) -> String {
    format!(
        "(
    version: 1,
    image: (640, 480),
    shading: Radiometric,
    camera: {camera},
    materials: {{
        \"floor\": Lambert(diffuse: (0.6, 0.58, 0.54)),
        \"0\": Lambert(diffuse: (0.72, 0.28, 0.16)),
        \"1\": Lambert(diffuse: (0.16, 0.42, 0.5)),
        \"2\": Lambert(diffuse: (0.74, 0.56, 0.2)),
        \"3\": Lambert(diffuse: (0.7, 0.68, 0.62)),
    }},
    objects: [
        Disk(center: (0, 0, 0), normal: (0, 1, 0), radius: 60, material: Named(\"floor\")),
{objects}    ],
    lights: [{light}],
)
"
    )
}

/// How many materials there are besides the floor's.
const MATERIALS: usize = 4;

/// Blocks of houses: 24 by 24 boxes of many heights.
pub(super) fn city() -> String {
    /// Houses along each side, the distance of their middles, half of their width.
    const SIDE: usize = 24;
    const APART: f64 = 1.0;
    const HALF: (f64, f64) = (0.26, 0.42);
    const HEIGHTS: (f64, f64) = (0.3, 2.6);
    /// Off the floor, so that none has a side in it.
    const ABOVE: f64 = 0.002;
    let mut random = Random(SEED);
    let mut objects = String::new();
    for i in 0..SIDE * SIDE {
        let middle = |k: usize| (k as f64 - (SIDE - 1) as f64 / 2.0) * APART;
        let (x, z) = (middle(i % SIDE), middle(i / SIDE));
        let (w, d) = (random.between(HALF.0, HALF.1), random.between(HALF.0, HALF.1));
        // Most are low.
        let high = HEIGHTS.0 + HEIGHTS.1 * random.between(0.0, 1.0) * random.between(0.0, 1.0);
        let material = i * 7 % MATERIALS;
        // Writing into a string does not fail.
        let _ = writeln!(
            objects,
            "        Box(min: ({:.4}, {ABOVE}, {:.4}), max: ({:.4}, {high:.4}, {:.4}), \
             material: Named(\"{material}\")),",
            x - w,
            z - d,
            x + w,
            z + d
        );
    }
    scene(
        "LookAt(eye: (9.5, 8, 15), at: (0.3, 0, 0.6), fov_deg: 36)",
        "Point(position: (-9, 14, 6), intensity: (660, 634, 590))",
        &objects,
    )
}

/// A thousand balls on the floor, none in another.
pub(super) fn spheres() -> String {
    const COUNT: usize = 1_000;
    const RADII: (f64, f64) = (0.06, 0.3);
    const HALF: f64 = 7.0;
    let mut random = Random(SEED);
    let mut placed: Vec<(f64, f64, f64)> = Vec::new();
    let mut objects = String::new();
    while placed.len() < COUNT {
        let (x, z) = (random.between(-HALF, HALF), random.between(-HALF, HALF));
        // Most are small.
        let share = random.between(0.0, 1.0);
        let r = RADII.0 + (RADII.1 - RADII.0) * share * share * share;
        let touches = |&(a, b, s): &(f64, f64, f64)| {
            // Balls of other sizes on one floor touch at this distance.
            (a - x) * (a - x) + (b - z) * (b - z) < (r + s) * (r + s)
        };
        if placed.iter().any(touches) {
            continue;
        }
        let material = placed.len() % MATERIALS;
        placed.push((x, z, r));
        let _ = writeln!(
            objects,
            "        Sphere(center: ({x:.4}, {r:.4}, {z:.4}), radius: {r:.4}, \
             material: Named(\"{material}\")),"
        );
    }
    scene(
        "LookAt(eye: (4, 4.6, 10), at: (0, -0.2, 0.6), fov_deg: 36)",
        "Point(position: (-6, 9, 5), intensity: (305, 291, 268))",
        &objects,
    )
}

/// Rows of rods that go far away, until each is thinner than a pixel.
pub(super) fn fence() -> String {
    const RODS: usize = 40;
    const ROWS: usize = 4;
    const RADIUS: f64 = 0.03;
    const HEIGHT: f64 = 1.4;
    /// The first rod is so far to the front, and each next one so much further back.
    const FRONT: f64 = 4.0;
    const APART: f64 = 0.6;
    /// Between rows.
    const LANE: f64 = 1.3;
    let mut objects = String::new();
    for i in 0..RODS * ROWS {
        let (row, rod) = (i / RODS, i % RODS);
        let x = (row as f64 - (ROWS - 1) as f64 / 2.0) * LANE;
        // Rows lean a little, so that rods are seen beside each other.
        let (z, lean) = (FRONT - rod as f64 * APART, 0.05 * row as f64);
        let _ = writeln!(
            objects,
            "        Cylinder(a: ({x:.4}, 0.002, {z:.4}), b: ({:.4}, {HEIGHT}, {z:.4}), \
             radius: {RADIUS}, material: Named(\"{row}\")),",
            x + lean
        );
    }
    scene(
        "LookAt(eye: (0.9, 1.9, 8), at: (-0.1, 0.45, 0), fov_deg: 34)",
        "Point(position: (-6, 9, 6), intensity: (500, 478, 440))",
        &objects,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_objects_as_promised() {
        for (text, what, count) in
            [(city(), "Box(", 576), (spheres(), "Sphere(", 1_000), (fence(), "Cylinder(", 160)]
        {
            assert_eq!(text.matches(what).count(), count, "{what}");
        }
    }

    #[test]
    fn random_numbers_are_the_published_ones() {
        // The first output for the seed 0 is e220a8397b1dcdaf; its upper 53 bits.
        let first = Random(0).between(0.0, 1.0);
        assert_eq!(first, (0xe220_a839_7b1d_cdaf_u64 >> 11) as f64 / (1_u64 << 53) as f64);
    }
}
