//! The camera, its film and its sampler.

use tracer::Projection;

use super::matrix;
use super::xml::float;
use crate::export::plain::Plain;

/// Nothing is cut off in front of this.
const NEAR: f64 = 1e-4;
/// Nor behind this.
const FAR: f64 = 1e7;

/// Mitsuba's cameras have x to the left, y up and z forward.
///
/// Of an oblique view the window is what counts: it is seen straight, along its
/// own normal, and lies beside the middle. Parallel rays are sheared.
pub(super) fn sensor(plain: &Plain) -> String {
    let camera = &plain.camera;
    let (e, forward) = (camera.eye(), *camera.forward());
    let [u, v] = camera.axes();
    let (width, height) = (camera.view_width(), camera.view_height());
    let (nx, ny) = (f64::from(plain.size.0), f64::from(plain.size.1));
    let (kind, own, columns) = match camera.projection() {
        Projection::Perspective { proj_distance } => {
            let middle = proj_distance * forward;
            let ahead = v.cross(*u);
            let fov_deg = 2.0 * libm::atan(0.5 * width / middle.dot(ahead)).to_degrees();
            let mut own =
                format!("<string name=\"fov_axis\" value=\"x\"/>{}", float("fov", fov_deg));
            let (right, up) = (middle.dot(*u) / width, middle.dot(*v) / height);
            // Where the axis meets the film, from its middle: to the right and down.
            for (name, offset) in [("x", -right), ("y", up)] {
                if offset.abs() > ROUNDING {
                    own += &float(&format!("principal_point_offset_{name}"), offset);
                }
            }
            ("perspective", own, [-*u, *v, ahead, e])
        }
        Projection::Parallel => {
            let axes = [-*u * (0.5 * width), *v * (0.5 * height * nx / ny), forward, e];
            ("orthographic", String::new(), axes)
        }
    };
    let side = plain.grid;
    format!(
        "<sensor type=\"{kind}\">\n  {own}{}{}\n  <transform name=\"to_world\">{}</transform>\n  \
         <film type=\"hdrfilm\">\n    <integer name=\"width\" value=\"{}\"/>\n    \
         <integer name=\"height\" value=\"{}\"/>\n    \
         <string name=\"pixel_format\" value=\"rgb\"/>\n    \
         <string name=\"component_format\" value=\"float32\"/>\n    <rfilter type=\"box\"/>\n  \
         </film>\n  <sampler type=\"stratified\">\n    \
         <integer name=\"sample_count\" value=\"{}\"/>\n    \
         <boolean name=\"jitter\" value=\"false\"/>\n  </sampler>\n</sensor>\n",
        float("near_clip", NEAR),
        float("far_clip", FAR),
        matrix(columns.map(|v| v.to_array())),
        plain.size.0,
        plain.size.1,
        side * side
    )
}

/// What an offset may be off by that is none.
const ROUNDING: f64 = 1e-12;
