//! Cameras and lights of a glTF file.

use scene::format::{Falloff, Light};
use tracer::glam::{DAffine3, DVec3};

use super::document::{self, Camera};
use crate::import::mesh::shot::{Lens, Shot};
use crate::import::mesh::tally::Tally;

/// A camera where its node is, whose scale does not count.
///
/// # Errors
/// What is wrong with its numbers.
pub(super) fn shot(
    camera: &Camera,
    world: &DAffine3,
    place: &str,
    lost: &mut Tally,
) -> Result<Shot, String> {
    let lens = match (&camera.perspective, &camera.orthographic) {
        (Some(perspective), None) => {
            let (fov, aspect) = (perspective.yfov, perspective.aspect_ratio);
            if !(fov > 0.0 && fov < std::f64::consts::PI) {
                return Err(format!("expected a yfov between 0 and pi, found {fov}"));
            }
            if let Some(aspect) = aspect {
                ratio("aspectRatio", aspect)?;
            }
            Lens::Perspective { fov, aspect }
        }
        (None, Some(window)) => {
            let (xmag, ymag) = (window.xmag, window.ymag);
            if !(xmag > 0.0 && ymag > 0.0) {
                return Err(format!("expected xmag and ymag above 0, found {xmag} and {ymag}"));
            }
            ratio("xmag over ymag", xmag / ymag)?;
            Lens::Parallel { size: [2.0 * xmag, 2.0 * ymag] }
        }
        _ => return Err("expected `perspective` or `orthographic`, one of them".to_owned()),
    };
    if world.matrix3.determinant() < 0.0 {
        lost.add(None, place, "the mirror in its node's map is left out");
    }
    let to = |axis: DVec3| (world.matrix3 * axis).try_normalize();
    let (forward, up) = to(-DVec3::Z)
        .zip(to(DVec3::Y))
        .ok_or("expected a camera that looks somewhere, found a node without extent")?;
    Ok(Shot { eye: world.translation, forward, up, lens })
}

/// Of which a picture can be made.
fn ratio(what: &str, x: f64) -> Result<(), String> {
    const SANE: std::ops::RangeInclusive<f64> = 1e-3..=1e3;
    let is_sane = SANE.contains(&x);
    is_sane.then_some(()).ok_or_else(|| {
        format!("expected {what} from {} to {}, found {x}", SANE.start(), SANE.end())
    })
}

/// A light where its node is; `None` for one that is lost.
///
/// # Errors
/// What is wrong with its numbers.
pub(super) fn light(
    light: &document::Light,
    world: &DAffine3,
    place: &str,
    lost: &mut Tally,
) -> Result<Option<Light>, String> {
    /// The tracer's own limit.
    const BRIGHTEST: f64 = 1e60;
    let bright = light.intensity.unwrap_or(1.0);
    let intensity = light.color.unwrap_or([1.0; 3]).map(|x| x * bright);
    if !intensity.iter().all(|x| (0.0..=BRIGHTEST).contains(x)) {
        return Err(format!("expected a color and an intensity from 0, found {intensity:?}"));
    }
    if light.range.is_some() {
        lost.add(None, format!("{place}: range"), "it is left out: the light reaches everywhere");
    }
    match &light.kind[..] {
        "point" => Ok(Some(Light::Point {
            position: world.translation.to_array(),
            intensity,
            falloff: Some(Falloff::InverseSquare),
        })),
        "directional" => {
            let Some(travel) = (world.matrix3 * -DVec3::Z).try_normalize() else {
                return Err("expected a light that shines somewhere, found a node without extent"
                    .to_owned());
            };
            Ok(Some(Light::Directional { direction: travel.to_array(), intensity }))
        }
        "spot" => {
            lost.add(None, place, "spot lights are left out");
            Ok(None)
        }
        kind => {
            let kind: String = kind.chars().take(20).collect();
            Err(format!("expected a light of type point, directional or spot, found \"{kind}\""))
        }
    }
}
