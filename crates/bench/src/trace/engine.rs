//! What every tracer of the bench can do, and making those asked for by name.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::rays::RaySet;
use super::{embree, goldray};
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
}

/// Every engine, in the order of the tables.
pub(crate) const NAMES: [&str; 10] = [
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
];

/// The engine that ratios are to.
pub(crate) const BAR: &str = "embree4-avx2";

/// A made engine and its name.
pub(crate) type Named = (&'static str, Box<dyn Engine>);

/// The engines of these names over a mesh, and why each of the others is
/// missing.
///
/// # Errors
/// A mesh that goldray refuses.
pub(crate) fn make(
    names: &[&'static str],
    mesh: &TriangleMesh,
    goldray: &goldray::Meshes,
) -> (Vec<Named>, BTreeMap<&'static str, String>) {
    let embree4 = peers::embree4().ok_or_else(|| missing("embreex's libembree4"));
    let embree4 = embree4.and_then(|path| embree::Library::open(&path));
    let embree3 = peers::embree3().ok_or_else(|| missing("libembree3.so.3"));
    let embree3 = embree3.and_then(|path| embree::Library::open(&path));
    let (mut made, mut left_out) = (Vec::new(), BTreeMap::new());
    for &name in names {
        let engine: Result<Box<dyn Engine>, String> = if let Some(engine) = goldray.engine(name) {
            Ok(Box::new(engine))
        } else if let Some(setting) = embree::Setting::named(name) {
            let library = if name == "embree3" { &embree3 } else { &embree4 };
            library.clone().and_then(|library: Rc<_>| {
                Ok(Box::new(embree::Embree::new(&library, setting, mesh)?) as Box<dyn Engine>)
            })
        } else {
            Err("is unknown".to_owned())
        };
        match engine {
            Ok(engine) => made.push((name, engine)),
            Err(why) => {
                left_out.insert(name, why);
            }
        }
    }
    (made, left_out)
}

fn missing(what: &str) -> String {
    format!("{what} is not installed: cargo xtask bench peers --install")
}
