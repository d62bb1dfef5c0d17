//! Wishes as people write them: a camera as in a scene file, a size, a
//! convention.

use scene::format::{Camera, Shading};
use scene::{NoAssets, Unchecked};

use super::Wishes;

impl Wishes {
    /// A camera as a scene file has it: `LookAt(eye: (0, 0, 5), ...)`.
    ///
    /// # Errors
    /// What is wrong with it, as text for people.
    pub fn camera(text: &str) -> Result<Camera, String> {
        let scene = format!("(version: 1, image: (1, 1), camera:\n{text}\n)");
        match scene::load::<Unchecked>(&scene, &NoAssets, tracer::accel::Build::default()) {
            Ok(loaded) => Ok(loaded.file.camera),
            Err(problems) => {
                let messages = problems.into_iter().map(|problem| problem.message);
                Err(messages.collect::<Vec<_>>().join("; "))
            }
        }
    }

    /// A picture's size in pixels: `320x240`.
    ///
    /// # Errors
    /// What is expected instead.
    pub fn image(text: &str) -> Result<(u32, u32), String> {
        let sides = text.split_once(['x', 'X']);
        let size = sides.and_then(|(w, h)| Some((w.trim().parse().ok()?, h.trim().parse().ok()?)));
        size.filter(|&(w, h): &(u32, u32)| w > 0 && h > 0)
            .ok_or_else(|| format!("expected width and height as in 320x240, found \"{text}\""))
    }

    /// A shading convention by its name, in any case.
    ///
    /// # Errors
    /// Which names there are.
    pub fn shading(text: &str) -> Result<Shading, String> {
        match &*text.to_ascii_lowercase() {
            "classic" => Ok(Shading::Classic),
            "attenuated" => Ok(Shading::Attenuated),
            "radiometric" => Ok(Shading::Radiometric),
            _ => Err(format!("expected classic, attenuated or radiometric, found \"{text}\"")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wishes_are_read_or_explained() {
        assert!(Wishes::camera("LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40)").is_ok());
        assert!(Wishes::camera("Parallel(view_point: (0, 0, 5)) // by hand").is_ok());
        let why = Wishes::camera("LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 240)");
        assert!(why.unwrap_err().contains("`fov_deg`"));
        for bad in ["", "LookAt(", "Perspective()", "5", ")", "LookAt(eye: (0, 0, 5))"] {
            assert!(Wishes::camera(bad).is_err(), "{bad}");
        }
        assert_eq!(Wishes::image("320x240"), Ok((320, 240)));
        assert_eq!(Wishes::image(" 1 X 2 "), Ok((1, 2)));
        for bad in ["", "x", "320", "0x5", "-1x5", "1.5x2", "1x2x3", "99999999999x1"] {
            assert!(Wishes::image(bad).unwrap_err().contains("320x240"), "{bad}");
        }
        assert_eq!(Wishes::shading("Radiometric"), Ok(Shading::Radiometric));
        assert!(Wishes::shading("phong").unwrap_err().contains("classic"));
    }
}
