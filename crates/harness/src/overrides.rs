//! `Overrides`: how a picture is sampled, in place of what its scene says.

use scene::format;
pub use tracer::{Filter, Sampler};
use tracer::{Samples, Scene};

/// What is asked for instead; what is `None` stays as the scene has it.
#[derive(Debug, Clone, Default)]
pub struct Overrides {
    /// So many samples in each pixel.
    pub samples: Option<u32>,
    /// Spread in this way.
    pub sampler: Option<Sampler>,
    /// Seen through this filter.
    pub filter: Option<Filter>,
    /// Added up to this error. The scene's own samples are then not taken.
    pub error: Option<f64>,
}

impl Overrides {
    /// The scene, sampled as asked for.
    ///
    /// # Errors
    /// What is refused, as text for people.
    pub fn apply(&self, scene: &Scene) -> Result<Scene, String> {
        let mut scene = scene.clone();
        let said = |refused: tracer::Refused| refused.to_string();
        if self.error.is_some() && (self.samples.is_some() || self.sampler.is_some()) {
            return Err("expected an error or samples, found both: an error places samples itself"
                .to_owned());
        }
        if self.samples.is_some() || self.sampler.is_some() {
            let written = scene.samples();
            let sampler = self.sampler.unwrap_or(written.sampler());
            let count = self.samples.unwrap_or(written.samples_per_pixel());
            let samples = Samples::new(sampler, count).map_err(said)?;
            scene = scene.with_samples(samples).map_err(said)?;
        }
        if let Some(filter) = self.filter {
            scene = scene.with_filter(filter).map_err(said)?;
        }
        if let Some(error) = self.error {
            scene = scene.with_error(error).map_err(said)?;
        }
        Ok(scene)
    }
}

/// The sampler of a text such as `grid`, `stratified` or `sobol:7`, where the
/// number is a seed.
///
/// # Errors
/// What was expected, as text for people.
pub fn sampler(text: &str) -> Result<Sampler, String> {
    let (name, number) = parted(text);
    let seed = number.map_or(Ok(0), str::parse);
    match (name, number, seed) {
        ("grid", None, _) => Ok(Sampler::Grid),
        ("stratified", _, Ok(seed)) => Ok(Sampler::Stratified { seed }),
        ("sobol", _, Ok(seed)) => Ok(Sampler::Sobol { seed }),
        _ => Err(format!(
            "expected grid, stratified or sobol, the last two with a seed if wanted, such as \
             sobol:7, found \"{text}\""
        )),
    }
}

/// The filter of a text such as `box`, `tent`, `gaussian:1.5` or `mitchell:2`,
/// where the number is a radius in pixels.
///
/// # Errors
/// What was expected, as text for people.
pub fn filter(text: &str) -> Result<Filter, String> {
    let (name, number) = parted(text);
    let expected = || {
        format!(
            "expected box, tent, gaussian or mitchell, the last three with a radius if wanted, \
             such as tent:1, found \"{text}\""
        )
    };
    let radius = |usual: f64| number.map_or(Ok(usual), str::parse);
    let filter = match (name, number) {
        ("box", None) => return Ok(Filter::BOX),
        ("tent", _) => radius(format::Filter::TENT_RADIUS).map(Filter::tent),
        ("gaussian", _) => radius(format::Filter::GAUSSIAN_RADIUS).map(Filter::gaussian),
        ("mitchell", _) => radius(format::Filter::MITCHELL_RADIUS).map(Filter::mitchell),
        _ => return Err(expected()),
    };
    let filter = filter.map_err(|_: std::num::ParseFloatError| expected())?;
    filter.map_err(|refused| refused.to_string())
}

/// What is before the colon, and after it if there is one.
fn parted(text: &str) -> (&str, Option<&str>) {
    text.split_once(':').map_or((text, None), |(name, number)| (name, Some(number)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samplers_and_filters_have_names_and_numbers() {
        assert_eq!(sampler("grid"), Ok(Sampler::Grid));
        assert_eq!(sampler("stratified"), Ok(Sampler::Stratified { seed: 0 }));
        assert_eq!(sampler("sobol:7"), Ok(Sampler::Sobol { seed: 7 }));
        for bad in ["", "Sobol", "sobol:", "sobol:-1", "grid:1", "sobol:1:2", "halton"] {
            assert!(sampler(bad).unwrap_err().contains(&format!("found \"{bad}\"")), "{bad}");
        }
        assert_eq!(filter("box"), Ok(Filter::BOX));
        assert_eq!(filter("tent"), filter("tent:1"));
        assert_eq!(filter("gaussian"), Ok(Filter::gaussian(1.5).unwrap()));
        assert_eq!(filter("mitchell:1.5"), Ok(Filter::mitchell(1.5).unwrap()));
        for bad in ["", "box:1", "tent:", "tent:wide", "Tent", "sinc"] {
            assert!(filter(bad).unwrap_err().contains(&format!("found \"{bad}\"")), "{bad}");
        }
        assert!(filter("tent:9").unwrap_err().contains("from 0.5 to 4, found 9"));
        assert!(filter("tent:nan").is_err());
    }

    #[test]
    fn what_is_not_asked_for_stays() {
        let text = "(version: 1, image: (8, 6), samples_per_pixel: 16, sampler: Sobol(seed: 3),
            filter: Tent(), camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40))";
        let loaded =
            scene::load::<scene::Unchecked>(text, &scene::NoAssets, tracer::accel::Build::Bvh);
        let scene = loaded.unwrap().scene;
        let with = |overrides: Overrides| overrides.apply(&scene);
        assert_eq!(with(Overrides::default()).unwrap(), scene);
        let more = with(Overrides { samples: Some(64), ..Overrides::default() }).unwrap();
        let sobol = Sampler::Sobol { seed: 3 };
        assert_eq!(more.samples(), Samples::new(sobol, 64).unwrap());
        assert_eq!(more.filter(), scene.filter());
        let adaptive = with(Overrides { error: Some(0.1), ..Overrides::default() }).unwrap();
        assert_eq!((adaptive.samples(), adaptive.error()), (Samples::ONE, Some(0.1)));
        let both = Overrides { error: Some(0.1), samples: Some(4), ..Overrides::default() };
        assert!(with(both).unwrap_err().contains("found both"));
        let odd =
            Overrides { samples: Some(5), sampler: Some(Sampler::Grid), ..Overrides::default() };
        assert!(with(odd).unwrap_err().contains("a square number"));
    }
}
