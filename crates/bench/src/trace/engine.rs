//! What every tracer of the bench can do, and making those asked for by name.

use std::path::PathBuf;
use std::rc::Rc;

use super::rays::RaySet;
use super::{embree, goldray, peer};
use crate::meshes::TriangleMesh;
use crate::peers;

/// A tracer with one mesh in it.
///
/// Its rays are put into its own records before the clock starts, and its
/// answers are read after it has stopped.
pub(crate) trait Engine {
    /// Takes these rays, and forgets those before.
    fn load(&mut self, set: &RaySet);

    /// Traces every ray: what is measured, on the calling thread alone.
    fn trace(&mut self);

    /// What it found, in the set's order: `t`, or any number for a ray of which
    /// only was asked whether it hits; `None` for a miss.
    fn answers(&self) -> Vec<Option<f64>>;

    /// The bytes that it holds, if it counts them itself.
    fn bytes(&self) -> Option<usize> {
        None
    }
}

/// Every engine, in the order of the tables.
pub(crate) const NAMES: [&str; 13] = [
    "goldray-accurate",
    "goldray-accurate-single",
    "goldray-fast",
    "goldray-fast-single",
    "embree4-avx2",
    "embree4-default",
    "embree4-high",
    "embree4-robust",
    "embree4-packet16",
    "embree3",
    "obvhs",
    "bvh",
    "parry3d",
];

/// The engine that ratios are to.
pub(crate) const BAR: &str = "embree4-avx2";

/// The engines that share another's hierarchy, which is built and counted there.
pub(crate) const SHARING: [&str; 3] =
    ["goldray-accurate-single", "goldray-fast-single", "embree4-packet16"];

/// A made engine and its name.
pub(crate) type Named = (&'static str, Box<dyn Engine>);

/// A mesh that is ready to build: calling it is what building costs.
pub(crate) type Job = Box<dyn FnOnce() -> Result<Box<dyn Engine>, String>>;

/// Other people's libraries, opened, or why they are not.
pub(crate) struct Libraries {
    embree4: Result<Rc<embree::Library>, String>,
    embree3: Result<Rc<embree::Library>, String>,
}

impl Libraries {
    pub(crate) fn open() -> Self {
        let open = |path: Option<PathBuf>, what: &str| {
            let missing = || format!("{what} is not installed: cargo xtask bench peers --install");
            embree::Library::open(&path.ok_or_else(missing)?)
        };
        Self {
            embree4: open(peers::embree4(), "the library of the wheel embreex"),
            embree3: open(peers::embree3(), "libembree3.so.3"),
        }
    }

    /// The libraries' versions by name, of those that are there.
    pub(crate) fn versions(&self) -> Vec<String> {
        let libraries = [&self.embree4, &self.embree3].into_iter().flatten();
        libraries.map(|library| format!("Embree {}", library.version)).collect()
    }

    /// What builds the engine of this name on so many threads.
    ///
    /// # Errors
    /// A library that is missing, a mesh that is refused, and an engine that
    /// builds on one thread only.
    pub(crate) fn prepare(
        &self,
        name: &str,
        threads: usize,
        mesh: &TriangleMesh,
    ) -> Result<Job, String> {
        if let Some(setting) = embree::Setting::named(name) {
            let library = if name == "embree3" { &self.embree3 } else { &self.embree4 };
            return setting.prepare(library.as_ref().map_err(Clone::clone)?, threads, mesh);
        }
        if let Some(build) = goldray::build_named(name) {
            return goldray::prepare(mesh, build, threads);
        }
        if threads == 1 { peer::prepare(name, mesh) } else { Err("builds on one thread".into()) }
    }
}

/// The engines of these names over a mesh; of each that cannot be made, why.
pub(crate) fn make(
    names: &[&'static str],
    mesh: &TriangleMesh,
    goldray: &goldray::Meshes,
    libraries: &Libraries,
) -> (Vec<Named>, Vec<(&'static str, String)>) {
    let (mut made, mut left_out) = (Vec::new(), Vec::new());
    for &name in names {
        let engine = match goldray.engine(name) {
            Some(engine) => Ok(Box::new(engine) as Box<dyn Engine>),
            None => libraries.prepare(name, 1, mesh).and_then(|job| job()),
        };
        match engine {
            Ok(engine) => made.push((name, engine)),
            Err(why) => left_out.push((name, why)),
        }
    }
    (made, left_out)
}
