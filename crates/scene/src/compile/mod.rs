//! From what was written to what is valid: a [`SceneFile`] to a
//! [`tracer::Scene`].
//!
//! Nothing stops at the first mistake: what is wrong is left out or stood in
//! for, and the rest is judged as well.

mod materials;
mod objects;

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::{
    Camera, Convention, Filter, Group, Projection, Refused, Rgb, Samples, Scene, SceneParts, Size,
    Transform, View,
};

use crate::format::{self, SceneFile, Shading, VERSION};
use crate::{Assets, Step};
use objects::Objects;

/// Something that makes no sense, by its path in the file.
#[derive(Debug)]
pub(crate) struct Finding {
    pub(crate) path: Vec<Step>,
    pub(crate) message: String,
    pub(crate) help: Option<String>,
}

/// All findings so far.
#[derive(Debug, Default)]
struct Findings(Vec<Finding>);

impl Findings {
    fn add(&mut self, path: &Path, message: String) {
        self.0.push(Finding { path: path.0.clone(), message, help: None });
    }

    fn add_with_help(&mut self, path: &Path, message: String, help: String) {
        self.0.push(Finding { path: path.0.clone(), message, help: Some(help) });
    }

    /// The value, or `None` with every refusal noted at the field of its name.
    fn accept<T>(&mut self, path: &Path, result: Result<T, Refused>) -> Option<T> {
        result
            .map_err(|refused| {
                for r in refused.refusals() {
                    let message =
                        format!("`{}`: expected {}, found {}", r.field, r.expected, r.found);
                    self.add(&path.field(r.field), message);
                }
            })
            .ok()
    }
}

/// Where in a file something is.
#[derive(Debug, Clone, Default)]
struct Path(Vec<Step>);

impl Path {
    fn root() -> Self {
        Self::default()
    }

    fn field(&self, name: &'static str) -> Self {
        self.then(Step::from(name))
    }

    fn index(&self, index: usize) -> Self {
        self.then(Step::Index(index))
    }

    fn key(&self, key: &str) -> Self {
        self.then(Step::key(key))
    }

    fn then(&self, step: Step) -> Self {
        let mut steps = self.0.clone();
        steps.push(step);
        Self(steps)
    }
}

/// The scene, if its parts could be made, and all findings; a scene with
/// findings is not to be used.
pub(crate) fn compile<C>(
    file: &SceneFile<C>,
    assets: &dyn Assets,
    build: Build,
) -> (Option<Scene>, Vec<Finding>) {
    let mut findings = Findings::default();
    let root = Path::root();
    if file.version != VERSION {
        let message =
            format!("expected version {VERSION}, the one this build reads, found {}", file.version);
        findings.add(&root.field("version"), message);
    }
    let convention = match file.shading {
        Shading::Classic => Convention::Classic,
        Shading::Attenuated => Convention::Attenuated,
        Shading::Radiometric => Convention::Radiometric,
    };
    let lights = file.lights.iter().enumerate().filter_map(|(i, written)| {
        findings.accept(&root.field("lights").index(i), light(written, convention))
    });
    let lights = lights.collect();
    let materials = materials::resolve(&file.materials, convention, &mut findings);
    let world = Objects { assets, build, materials, convention, findings: &mut findings }
        .all(&root.field("objects"), &file.objects);
    let camera = findings.accept(&root.field("camera"), camera(&file.camera, file.image));
    let samples = Samples::new(file.sampler.into(), file.samples_per_pixel);
    let samples = findings.accept(&root, samples);
    let filter = findings.accept(&root.field("filter"), Filter::try_from(file.filter));
    // Stand-ins let the last constructor judge the rest all the same.
    let parts = camera.or_else(any_camera).map(|camera| SceneParts {
        camera,
        size: Size { width: file.image.0, height: file.image.1 },
        samples: samples.unwrap_or(Samples::ONE),
        filter: filter.unwrap_or(Filter::BOX),
        error: file.error,
        world: Group::new(Transform::IDENTITY, world, build),
        lights,
        convention,
        shadows: file.shadows,
        bounces: file.bounces,
        background: Rgb::from(file.background),
        exposure: file.exposure,
        show: show(file.show),
    });
    let scene = parts.and_then(|parts| findings.accept(&root, Scene::new(parts)));
    (scene, findings.0)
}

fn point(p: format::Triple) -> DVec3 {
    DVec3::from_array(p)
}

fn camera(written: &format::Camera, (width, height): (u32, u32)) -> Result<Camera, Refused> {
    use format::Camera::{LookAt, Parallel, Perspective};
    use format::Triple;

    let view = |view_point,
                [view_dir, view_up]: [Triple; 2],
                proj_normal: Option<_>,
                [w, h]: [f64; 2]| View {
        view_point: point(view_point),
        view_dir: point(view_dir),
        view_up: point(view_up),
        proj_normal: proj_normal.map(point),
        view_width: w,
        view_height: h,
    };
    match *written {
        Perspective {
            view_point: e,
            view_dir: dir,
            view_up: up,
            proj_normal: w,
            view_width,
            view_height,
            proj_distance,
        } => {
            let projection = Projection::Perspective { proj_distance };
            Camera::new(&view(e, [dir, up], w, [view_width, view_height]), projection)
        }
        Parallel {
            view_point: e,
            view_dir: dir,
            view_up: up,
            proj_normal: w,
            view_width,
            view_height,
        } => Camera::new(&view(e, [dir, up], w, [view_width, view_height]), Projection::Parallel),
        LookAt { eye, at, up, fov_deg } => {
            // A picture without pixels is refused by the scene.
            let aspect = f64::from(width.max(1)) / f64::from(height.max(1));
            Camera::look_at(point(eye), point(at), point(up), fov_deg, aspect)
        }
    }
}

fn any_camera() -> Option<Camera> {
    Camera::look_at(DVec3::Z, DVec3::ZERO, DVec3::Y, 90.0, 1.0).ok()
}

fn light(written: &format::Light, convention: Convention) -> Result<tracer::Light, Refused> {
    match *written {
        format::Light::Point { position, intensity, falloff } => {
            let falloff = match falloff {
                None => convention.default_falloff(),
                Some(format::Falloff::Constant) => tracer::Falloff::Constant,
                Some(format::Falloff::InverseSquare) => tracer::Falloff::InverseSquare,
            };
            tracer::Light::point(point(position), Rgb::from(intensity), falloff)
        }
        format::Light::Directional { direction, intensity } => {
            tracer::Light::directional(point(direction), Rgb::from(intensity))
        }
        format::Light::Ambient { intensity } => tracer::Light::ambient(Rgb::from(intensity)),
    }
}

fn show(written: format::Show) -> tracer::Show {
    match written {
        format::Show::Shaded => tracer::Show::Shaded,
        format::Show::Silhouette => tracer::Show::Silhouette,
        format::Show::SurfaceColor => tracer::Show::SurfaceColor,
        format::Show::Normals => tracer::Show::Normals,
        format::Show::Depth { near, far } => tracer::Show::Depth { near, far },
        format::Show::ObjectIds => tracer::Show::ObjectIds,
    }
}
