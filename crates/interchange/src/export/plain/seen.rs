//! What the samples of a picture see of its surfaces: a dialect may shade
//! front sides as goldray does, and back sides not.

use scene::format::{Falloff, Object, Shading};
use tracer::glam::DVec3;
use tracer::{Hit, Interval, Ray, Scene, UnitVec, pixel_center};

use super::look::brightest;
use super::{Lamp, Look, Plain};

/// Follows the eye rays of all samples, and notes at their objects what is seen.
pub(super) fn note(plain: &mut Plain, scene: &Scene) {
    let (width, height) = (plain.size.0 * plain.grid, plain.size.1 * plain.grid);
    let camera = plain.camera;
    for j in 0..height {
        let b = pixel_center(j, height, camera.view_height());
        for i in 0..width {
            let ray = camera.ray(pixel_center(i, width, camera.view_width()), b);
            if let Some(hit) = scene.world().intersect(&ray, Interval::AHEAD) {
                note_hit(plain, scene, &ray, &hit);
            }
        }
    }
}

fn note_hit(plain: &mut Plain, scene: &Scene, ray: &Ray, hit: &Hit) {
    note_reach(plain, hit);
    let Some(object) = plain.objects.get_mut(hit.object.0 as usize) else { return };
    let n = *hit.shading_normal;
    object.back_is_seen |= !(n.dot(ray.direction) < 0.0);
    let Look::Lit { highlight: Some((specular, exponent)), .. } = object.look else { return };
    // In the radiometric convention highlights are times the cosine, and end with it.
    if object.glows_from_behind || plain.shading == Shading::Radiometric {
        return;
    }
    let from_behind = |lamp: &Lamp| {
        /// What of a highlight nobody sees.
        const DARK: f64 = 1e-7;
        let (shadow_ray, range, intensity) = match *lamp {
            Lamp::Point { position, intensity, falloff } => {
                let ray = hit.leaving_to(position.into());
                let falloff = match falloff {
                    Falloff::Constant => 1.0,
                    Falloff::InverseSquare => ray.direction.length_squared().recip(),
                };
                (ray, Interval::new(0.0, 1.0), brightest(intensity) * falloff)
            }
            Lamp::Directional { direction, intensity } => {
                (hit.leaving(-DVec3::from(direction)), Interval::AHEAD, brightest(intensity))
            }
        };
        let unit = |v| UnitVec::new(v).map_or(DVec3::ZERO, |v| *v);
        let (l, v) = (unit(shadow_ray.direction), unit(-ray.direction));
        let glow = n.dot(unit(l + v)).clamp(0.0, 1.0);
        n.dot(l) <= 0.0
            && brightest(specular) * libm::pow(glow, exponent) * intensity > DARK
            && !(plain.shadows && scene.world().occludes(&shadow_ray, range))
    };
    object.glows_from_behind = plain.lamps.iter().any(from_behind);
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
