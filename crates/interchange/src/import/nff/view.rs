//! `View`: the viewpoint, from whose fields comes a camera.

use scene::format::Camera;

use super::reader::Reader;
use super::words::Word;
use crate::import::Wishes;

/// The fields of a viewpoint.
#[derive(Debug, Default)]
pub(super) struct View {
    begun_at: Option<usize>,
    from: Option<[f64; 3]>,
    at: Option<[f64; 3]>,
    up: Option<[f64; 3]>,
    angle: Option<f64>,
    resolution: Option<[f64; 2]>,
}

impl Reader<'_> {
    /// The letter that begins it.
    pub(super) fn viewpoint(&mut self, word: Word<'_>) {
        if self.view.begun_at.replace(word.at).is_some() {
            self.lost(word, "stands twice: only the last of each field counts");
        }
    }

    /// One of its fields.
    pub(super) fn view_field(&mut self, word: Word<'_>) -> Option<()> {
        match word.text {
            "from" => self.view.from = Some(self.numbers(word)?),
            "at" => self.view.at = Some(self.numbers(word)?),
            "up" => self.view.up = Some(self.numbers(word)?),
            "angle" => self.view.angle = Some(self.numbers::<1>(word)?[0]),
            "resolution" => self.view.resolution = Some(self.numbers(word)?),
            _ => {
                let [hither] = self.numbers(word)?;
                let what = format!("nothing is clipped at the hither distance of {hither:?}");
                self.report.chose(what);
            }
        }
        Some(())
    }

    /// The camera and the picture's size; `None` with a problem.
    ///
    /// `angle` spans from the middle of the top row to the middle of the bottom
    /// row, `ny - 1` pixels apart; pixels are square.
    pub(super) fn camera(&mut self, wishes: &Wishes) -> Option<(Camera, (u32, u32))> {
        let image = self.image(wishes)?;
        if let Some(camera) = wishes.camera {
            self.report.chose("the camera that was asked for");
            return Some((camera, image));
        }
        let View { begun_at, from, at, up, angle, .. } = self.view;
        let (Some(from), Some(at), Some(up), Some(angle)) = (from, at, up, angle) else {
            let fields = [
                ("from", from.is_none()),
                ("at", at.is_none()),
                ("up", up.is_none()),
                ("angle", angle.is_none()),
            ];
            let missing = fields.iter().filter(|field| field.1).map(|field| field.0);
            let missing = missing.collect::<Vec<_>>().join(", ");
            let message =
                format!("expected a viewpoint with from, at, up and angle, found no {missing}");
            self.report.missing(message, "give a camera beside the file");
            return None;
        };
        let place = begun_at.unwrap_or_default();
        let is_angle = 0.0 < angle && angle < 180.0;
        if !is_angle || image.1 < 2 {
            let message = format!(
                "v: expected an angle between 0 and 180 degrees across two rows or more, found \
                 {angle:?} across {}",
                image.1
            );
            self.unreadable(place, message);
            return None;
        }
        let pixel = 2.0 * libm::tan(0.5 * angle.to_radians()) / (f64::from(image.1) - 1.0);
        let camera = Camera::Perspective {
            view_point: from,
            view_dir: [at[0] - from[0], at[1] - from[1], at[2] - from[2]],
            view_up: up,
            proj_normal: None,
            view_width: f64::from(image.0) * pixel,
            view_height: f64::from(image.1) * pixel,
            proj_distance: 1.0,
        };
        let problems = self.sense.of(|file| (file.camera, file.image) = (camera, image));
        for problem in &problems {
            self.unreadable(place, format!("v: {problem}"));
        }
        problems.is_empty().then_some((camera, image))
    }

    fn image(&mut self, wishes: &Wishes) -> Option<(u32, u32)> {
        /// No picture has more pixels on a side.
        const MOST: f64 = 1e9;
        if let Some(asked) = wishes.image {
            self.report.chose(format!("{} x {} pixels, as was asked", asked.0, asked.1));
            return Some(asked);
        }
        let Some(numbers) = self.view.resolution else {
            let message = "expected a viewpoint with a resolution, found none";
            self.report.missing(message, "say it beside the file, as 512x512");
            return None;
        };
        let is_whole = |x: &f64| x.fract() == 0.0 && (1.0..MOST).contains(x);
        let place = self.view.begun_at.unwrap_or_default();
        if !numbers.iter().all(is_whole) {
            self.unreadable(place, "resolution: expected two whole numbers of pixels".to_owned());
            return None;
        }
        let image = (numbers[0] as u32, numbers[1] as u32);
        let problems = self.sense.of(|file| file.image = image);
        for problem in &problems {
            self.unreadable(place, format!("resolution: {problem}"));
        }
        problems.is_empty().then_some(image)
    }
}
