//! What the samples of a picture see of its surfaces, in mirrors and through glass
//! too: a dialect may shade front sides as goldray does, and back sides not.

use scene::format::{Falloff, Object, Shading};
use tracer::glam::DVec3;
use tracer::{Hit, Interval, Projection, Ray, Scene, UnitVec, pixel_center, rays_sent_on};

use super::look::{Way, brightest};
use super::within::is_within;
use super::{Lamp, Look, Placed, Plain};
use crate::Feature;

/// Follows the eye rays of all samples, and notes at their objects what is seen.
pub(super) fn note(plain: &mut Plain, scene: &Scene) {
    let (width, height) = (plain.size.0 * plain.grid, plain.size.1 * plain.grid);
    let camera = plain.camera;
    let is_parallel = matches!(camera.projection(), Projection::Parallel);
    for j in 0..height {
        let b = pixel_center(j, height, camera.view_height());
        for i in 0..width {
            let ray = camera.ray(pixel_center(i, width, camera.view_width()), b);
            let mut inside = glass_around(plain, ray.origin);
            // Rays that start in many places may be taken to start in one.
            if is_parallel && !(inside.is_empty() && glass_around(plain, camera.eye()).is_empty()) {
                inside = vec![NONE];
            }
            if let Some(object) = inside.first().and_then(|&number| plain.objects.get_mut(number)) {
                object.holds_eye = true;
            }
            follow(plain, scene, &ray, plain.bounces, &inside);
        }
    }
}

/// No object: what cannot be left.
const NONE: usize = usize::MAX;

/// The object of glass, or with a glaze, that a point is in and in no other. A renderer
/// that is told only what is inside of what cannot know which one counts where there are
/// several, be the others of glass or not.
fn glass_around(plain: &Plain, point: DVec3) -> Vec<usize> {
    let has_index = |object: &Placed| object.way.is_some_and(|way| way.index().is_some());
    if !plain.objects.iter().any(has_index) {
        return Vec::new();
    }
    let all = plain.objects.iter().enumerate();
    let around: Vec<_> = all.filter(|(_, object)| is_within(object, point)).collect();
    match &around[..] {
        all if !all.iter().any(|(_, object)| has_index(object)) => Vec::new(),
        [(number, object)] if !matches!(object.shape, Object::Disk { .. }) => vec![*number],
        _ => vec![NONE],
    }
}

/// Notes what a ray sees that may be sent on `left` times more, and what those see; it
/// is inside of these objects of glass.
fn follow(plain: &mut Plain, scene: &Scene, ray: &Ray, left: u32, inside: &[usize]) {
    let Some(hit) = scene.world().intersect(ray, Interval::AHEAD) else { return };
    note_hit(plain, scene, ray, &hit);
    let number = hit.object.0 as usize;
    let Some(way) = plain.objects.get(number).and_then(|object| object.way) else { return };
    if left == 0 {
        return;
    }
    let is_outward = |ray: &Ray| hit.geometric_normal.dot(ray.direction) > 0.0;
    let leaves = is_outward(ray);
    let all = rays_sent_on(ray, &hit);
    let goes_through = |onward: &Ray| is_outward(onward) == leaves;
    let counts = |&number: &usize| {
        let way = plain.objects.get(number).and_then(|object| object.way);
        way.and_then(Way::index) != Some(1.0)
    };
    let mut ask = |asked: bool, feature| {
        if asked {
            plain.of_glass.insert(feature);
        }
    };
    // Within an index of 1 an index is what it is outside.
    let is_met_within = !leaves && way.index().is_some() && inside.iter().any(counts);
    ask(is_met_within, Feature::NestedGlass);
    let is_new = leaves && way.is_clear() && !inside.contains(&number);
    ask(is_new, Feature::GlassFromBehind);
    let is_total = way.is_lit() && way.is_clear() && !all.iter().any(goes_through);
    ask(is_total, Feature::TotalReflection);
    for onward in all {
        let mut inside = inside.to_vec();
        if goes_through(&onward) {
            if leaves {
                inside.retain(|&object| object != number);
            } else {
                inside.push(number);
            }
        }
        follow(plain, scene, &onward, left - 1, &inside);
    }
}

fn note_hit(plain: &mut Plain, scene: &Scene, ray: &Ray, hit: &Hit) {
    note_reach(plain, hit);
    plain.needs_gap = plain.needs_gap || needs_gap(plain, scene, hit);
    let Some(object) = plain.objects.get_mut(hit.object.0 as usize) else { return };
    let n = *hit.shading_normal;
    let is_back = !(n.dot(ray.direction) < 0.0);
    object.back_is_seen |= is_back;
    let Look::Lit { highlight: Some((specular, exponent)), .. } = object.look else { return };
    // In the radiometric convention highlights are times the cosine, and end with it.
    if plain.shading == Shading::Radiometric {
        return;
    }
    let glows = |lamp: &Lamp| {
        /// What of a highlight nobody sees.
        const DARK: f64 = 1e-7;
        let (shadow_ray, range) = towards(lamp, hit);
        let intensity = match *lamp {
            Lamp::Point { intensity, falloff: Falloff::InverseSquare, .. } => {
                brightest(intensity) / shadow_ray.direction.length_squared()
            }
            Lamp::Point { intensity, .. } | Lamp::Directional { intensity, .. } => {
                brightest(intensity)
            }
        };
        let unit = |v| UnitVec::new(v).map_or(DVec3::ZERO, |v| *v);
        let (l, v) = (unit(shadow_ray.direction), unit(-ray.direction));
        let glow = n.dot(unit(l + v)).clamp(0.0, 1.0);
        brightest(specular) * libm::pow(glow, exponent) * intensity > DARK
            && !(plain.shadows && scene.world().occludes(&shadow_ray, range))
    };
    let is_behind = |lamp: &Lamp| n.dot(towards(lamp, hit).0.direction) <= 0.0;
    object.glows_from_behind |=
        plain.lamps.iter().any(|lamp| (is_back || is_behind(lamp)) && glows(lamp));
}

/// The ray from a hit to a light, and where on it something is in the way.
fn towards(lamp: &Lamp, hit: &Hit) -> (Ray, Interval) {
    match *lamp {
        Lamp::Point { position, .. } => (hit.leaving_to(position.into()), Interval::new(0.0, 1.0)),
        Lamp::Directional { direction, .. } => {
            (hit.leaving(-DVec3::from(direction)), Interval::AHEAD)
        }
    }
}

/// Whether something is between a lit point and a light, and so near to the
/// point that it does not count.
fn needs_gap(plain: &Plain, scene: &Scene, hit: &Hit) -> bool {
    let gap = scene.parts().convention.shadow_gap();
    let is_lit = || {
        let object = plain.objects.get(hit.object.0 as usize);
        plain.shadows && object.is_some_and(|object| object.look.is_lit())
    };
    if gap == 0.0 || !is_lit() {
        return false;
    }
    plain.lamps.iter().any(|lamp| {
        let (ray, Interval { lo, hi }) = towards(lamp, hit);
        // It shades where the light falls, and no light falls on its back.
        let faces = hit.shading_normal.dot(ray.direction) > 0.0;
        let lo_of_gap = lo + gap / ray.direction.length();
        faces
            && scene.world().occludes(&ray, Interval::new(lo, hi))
            && !scene.world().occludes(&ray, Interval::new(lo_of_gap, hi))
    })
}

/// Notes how far from its point each plane is seen, or stands between a seen
/// point and a light: so much of it makes the same picture.
fn note_reach(plain: &mut Plain, hit: &Hit) {
    let Plain { objects, lamps, .. } = plain;
    for (number, object) in objects.iter_mut().enumerate() {
        let Object::Plane { point, normal, .. } = object.shape else { continue };
        let map = object.world_from_object;
        let point = map.transform_point3(DVec3::from(point));
        let normal = map.matrix3.inverse().transpose() * DVec3::from(normal);
        let mut note = |p: DVec3| object.reach = object.reach.max(p.distance(point));
        if hit.object.0 as usize == number {
            note(hit.point);
            continue;
        }
        for lamp in lamps.iter() {
            let (way, end) = match *lamp {
                Lamp::Point { position, .. } => (DVec3::from(position) - hit.point, 1.0),
                Lamp::Directional { direction, .. } => (-DVec3::from(direction), f64::INFINITY),
            };
            let t = (point - hit.point).dot(normal) / way.dot(normal);
            // A way along the plane has no `t`.
            if 0.0 <= t && t <= end && t.is_finite() {
                note(hit.point + t * way);
            }
        }
    }
}
