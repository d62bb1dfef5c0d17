//! A colonnaded hall: fluted columns, arches, a ribbed vault, galleries with
//! railings, stairs, and planks the length of the floor, so that triangles of
//! all sizes and the longest and thinnest ones meet.
//!
//! It is all in meters: `x` across, `y` up, `z` along.

use std::f64::consts::{PI, TAU};

use super::{TriangleMesh, Viewpoint};

/// Half the hall's width, its height below the vault, and its length.
const HALF_WIDTH: f64 = 9.0;
const WALL_HEIGHT: f64 = 9.0;
const LENGTH: f64 = 48.0;
/// Columns in each of the two rows, and where the rows stand.
const COLUMNS: u32 = 16;
const ROW_X: f64 = 5.5;
const SPACING: f64 = LENGTH / COLUMNS as f64;
/// A column: radius and height; grooves, sectors for each, bands.
const COLUMN_RADIUS: f64 = 0.42;
const COLUMN_HEIGHT: f64 = 5.6;
const FLUTES: u32 = 20;
const SECTORS_PER_FLUTE: u32 = 3;
const FLUTE_DEPTH: f64 = 0.05;
const COLUMN_BANDS: u32 = 36;
/// An arch from column to column: pieces around it and around its section.
const ARCH_PIECES: u32 = 48;
const SECTION_PIECES: u32 = 12;
const ARCH_THICKNESS: f64 = 0.3;
/// The vault: strips, each as long as the hall, and a rib at each column.
const VAULT_STRIPS: u32 = 160;
const VAULT_RISE: f64 = 6.0;
/// Planks of the floor, each as long as the hall, with gaps between them.
const PLANKS: u32 = 150;
const PLANK_GAP: f64 = 0.004;
/// A gallery on either side, with its railing.
const GALLERY_Y: f64 = 7.4;
const GALLERY_DEPTH: f64 = 3.0;
const BALUSTERS: u32 = 190;
const BALUSTER_SECTORS: u32 = 12;
const BALUSTER_BANDS: u32 = 10;
const RAILING_HEIGHT: f64 = 1.0;
/// Stairs across the end of the hall.
const STEPS: u32 = 24;
const STEP: [f64; 2] = [0.16, 0.3];

/// From the entrance, a little aside, towards the stairs.
pub(super) const VIEW: Viewpoint =
    Viewpoint::Inside { eye: [-1.7, 1.75, 2.3], at: [1.2, 3.6, 30.0], light: [0.4, 8.3, 21.0] };

/// The hall, of more than 250 thousand triangles.
pub(super) fn hall() -> TriangleMesh {
    let mut hall = Mason(TriangleMesh { vertices: Vec::new(), faces: Vec::new() });
    floor_and_walls(&mut hall);
    for side in [-1.0, 1.0] {
        for number in 0..COLUMNS {
            column(&mut hall, side * ROW_X, SPACING * (f64::from(number) + 0.5));
        }
        for number in 0..COLUMNS - 1 {
            arch(&mut hall, side * ROW_X, SPACING * f64::from(number + 1));
        }
        gallery(&mut hall, side);
    }
    vault(&mut hall);
    stairs(&mut hall);
    hall.0
}

/// Puts parts into one mesh.
struct Mason(TriangleMesh);

impl Mason {
    /// A sheet of `across` x `along` quads through the points
    /// `point(u, v)` with `u` and `v` from 0 to 1.
    fn sheet(&mut self, across: u32, along: u32, point: impl Fn(f64, f64) -> [f64; 3]) {
        let first = self.0.vertices.len() as u32;
        for j in 0..=along {
            for i in 0..=across {
                let [u, v] = [f64::from(i) / f64::from(across), f64::from(j) / f64::from(along)];
                self.0.vertices.push(point(u, v).map(|x| x as f32));
            }
        }
        for j in 0..along {
            for i in 0..across {
                let a = first + j * (across + 1) + i;
                let (b, c) = (a + 1, a + across + 1);
                self.0.faces.extend([[a, b, c], [b, c + 1, c]]);
            }
        }
    }

    /// A box between two corners.
    fn block(&mut self, lo: [f64; 3], hi: [f64; 3]) {
        let first = self.0.vertices.len() as u32;
        for corner in 0..8_u8 {
            let side = |axis: usize| if corner >> axis & 1 == 0 { lo[axis] } else { hi[axis] };
            self.0.vertices.push([0, 1, 2].map(|axis| side(axis) as f32));
        }
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        for [a, b, c, d] in quads.map(|quad| quad.map(|corner: u32| first + corner)) {
            self.0.faces.extend([[a, b, c], [a, c, d]]);
        }
    }
}

fn floor_and_walls(hall: &mut Mason) {
    let width = 2.0 * HALF_WIDTH / f64::from(PLANKS);
    for plank in 0..PLANKS {
        let x = -HALF_WIDTH + width * f64::from(plank);
        hall.block([x, -0.05, 0.0], [x + width - PLANK_GAP, 0.0, LENGTH]);
    }
    for x in [-HALF_WIDTH, HALF_WIDTH] {
        hall.sheet(1, COLUMNS, |u, v| [x, WALL_HEIGHT * u, LENGTH * v]);
    }
    for z in [0.0, LENGTH] {
        hall.sheet(1, 1, |u, v| [HALF_WIDTH * (2.0 * u - 1.0), (WALL_HEIGHT + VAULT_RISE) * v, z]);
    }
}

/// A fluted shaft between a wider foot and head.
fn column(hall: &mut Mason, x: f64, z: f64) {
    let sectors = FLUTES * SECTORS_PER_FLUTE;
    hall.sheet(sectors, COLUMN_BANDS, |u, v| {
        // Wider near both ends, and slimmer upwards.
        let end = (1.0 - 8.0 * v.min(1.0 - v)).max(0.0);
        let groove = FLUTE_DEPTH * libm::fabs(libm::sin(PI * f64::from(FLUTES) * u)) * (1.0 - end);
        let radius = COLUMN_RADIUS * (1.0 - 0.15 * v + 0.5 * end * end) - groove;
        let [cos, sin] = [libm::cos(TAU * u), libm::sin(TAU * u)];
        [x + radius * cos, COLUMN_HEIGHT * v, z + radius * sin]
    });
    let slab = 1.5 * COLUMN_RADIUS;
    hall.block([x - slab, COLUMN_HEIGHT, z - slab], [x + slab, COLUMN_HEIGHT + 0.2, z + slab]);
}

/// Half a ring with a rounded section, from one column of a row to the next.
fn arch(hall: &mut Mason, x: f64, z: f64) {
    let radius = SPACING / 2.0;
    hall.sheet(ARCH_PIECES, SECTION_PIECES, |u, v| {
        let [cos, sin] = [libm::cos(TAU * v), libm::sin(TAU * v)];
        let r = radius - ARCH_THICKNESS * (0.5 + 0.5 * cos);
        let [along, up] = [-r * libm::cos(PI * u), r * libm::sin(PI * u)];
        [x + ARCH_THICKNESS * sin, COLUMN_HEIGHT + 0.2 + up, z + along]
    });
}

/// A floor above the aisle, with balusters and two rails as long as the hall.
fn gallery(hall: &mut Mason, side: f64) {
    let inner = HALF_WIDTH - GALLERY_DEPTH;
    let sided = |a: f64, b: f64| if side < 0.0 { [-b, -a] } else { [a, b] };
    let mut beam = |x: [f64; 2], y: [f64; 2]| {
        let [lo, hi] = sided(x[0], x[1]);
        hall.block([lo, y[0], 0.0], [hi, y[1], LENGTH]);
    };
    beam([inner, HALF_WIDTH], [GALLERY_Y, GALLERY_Y + 0.2]);
    let foot = GALLERY_Y + 0.2;
    beam([inner, inner + 0.12], [foot + RAILING_HEIGHT, foot + RAILING_HEIGHT + 0.05]);
    beam([inner + 0.04, inner + 0.08], [foot + 0.1, foot + 0.12]);
    for number in 0..BALUSTERS {
        let z = LENGTH * (f64::from(number) + 0.5) / f64::from(BALUSTERS);
        hall.sheet(BALUSTER_SECTORS, BALUSTER_BANDS, |u, v| {
            let radius = 0.03 + 0.02 * libm::sin(3.0 * PI * v);
            let [cos, sin] = [libm::cos(TAU * u), libm::sin(TAU * u)];
            [side * (inner + 0.06) + radius * cos, foot + RAILING_HEIGHT * v, z + radius * sin]
        });
    }
}

/// A barrel of strips as long as the hall, and a rib above each column.
fn vault(hall: &mut Mason) {
    let point = |u: f64, inset: f64| {
        let [cos, sin] = [libm::cos(PI * u), libm::sin(PI * u)];
        [-(HALF_WIDTH - inset) * cos, WALL_HEIGHT + (VAULT_RISE - inset) * sin]
    };
    hall.sheet(VAULT_STRIPS, 1, |u, v| {
        let [x, y] = point(u, 0.0);
        [x, y, LENGTH * v]
    });
    for number in 0..COLUMNS {
        let z = SPACING * (f64::from(number) + 0.5);
        hall.sheet(VAULT_STRIPS, SECTION_PIECES, |u, v| {
            let [cos, sin] = [libm::cos(TAU * v), libm::sin(TAU * v)];
            let [x, y] = point(u, 0.15 + 0.15 * cos);
            [x, y, z + 0.2 * sin]
        });
    }
}

fn stairs(hall: &mut Mason) {
    let [rise, run] = STEP;
    for step in 0..STEPS {
        let z = LENGTH - run * f64::from(STEPS - step);
        hall.block([-ROW_X, 0.0, z], [ROW_X, rise * f64::from(step + 1), LENGTH]);
    }
}
