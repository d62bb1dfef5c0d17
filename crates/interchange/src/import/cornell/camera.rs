//! Cameras of the course: the assignment's own words, with its defaults.

use scene::format::Camera;

use super::element::{Element, Fields};
use super::reader::Reader;
use crate::import::Wishes;

/// The fields of both kinds of cameras.
const VIEW: [&str; 6] = ["viewpoint", "viewdir", "viewup", "projnormal", "viewwidth", "viewheight"];

impl Reader<'_> {
    /// The camera that was asked for, or the file's; `None` with a problem.
    ///
    /// Without a type it is a perspective one, as in the classic files. What is
    /// left out has their default: at the origin, into the screen, all sizes 1.
    pub(super) fn camera(
        &mut self,
        node: Option<Element<'_>>,
        image: (u32, u32),
        wishes: &Wishes,
    ) -> Option<Camera> {
        if let Some(asked) = wishes.camera {
            self.notes.report.chose("the camera that was asked for");
            return Some(asked);
        }
        let Some(node) = node else {
            let message = "expected an element camera, found none";
            self.notes.report.missing(message, "give a camera beside the file");
            return None;
        };
        self.notes.only_attributes(node, &["type"]);
        let camera = match &*self.kind(node, Some("PerspectiveCamera"))? {
            "perspectivecamera" => self.perspective(node),
            "orthographiccamera" | "parallelcamera" => self.parallel(node),
            _ => {
                let what = "expected the type PerspectiveCamera or OrthographicCamera";
                self.notes.unreadable(node, what, Some("give a camera beside the file"));
                return None;
            }
        };
        let problems = self.sense.of(|file| (file.camera, file.image) = (camera, image));
        self.judge(node, problems).then_some(camera)
    }

    fn perspective(&mut self, node: Element<'_>) -> Camera {
        let mut known = VIEW.to_vec();
        known.push("projdistance");
        let fields = Fields::of(node, &known, &[], &mut self.notes);
        let notes = &mut self.notes;
        Camera::Perspective {
            view_point: fields.triple("viewpoint", notes).unwrap_or_default(),
            view_dir: fields.triple("viewdir", notes).unwrap_or([0.0, 0.0, -1.0]),
            view_up: fields.triple("viewup", notes).unwrap_or([0.0, 1.0, 0.0]),
            proj_normal: fields.triple("projnormal", notes),
            view_width: fields.number("viewwidth", notes).unwrap_or(1.0),
            view_height: fields.number("viewheight", notes).unwrap_or(1.0),
            proj_distance: fields.number("projdistance", notes).unwrap_or(1.0),
        }
    }

    fn parallel(&mut self, node: Element<'_>) -> Camera {
        let fields = Fields::of(node, &VIEW, &[], &mut self.notes);
        let notes = &mut self.notes;
        Camera::Parallel {
            view_point: fields.triple("viewpoint", notes).unwrap_or_default(),
            view_dir: fields.triple("viewdir", notes).unwrap_or([0.0, 0.0, -1.0]),
            view_up: fields.triple("viewup", notes).unwrap_or([0.0, 1.0, 0.0]),
            proj_normal: fields.triple("projnormal", notes),
            view_width: fields.number("viewwidth", notes).unwrap_or(1.0),
            view_height: fields.number("viewheight", notes).unwrap_or(1.0),
        }
    }
}
