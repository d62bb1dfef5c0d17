//! goldray as an engine: exact or fast, ray by ray or by the batch.

use std::rc::Rc;

use tracer::accel::{Build, Coherence};
use tracer::glam::DVec3;
use tracer::shape::{Contact, Geometry, Mesh};
use tracer::{Interval, Ray};

use super::engine::{Engine, Job};
use super::rays::{Query, RaySet};
use crate::meshes::TriangleMesh;

/// So many rays that run beside each other are handed over at once, as a renderer
/// does with a tile of 32 x 32 pixels.
const TILE_BATCH: usize = 1 << 10;
/// And so many that go anywhere, as one does that sends a picture's bounces wave
/// by wave.
const WAVE: usize = 1 << 18;
/// Rays beside each other come in tiles of this many pixels in each direction.
const TILE: u32 = 8;

/// The meshes that the engines share.
#[derive(Debug)]
pub(crate) struct Meshes {
    pub(crate) accurate: Rc<Mesh>,
    fast: Option<Rc<Mesh>>,
}

impl Meshes {
    /// Those that the engines of these names need; the accurate one always,
    /// which says what is right.
    ///
    /// # Errors
    /// A mesh that the tracer refuses.
    pub(crate) fn new(names: &[&str], mesh: &TriangleMesh) -> Result<Self, String> {
        let needs_fast = names.iter().any(|name| name.starts_with("goldray-fast"));
        let accurate = Rc::new(build(mesh, Build::Bvh)?);
        let fast = needs_fast.then(|| build(mesh, Build::Fast)).transpose()?.map(Rc::new);
        Ok(Self { accurate, fast })
    }

    /// The engine of this name, if it is one of goldray's.
    pub(crate) fn engine(&self, name: &str) -> Option<Goldray> {
        let (mesh, is_single) = match name {
            "goldray-accurate" => (&self.accurate, false),
            "goldray-accurate-single" => (&self.accurate, true),
            "goldray-fast" => (self.fast.as_ref()?, false),
            "goldray-fast-single" => (self.fast.as_ref()?, true),
            _ => return None,
        };
        Some(Goldray::new(mesh.clone(), is_single))
    }
}

/// The tracer's mesh of these triangles.
///
/// # Errors
/// What the tracer refuses of it.
pub(crate) fn build(mesh: &TriangleMesh, build: Build) -> Result<Mesh, String> {
    made(corners(mesh), mesh.faces.clone(), build)
}

fn corners(mesh: &TriangleMesh) -> Vec<DVec3> {
    mesh.vertices.iter().map(|v| DVec3::from_array(v.map(f64::from))).collect()
}

fn made(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>, build: Build) -> Result<Mesh, String> {
    let made = Mesh::new(vertices, faces, None, build);
    made.map_err(|why| format!("goldray refuses the mesh: {why}"))
}

/// Which hierarchy the engine of this name has, if it is one of goldray's.
pub(crate) fn build_named(name: &str) -> Option<Build> {
    match name {
        "goldray-accurate" | "goldray-accurate-single" => Some(Build::Bvh),
        "goldray-fast" | "goldray-fast-single" => Some(Build::Fast),
        _ => None,
    }
}

/// What builds a mesh on so many threads.
///
/// # Errors
/// Threads that cannot be made.
pub(crate) fn prepare(mesh: &TriangleMesh, build: Build, threads: usize) -> Result<Job, String> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|why| format!("{threads} threads: {why}"))?;
    let (vertices, faces) = (corners(mesh), mesh.faces.clone());
    Ok(Box::new(move || {
        let mesh = pool.install(|| made(vertices, faces, build))?;
        let mut engine = Goldray::new(Rc::new(mesh), false);
        engine.builders = Some(pool);
        Ok(Box::new(engine))
    }))
}

/// One way of asking goldray.
pub(crate) struct Goldray {
    mesh: Rc<Mesh>,
    is_single: bool,
    /// The set's number of each ray, in the order they are traced in.
    order: Vec<u32>,
    rays: Vec<Ray>,
    query: Query,
    range: Interval,
    coherence: Coherence,
    contacts: Vec<Option<Contact>>,
    occluded: Vec<bool>,
    /// The threads that built it, kept so that their time can be told.
    builders: Option<rayon::ThreadPool>,
}

impl Goldray {
    fn new(mesh: Rc<Mesh>, is_single: bool) -> Self {
        Self {
            mesh,
            is_single,
            order: Vec::new(),
            rays: Vec::new(),
            query: Query::Closest,
            range: Interval::AHEAD,
            coherence: Coherence::Incoherent,
            contacts: Vec::new(),
            occluded: Vec::new(),
            builders: None,
        }
    }
}

impl Engine for Goldray {
    fn load(&mut self, set: &RaySet) {
        self.order =
            if self.is_single { (0..set.rays.len() as u32).collect() } else { set.tiled(TILE) };
        self.rays.clear();
        self.rays.extend(self.order.iter().map(|&ray| set.rays[ray as usize].exact()));
        (self.query, self.range) = (set.query, set.range());
        let is_coherent = set.pixels.is_some();
        self.coherence = if is_coherent { Coherence::Coherent } else { Coherence::Incoherent };
        self.contacts.clear();
        self.contacts.resize(self.rays.len(), None);
        self.occluded.clear();
        self.occluded.resize(self.rays.len(), false);
    }

    fn trace(&mut self) {
        let (mesh, range, coherence) = (&*self.mesh, self.range, self.coherence);
        let size = match coherence {
            Coherence::Coherent => TILE_BATCH,
            Coherence::Incoherent => WAVE,
        };
        match (self.query, self.is_single) {
            (Query::Closest, true) => {
                for (ray, contact) in self.rays.iter().zip(&mut self.contacts) {
                    *contact = mesh.intersect(ray, range);
                }
            }
            (Query::Any, true) => {
                for (ray, occluded) in self.rays.iter().zip(&mut self.occluded) {
                    *occluded = mesh.occludes(ray, range);
                }
            }
            (Query::Closest, false) => {
                let batches = self.rays.chunks(size).zip(self.contacts.chunks_mut(size));
                for (rays, contacts) in batches {
                    mesh.intersect_batch(rays, range, coherence, contacts);
                }
            }
            (Query::Any, false) => {
                let batches = self.rays.chunks(size).zip(self.occluded.chunks_mut(size));
                for (rays, occluded) in batches {
                    mesh.occludes_batch(rays, range, coherence, occluded);
                }
            }
        }
    }

    fn answers(&self) -> Vec<Option<f64>> {
        let mut answers = vec![None; self.order.len()];
        for (place, &ray) in self.order.iter().enumerate() {
            answers[ray as usize] = match self.query {
                Query::Closest => self.contacts[place].map(|contact| contact.t),
                Query::Any => self.occluded[place].then_some(0.0),
            };
        }
        answers
    }
}
