//! A smaller picture of a scene, and one made with less of what the format has.

use scene::format::{Encoding, Filter, Sampler, Shading};
use tracer::Scene;

use super::Search;
use crate::check::File;
use crate::relation::Window;

/// Cuts the picture in halves, of which one still fails; then makes it coarser.
pub(super) fn picture(search: &mut Search<'_>) {
    while half(search) {}
    loop {
        let (width, height) = search.best.image;
        let is_taken = [(width / 2, height / 2), (width / 2, height), (width, height / 2)]
            .into_iter()
            .filter(|&(width, height)| width > 0 && height > 0)
            .any(|image| search.take_with(|file| file.image = image));
        if !is_taken {
            break;
        }
    }
}

/// One half of the picture, if one of the four fails.
fn half(search: &mut Search<'_>) -> bool {
    let (width, height) = search.best.image;
    let (w, h) = (width.div_ceil(2), height.div_ceil(2));
    let halves = [
        ((0, 0), (w, height)),
        ((width - w, 0), (w, height)),
        ((0, 0), (width, h)),
        ((0, height - h), (width, h)),
    ];
    halves.into_iter().filter(|&(_, size)| size != (width, height)).any(|(at, size)| {
        search.take_with(|file| {
            let window = Window::of(&file.camera, file.image).part(at, size, file.image);
            (file.camera, file.image) = (window.camera(), size);
        })
    })
}

/// Puts what can be to its default.
pub(super) fn settings(search: &mut Search<'_>) {
    let changes: [fn(&mut File); 9] = [
        |file| (file.samples_per_pixel, file.sampler) = (1, Sampler::default()),
        |file| file.error = None,
        |file| file.filter = Filter::default(),
        |file| file.background = [0.0; 3],
        |file| file.exposure = 1.0,
        |file| file.shadows = false,
        |file| file.bounces = Scene::DEFAULT_BOUNCES,
        |file| file.shading = Shading::default(),
        |file| file.encoding = Encoding::default(),
    ];
    for change in changes {
        search.take_with(change);
    }
}
