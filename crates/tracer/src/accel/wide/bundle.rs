//! `Bundle`: rays made ready for the hierarchy's boxes, four at a time: what
//! [`Slabs`] has of one.

use glam::DVec3;

use super::Wide;
use super::slabs::{LARGEST, LONGEST, Slabs, TimeScale};
use crate::math::Real;
use crate::simd::{Four, Simd};
use crate::{Interval, Ray};

/// How many rays are in a bundle.
pub(crate) const RAYS: usize = 16;
/// How many are made ready together.
pub(crate) const LANES: usize = 4;
/// A bit for each.
const ALL: u32 = (1 << LANES) - 1;

/// A number for each ray.
pub(super) type Each<T> = [T; RAYS];

/// Rays that are computed with as they are, or are marked as such that are not.
pub(crate) struct Bundle {
    /// For each axis and ray what [`Slabs`] has.
    pub(super) recip: [Each<f32>; 3],
    pub(super) near: [Each<f32>; 3],
    pub(super) far: [Each<f32>; 3],
    /// For each axis the scaled origins, rounded.
    pub(super) origin: [Each<f32>; 3],
    /// How far near and far sides were moved apart along any axis, as lengths,
    /// rounded.
    pub(super) apart: Each<f32>,
    /// A bit for each ray that can be computed with as it is: the others are
    /// taken for any.
    pub(crate) usual: u32,
    pub(super) t_min: f32,
    pub(super) t_max: f32,
    /// How the slabs' parameter follows from the rays'.
    pub(crate) time: TimeScale,
}

impl Bundle {
    /// None yet, for rays of this range.
    #[inline(always)]
    pub(crate) fn new(wide: &Wide, range: Interval) -> Self {
        let time = TimeScale::of(wide);
        let nothing = [[0.0; RAYS]; 3];
        Self {
            recip: nothing,
            near: nothing,
            far: nothing,
            origin: nothing,
            apart: [0.0; RAYS],
            usual: 0,
            t_min: time.down(range.lo),
            t_max: time.up(range.hi),
            time,
        }
    }

    /// Takes four rays in, to the places from `at` on.
    #[inline(always)]
    pub(crate) fn fill<S: Simd>(&mut self, simd: S, wide: &Wide, at: usize, rays: &Abreast<S::D4>) {
        let scale = simd.four_long(wide.scale);
        let [x, y, z] = rays.origin;
        let origin = [x * scale, y * scale, z * scale];
        let reach = longest(origin) + simd.four_long(wide.largest);
        let length = longest(rays.direction);
        // A NaN, which the largest of three may not show, is no start: it would take
        // another ray's place among the ends of a packet.
        let is_somewhere = (x + y + z).is_at_most(simd.four_long(f64::INFINITY));
        let usual = simd.four_long(1.0 / LONGEST).is_at_most(length)
            & length.is_at_most(simd.four_long(LONGEST))
            & reach.is_at_most(simd.four_long(wide.farthest))
            & is_somewhere;
        self.usual = self.usual & !(ALL << at) | usual << at;
        let mut widest = simd.four_long(0.0);
        for (axis, (o, d)) in origin.into_iter().zip(rays.direction).enumerate() {
            let recip = simd.four_long(1.0) / d;
            let recip = recip.min(simd.four_long(LARGEST)).max(simd.four_long(-LARGEST));
            let extent = simd.four_long(wide.extent[axis]);
            let apart = Slabs::<S>::apart(simd, wide, o, extent, reach);
            let (middle, by) = (o * recip, apart * recip.magnitude());
            widest = widest.max(apart);
            put(&mut self.recip[axis], at, recip);
            put(&mut self.near[axis], at, -(middle + by));
            put(&mut self.far[axis], at, by - middle);
            put(&mut self.origin[axis], at, o);
        }
        put(&mut self.apart, at, widest);
    }

    /// The slabs of one ray.
    #[inline(always)]
    pub(super) fn slabs<S: Simd>(&self, simd: S, ray: usize) -> Slabs<S> {
        let ray = ray % RAYS;
        let of = |each: &[Each<f32>; 3]| [each[0][ray], each[1][ray], each[2][ray]];
        let recip = of(&self.recip);
        Slabs::of(simd, recip, of(&self.near), of(&self.far), self.t_min)
    }
}

/// Four rays, side by side.
pub(crate) struct Abreast<V> {
    /// Their origins and directions, axis by axis.
    pub(crate) origin: [V; 3],
    pub(crate) direction: [V; 3],
}

impl<V> Abreast<V> {
    /// These rays.
    #[inline(always)]
    pub(crate) fn new<S: Simd<D4 = V>>(simd: S, [a, b, c, d]: &[&Ray; LANES]) -> Self {
        Self {
            origin: columns(simd, [a.origin, b.origin, c.origin, d.origin]),
            direction: columns(simd, [a.direction, b.direction, c.direction, d.direction]),
        }
    }
}

#[inline(always)]
fn columns<S: Simd>(simd: S, [a, b, c, d]: [DVec3; LANES]) -> [S::D4; 3] {
    [
        simd.load_four_long(&[a.x, b.x, c.x, d.x]),
        simd.load_four_long(&[a.y, b.y, c.y, d.y]),
        simd.load_four_long(&[a.z, b.z, c.z, d.z]),
    ]
}

/// The largest magnitude of each three.
#[inline(always)]
pub(crate) fn longest<V: Four>([x, y, z]: [V; 3]) -> V {
    x.magnitude().max(y.magnitude()).max(z.magnitude())
}

/// Puts four numbers in their places, rounded.
#[inline(always)]
fn put(each: &mut Each<f32>, at: usize, four: impl Four) {
    if let Some(places) = each.as_chunks_mut::<LANES>().0.get_mut(at / LANES) {
        *places = four.to_singles();
    }
}
