//! `objects_seen`: which object each pixel shows.

use rayon::prelude::*;

use super::{begun, sample};
use crate::meter::{Unmetered, Work};
use crate::plan::Candidates;
use crate::{ObjectId, Plan, Scene, Size, Skipping, pixel_center};

/// The object in the middle of every pixel, row by row from the top; `None` for
/// the background. Samples and filters have no part in it.
pub fn objects_seen(scene: &Scene) -> Vec<Option<ObjectId>> {
    let (Size { width, height }, camera) = (scene.size(), scene.camera());
    let plan = Plan::new(scene, Skipping::On);
    let row = |y: u32| {
        // The lecture's row 0 is the lowest.
        let j = height - 1 - y;
        let work = Work::new(Unmetered, plan.skipping(), scene.lights().len());
        let pixel = |i| match begun(&plan, (i, j), &work) {
            Candidates::None => None,
            candidates => {
                let window = [
                    pixel_center(i, width, camera.view_width()),
                    pixel_center(j, height, camera.view_height()),
                ];
                let look = sample(scene, candidates, window, &work);
                look.surface.map(|(object, _)| object)
            }
        };
        (0..width).map(pixel).collect::<Vec<_>>()
    };
    let rows: Vec<_> = (0..height).into_par_iter().map(row).collect();
    rows.concat()
}
