//! Where a ray first meets a round body about a straight axis, whose radius
//! goes evenly from one end to the other: cylinders and cones, exactly.
//!
//! In the plain terms of its definition: `rho(x)` is the distance from the
//! axis, `s(x)` goes from 0 at end `a` to 1 at end `b`, `R(s)` is the radius
//! there, and the body is `rho <= R`, `0 <= s <= 1`. It is convex, so a ray is
//! inside for one interval, and `phi = rho - R` has one minimum along it.

use std::cmp::Ordering;

use tracer::Ray;
use tracer::glam::DVec3;

use super::frame::{Frame, Part, Root, TIE};
use super::{Truth, UNIT_ROUNDOFF};
use crate::number::{Big, Dd, Number};

/// A cylinder (equal radii) or a cone (one radius 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frustum {
    /// One end of the axis, which is not the other.
    pub a: DVec3,
    /// The other end.
    pub b: DVec3,
    /// The radius at `a`, not below 0.
    pub radius_a: f64,
    /// The radius at `b`, not below 0.
    pub radius_b: f64,
    /// Whether the ends are closed by disks, which makes it a solid.
    pub caps: bool,
}

/// The first hit and what it hits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrustumTruth {
    /// The first hit.
    pub truth: Truth,
    /// 0 for the side, 1 for the cap at `a`, 2 for that at `b`; `None` for a
    /// miss, and on a rim, where two parts are as right.
    pub part: Option<u32>,
}

impl FrustumTruth {
    const MISS: Self = Self { truth: Truth::MISS, part: None };
    const TIE: Self = Self { truth: Truth::TIE, part: None };
}

impl Frustum {
    /// The first hit with `t` above 0, the surface included.
    ///
    /// In double-double; in 512 bits if that contradicts itself, as it may
    /// within 2^-75 of a rim, where side and cap could both come out as missed.
    pub fn first_hit(&self, ray: &Ray) -> FrustumTruth {
        self.first_hit_in::<Dd>(ray)
            .or_else(|| self.first_hit_in::<Big>(ray))
            .unwrap_or(FrustumTruth::TIE)
    }

    /// The same in one kind of number; `None` if it contradicts itself.
    pub fn first_hit_in<N: Number>(&self, ray: &Ray) -> Option<FrustumTruth> {
        let frame = Frame::<N>::new(self, ray);
        let course = frame.course();
        // How near the ray comes to the axis, with the ends where one rounding
        // of each input could move them at most: still outside is a miss.
        let Some(part) = course.ahead(TIE) else { return Some(FrustumTruth::MISS) };
        let nearest = course.nearest(&part);
        let (depth, doubt) = frame.depth(&nearest);
        if depth < -doubt {
            return Some(FrustumTruth::MISS);
        }
        if !(depth > doubt) {
            return Some(FrustumTruth::TIE);
        }
        if !self.caps {
            return Some(Self::open(&frame, &part));
        }
        // Surely between the ends there, as well as inside the side.
        if frame.beyond_ends(&nearest, 0.0) == Ordering::Less {
            return Self::solid(&frame);
        }
        // The other way round: with the ends moved inward, still inside.
        let Some(part) = course.ahead(-TIE) else { return Some(FrustumTruth::TIE) };
        let inner = course.nearest(&part);
        if inner != nearest {
            let (depth, doubt) = frame.depth(&inner);
            if !(depth > doubt) {
                return Some(FrustumTruth::TIE);
            }
        }
        Self::solid(&frame)
    }

    /// Of a ray that surely meets the body.
    fn solid<N: Number>(frame: &Frame<N>) -> Option<FrustumTruth> {
        let all: Vec<_> = frame.side_roots().into_iter().chain(frame.cap_roots()).collect();
        let mut on_body: Vec<_> = all.iter().filter(|root| root.on_body).collect();
        on_body.sort_by(|x, y| x.t.partial_cmp(&y.t).unwrap_or(Ordering::Equal));
        let [enter, .., leave] = on_body.as_slice() else { return None };
        if enter.t.to_f64().abs() <= TIE * UNIT_ROUNDOFF * enter.condition {
            return Some(FrustumTruth::TIE);
        }
        let first = if enter.t > N::zero() { enter } else { leave };
        if !(first.t > N::zero()) {
            return Some(FrustumTruth::TIE);
        }
        // On a rim the kernel may take either surface, with the error of it.
        let mut condition = first.condition;
        let mut part = Some(first.part);
        for other in all.iter().filter(|other| other.part != first.part) {
            let gap = (other.t.clone() - first.t.clone()).to_f64().abs();
            if gap <= TIE * UNIT_ROUNDOFF * (other.condition + first.condition) {
                condition = condition.max(other.condition);
                part = None;
            }
        }
        Some(frame.answer(&first.t, condition, part))
    }

    /// Of a ray that surely is inside the side somewhere in this part.
    fn open<N: Number>(frame: &Frame<N>, (lo, hi): &Part<N>) -> FrustumTruth {
        // Inside from one end to the other is inside all along.
        let within = |t: &N| {
            let (depth, doubt) = frame.depth(t);
            depth > doubt
        };
        if hi.as_ref().is_some_and(|hi| within(lo) && within(hi)) {
            return FrustumTruth::MISS;
        }
        let mut roots = frame.side_roots();
        roots.sort_by(|x, y| x.t.partial_cmp(&y.t).unwrap_or(Ordering::Equal));
        for Root { t, condition, on_body, part } in roots {
            let doubt = TIE * UNIT_ROUNDOFF * condition;
            if t.to_f64() < -doubt {
                continue;
            }
            match frame.beyond_ends(&t, condition) {
                Ordering::Less if t.to_f64() <= doubt => return FrustumTruth::TIE,
                Ordering::Less if on_body => return frame.answer(&t, condition, Some(part)),
                Ordering::Equal => return FrustumTruth::TIE,
                // Beyond an end; at an apex, by the exact numbers.
                _ => {}
            }
        }
        FrustumTruth::MISS
    }
}

impl<N: Number> Frame<N> {
    /// The answer, back in the ray's own unit.
    fn answer(&self, t: &N, condition: f64, part: Option<u32>) -> FrustumTruth {
        let hi = t.to_f64();
        let lo = (t.clone() - N::of(hi)).to_f64();
        let unit = self.t_unit;
        let truth = Truth::hit((hi * unit, lo * unit), condition * unit);
        FrustumTruth { truth, part }
    }
}

#[cfg(test)]
mod tests;
