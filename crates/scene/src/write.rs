//! `write`: a scene file back to text.

use ron::ser::PrettyConfig;
use serde::Serialize;

use crate::SceneFile;
use crate::diagnose::ron_options;

/// The text of a file: what is at its default left out, an object or light to a
/// line. Reading it gives the same file.
///
/// # Errors
/// What `ron` says of a `Check` that cannot be written.
pub fn write<Check: Serialize>(file: &SceneFile<Check>) -> Result<String, String> {
    /// Fields of the scene and of its check, and items of lists in them.
    const LINES_TO: usize = 3;
    let layout = PrettyConfig::new().depth_limit(LINES_TO);
    let text = ron_options().to_string_pretty(file, layout);
    text.map(|text| text + "\n").map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NoAssets, Unchecked, load};

    #[test]
    fn what_is_written_is_read_as_the_same() {
        let text = r#"(
            version: 1, image: (8, 6),
            camera: LookAt(eye: (0.1, 1e-300, 5), at: (-0.0, 0, 0), fov_deg: 40),
            materials: {"a b": Lambert(diffuse: (0.1, 0.2, 0.30000000000000004)), "c": Normal,
                "d": Mirror(schlick: true), "e": Dielectric(ior: 1.5, tint: (1, 1, 0.5)),
                "f": Whitted(reflect: (0.5, 0, 0), ior: 1.25), "g": Glazed(ior: 1.5)},
            bounces: 3,
            objects: [
                Sphere(center: (0, 0, 0), radius: 1, material: Named("a b")),
                Group(transform: [RotateDeg(0, 45, 0), Scale(1, 2, -1)], objects: []),
            ],
            lights: [Point(position: (3, 4, 5), falloff: Constant)],
            sampler: Sobol(seed: 3), samples_per_pixel: 5, show: Depth(near: 1, far: 2),
        )"#;
        let read = |text: &str| load::<Unchecked>(text, &NoAssets, tracer::accel::Build::Bvh);
        let file = read(text).unwrap().file;
        let written = write(&file).unwrap();
        assert_eq!(read(&written).unwrap().file, file, "{written}");
        assert!(written.lines().all(|line| line.len() < 120), "{written}");
        assert!(!written.contains("Some("), "{written}");
    }

    /// The canonical text of older files must stay, as goldens hold it.
    #[test]
    fn what_is_at_its_default_is_left_out() {
        let text = r#"(
            version: 1, image: (8, 6), bounces: 5,
            camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40),
            materials: {"a": Mirror(reflectance: (1, 1, 1), schlick: false),
                "b": Whitted(specular: (0, 0, 0), exponent: 1, reflect: (0, 0, 0), ior: 1)},
        )"#;
        let file = load::<Unchecked>(text, &NoAssets, tracer::accel::Build::Bvh).unwrap().file;
        let written = write(&file).unwrap();
        for left_out in ["bounces", "reflectance", "schlick", "specular", "exponent", "ior"] {
            assert!(!written.contains(left_out), "{written}");
        }
    }
}
