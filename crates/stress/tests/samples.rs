//! Every sampler, filter and the adaptive pictures against truths by formula.
//!
//! `cargo test -p stress --test samples -- --nocapture` prints the errors.
#![allow(clippy::unwrap_used, clippy::disallowed_macros)]

use stress::known::{BOX, Known, known_pictures};
use stress::truth::coverage;
use tracer::{
    Event, Filter, LinearImage, Plan, Sampler, Samples, Scene, Skipping, render, render_counted,
};

/// The root mean square error of a picture, and its rays a pixel.
fn measure(known: &Known, scene: &Scene) -> (f64, f64) {
    let (picture, stats) = render_counted(scene, &Plan::new(scene, Skipping::On));
    (known.rmse(&picture), stats.get(Event::EyeRay) as f64 / known.truth.len() as f64)
}

fn sampled(known: &Known, sampler: Sampler, samples: u32) -> Scene {
    known.scene.with_samples(Samples::new(sampler, samples).unwrap()).unwrap()
}

/// How fast an error falls: the slope of its logarithm over that of the samples.
fn slope(from: (u32, f64), to: (u32, f64)) -> f64 {
    libm::log2(to.1 / from.1) / libm::log2(f64::from(to.0) / f64::from(from.0))
}

/// Without `--release`, as many as take no time.
const COUNTS: &[u32] =
    if cfg!(debug_assertions) { &[1, 4, 16, 64] } else { &[1, 4, 16, 64, 256, 1024] };

/// The errors of so many samples, and how fast they fall from four on.
fn errors(known: &Known, sampler: Sampler) -> (Vec<f64>, f64) {
    let errors: Vec<_> =
        COUNTS.iter().map(|n| measure(known, &sampled(known, sampler, *n)).0).collect();
    let last = COUNTS.len() - 1;
    let rate = slope((COUNTS[1], errors[1]), (COUNTS[last], errors[last]));
    (errors, rate)
}

fn shown(errors: &[f64]) -> String {
    errors.iter().map(|error| format!("{error:9.2e}")).collect::<Vec<_>>().join(" ")
}

#[test]
fn samplers_converge_at_their_rates() {
    for known in known_pictures().unwrap() {
        let samplers = [
            ("grid", Sampler::Grid),
            ("stratified", Sampler::Stratified { seed: 1 }),
            ("sobol", Sampler::Sobol { seed: 1 }),
        ];
        for (name, sampler) in samplers {
            let (errors, rate) = errors(&known, sampler);
            println!("{:14} {name:10} {}  rate {rate:.2}", known.name, shown(&errors));
            // An edge is cut by n^(1/2) of n cells, of which each is off by 1/n: a
            // rate of -3/4 where they are off independently of each other. A grid
            // has -1/2 where an edge runs along its rows: then all are off alike.
            let slowest = if sampler == Sampler::Grid { -0.35 } else { -0.65 };
            assert!(rate < slowest, "{} {name}: {rate}", known.name);
            // It is the truth that they converge to.
            assert!(errors[3] < 0.03, "{} {name}: {errors:?}", known.name);
        }
    }
}

/// The rays a pixel of the smallest of some grids that is as good; `None` if
/// none is.
fn grid_as_good(known: &Known, error: f64) -> Option<f64> {
    let mut grids =
        [2_u32, 4, 6, 8, 12, 16].map(|side| sampled(known, Sampler::Grid, side * side)).into_iter();
    grids.find_map(|scene| {
        let (found, rays) = measure(known, &scene);
        (found <= error).then_some(rays)
    })
}

#[test]
fn adaptive_pictures_keep_their_word_at_a_fifth_of_the_rays() {
    for known in known_pictures().unwrap() {
        for error in [1e-2, 3e-3, 1e-3] {
            let (found, rays) = measure(&known, &known.scene.with_error(error).unwrap());
            println!("{:14} {error:5.0e}: found {found:8.2e}, {rays:.1} rays a pixel", known.name);
            // Slivers that taper to nothing are lost where they are narrower than
            // a 16th of a pixel.
            let kept = if known.name == "needles" { 2.0 } else { 1.0 };
            assert!(found <= kept * error, "{} {error}: {found}", known.name);
            if error > 1e-3 {
                continue;
            }
            let grid = grid_as_good(&known, found.max(error));
            println!("{:14} a grid that is as good: {grid:?}", known.name);
            assert!(grid.is_none_or(|grid| grid >= 5.0 * rays), "{}: {rays} {grid:?}", known.name);
        }
    }
}

/// A box, through a filter.
fn filtered_truth(filter: Filter, breaks: &[f64], known: &Known) -> Vec<f64> {
    let size = known.scene.size();
    let middle = |k: u32, n: u32| f64::from(k) + 0.5 - 0.5 * f64::from(n);
    let pixels = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y)));
    let density = |x: f64| filter.density(x);
    pixels
        .map(|(x, y)| {
            let middle = [middle(x, size.width), middle(size.height - 1 - y, size.height)];
            coverage::filtered_rectangle(&density, breaks, BOX, middle)
        })
        .collect()
}

#[test]
fn filters_converge_to_the_integral_of_their_weights() {
    let known =
        known_pictures().unwrap().into_iter().find(|known| known.name == "one box").unwrap();
    let filters = [
        ("tent", Filter::tent(1.0).unwrap(), vec![-1.0, 0.0, 1.0]),
        ("gaussian", Filter::gaussian(1.5).unwrap(), vec![-1.5, 0.0, 1.5]),
        ("mitchell", Filter::mitchell(2.0).unwrap(), vec![-2.0, -1.0, 0.0, 1.0, 2.0]),
    ];
    for (name, filter, breaks) in filters {
        let truth = filtered_truth(filter, &breaks, &known);
        let exact = Known { name, scene: known.scene.with_filter(filter).unwrap(), truth };
        for sampler in [Sampler::Stratified { seed: 2 }, Sampler::Sobol { seed: 2 }] {
            let (errors, rate) = errors(&exact, sampler);
            println!("{name:10} {sampler:?} {} rate {rate:.2}", shown(&errors));
            assert!(rate < -0.65 && errors[3] < 4e-3, "{name} {sampler:?}: {rate} {errors:?}");
        }
        for error in [1e-2, 1e-3] {
            let found = measure(&exact, &exact.scene.with_error(error).unwrap()).0;
            println!("{name:10} adaptive {error:.0e} found {found:.1e}");
            assert!(found <= error, "{name} {error}: {found}");
        }
    }
}

#[test]
fn no_picture_depends_on_the_threads_or_on_skipping() {
    let known = &known_pictures().unwrap()[3];
    let mitchell = Filter::mitchell(2.0).unwrap();
    let scenes = [
        sampled(known, Sampler::Stratified { seed: 3 }, 4),
        sampled(known, Sampler::Sobol { seed: 3 }, 5),
        sampled(known, Sampler::Sobol { seed: 3 }, 5).with_filter(mitchell).unwrap(),
        sampled(known, Sampler::Grid, 4).with_filter(mitchell).unwrap(),
        known.scene.with_error(1e-2).unwrap(),
        known.scene.with_error(1e-2).unwrap().with_filter(mitchell).unwrap(),
    ];
    for scene in scenes {
        let on = |threads| -> LinearImage {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| render(&scene))
        };
        let one = on(1);
        assert!(one == on(2) && one == on(7), "{:?}", scene.samples());
        let all = render_counted(&scene, &Plan::new(&scene, Skipping::Off)).0;
        assert!(one == all, "{:?} {:?}", scene.samples(), scene.filter());
    }
}
