//! What surfaces show that send rays on: mirrors, glass, glazes, and Whitted's
//! sum of them all.
//!
//! The outside of a surface is the side of its geometric normal; a ray that
//! comes from the other side leaves. A ray that is sent on goes to the proper
//! side of the true surface, and is held against everything. Sums are taken in
//! one order: lit, reflected, refracted.

mod optics;
mod parts;
mod trail;

use crate::fault::{Fault, seeded};
use crate::meter::{Event, Meter, Work};
use crate::plan::Candidates;
use crate::scene::Look;
use crate::{Hit, Interval, Ray, Rgb, Scene};
use glam::DVec3;
use parts::Parts;
use trail::Trail;

/// The color of a hit of such a surface seen along `ray`, which may be sent on
/// `left` times more, and what tells it from other ways to a color.
// Kept apart from those of other surfaces, which must not wait for it.
#[inline(never)]
pub(crate) fn shade(
    scene: &Scene,
    ray: &Ray,
    hit: &Hit,
    left: u32,
    work: &Work<impl Meter>,
) -> (Rgb, u64) {
    let parts = Parts::of(ray, hit);
    let (mut color, mut trail) = (Rgb::BLACK, Trail::START);
    if let Some(share) = parts.lit {
        let (lit, shadows) = scene.lighting().radiance(ray, hit, work);
        color = if seeded(Fault::GlazeAdds) { lit } else { lit * share };
        trail = Trail(shadows);
    }
    let steps = [(Event::ReflectedRay, Trail::REFLECTED), (Event::RefractedRay, Trail::REFRACTED)];
    for ((part, outward), (event, way)) in parts.ways().into_iter().zip(steps) {
        let Some((direction, share)) = part else { continue };
        let adds = share != Rgb::BLACK;
        if left == 0 || (work.skips() && !adds) {
            continue;
        }
        work.count(event);
        let look = sent_on(scene, &hit.leaving_on(outward, direction), left - 1, work);
        color += look.color * share;
        if adds {
            trail = trail.and(way, &look);
        }
    }
    (color, trail.0)
}

/// The rays that a hit which is seen along `ray` sends on and whose colors it
/// shows: the reflected one first, then the refracted one.
pub fn rays_sent_on(ray: &Ray, hit: &Hit) -> Vec<Ray> {
    let onward = |(part, outward): (Part, bool)| {
        let (direction, share) = part?;
        (share != Rgb::BLACK).then(|| hit.leaving_on(outward, direction))
    };
    Parts::of(ray, hit).ways().into_iter().filter_map(onward).collect()
}

/// What a ray sees that was sent on, and may be `left` times more.
fn sent_on(scene: &Scene, ray: &Ray, left: u32, work: &Work<impl Meter>) -> Look {
    match scene.world().intersect_among(Candidates::All, ray, Interval::AHEAD, &work.meter) {
        Some(hit) => scene.look(ray, &hit, left, work),
        None if seeded(Fault::BackgroundNotReflected) => Look::nothing(Rgb::BLACK),
        None => Look::nothing(scene.background()),
    }
}

/// A part of what a surface shows: where it is seen, and how much of it.
type Part = Option<(DVec3, Rgb)>;

#[cfg(test)]
mod tests;
