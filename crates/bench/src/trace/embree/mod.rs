//! Embree 3 and 4 as engines: ray by ray, or in packets of 16.

mod api;
mod record;

use std::rc::Rc;

pub(super) use api::Library;
use api::{Quality, Scene};
use record::{PACKET, Ray, Ray16, RayHit, RayHit16, Valid};

use super::engine::{Engine, Job};
use super::rays::{Query, RayF32, RaySet};
use crate::meshes::TriangleMesh;

/// Rays beside each other are packed by tiles of 4 x 4 pixels.
const TILE: u32 = 4;

/// How Embree is built and asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Setting {
    /// What its device is limited to; the widest there is without.
    isa: Option<&'static str>,
    quality: Quality,
    is_packet: bool,
}

impl Setting {
    /// The setting of this name, if it is one of Embree's.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let medium = Quality { is_high: false, is_robust: false };
        let avx2 = Some("avx2");
        let single = |isa, quality| Some(Self { isa, quality, is_packet: false });
        match name {
            "embree4-default" => single(None, medium),
            "embree4-avx2" | "embree3" => single(avx2, medium),
            "embree4-high" => single(avx2, Quality { is_high: true, ..medium }),
            "embree4-robust" => single(avx2, Quality { is_robust: true, ..medium }),
            // Only the widest instructions have packets of 16 of their own.
            "embree4-packet16" => Some(Self { isa: None, quality: medium, is_packet: true }),
            _ => None,
        }
    }

    /// A scene of the mesh, on a device of so many threads, and what builds it.
    ///
    /// # Errors
    /// What Embree refuses.
    pub(crate) fn prepare(
        self,
        library: &Rc<Library>,
        threads: usize,
        mesh: &TriangleMesh,
    ) -> Result<Job, String> {
        let isa = self.isa.map(|isa| format!(",isa={isa}")).unwrap_or_default();
        let configuration = format!("threads={threads}{isa}");
        let (vertices, faces) = (&mesh.vertices, &mesh.faces);
        let scene = Scene::prepare(library, &configuration, self.quality, vertices, faces)?;
        Ok(Box::new(move || {
            scene.commit()?;
            Ok(Box::new(Embree {
                scene,
                is_packet: self.is_packet,
                is_coherent: false,
                order: Vec::new(),
                records: Records::Any(Vec::new()),
            }))
        }))
    }
}

/// The rays in the records that their query works on.
enum Records {
    Closest(Vec<RayHit>),
    Any(Vec<Ray>),
    Closest16(Vec<(Valid, RayHit16)>),
    Any16(Vec<(Valid, Ray16)>),
}

/// An Embree scene with the rays to send through it.
pub(crate) struct Embree {
    scene: Scene,
    is_packet: bool,
    is_coherent: bool,
    /// The set's number of each ray, in the order they are traced in.
    order: Vec<u32>,
    records: Records,
}

impl Engine for Embree {
    fn load(&mut self, set: &RaySet) {
        self.is_coherent = set.pixels.is_some();
        self.order =
            if self.is_packet { set.tiled(TILE) } else { (0..set.rays.len() as u32).collect() };
        let rays = self.order.iter().map(|&ray| &set.rays[ray as usize]);
        let single = |ray| single(ray, set.far);
        let packets = self.order.chunks(PACKET).map(|chunk| packet(chunk, set));
        self.records = match (set.query, self.is_packet) {
            (Query::Closest, false) => {
                Records::Closest(rays.map(|ray| RayHit::new(single(ray))).collect())
            }
            (Query::Any, false) => Records::Any(rays.map(single).collect()),
            (Query::Closest, true) => {
                let hits = packets.map(|(valid, rays)| (valid, RayHit16::new(&rays)));
                Records::Closest16(hits.collect())
            }
            (Query::Any, true) => Records::Any16(packets.collect()),
        };
    }

    fn trace(&mut self) {
        match &mut self.records {
            Records::Closest(rays) => self.scene.intersect1(rays),
            Records::Any(rays) => self.scene.occluded1(rays),
            Records::Closest16(packets) => self.scene.intersect16(packets, self.is_coherent),
            Records::Any16(packets) => self.scene.occluded16(packets, self.is_coherent),
        }
    }

    fn answers(&self) -> Vec<Option<f64>> {
        // A ray that is occluded ends before it starts.
        let occluded = |far: f32| (far < 0.0).then_some(0.0);
        let (of, lane) = (|place: usize| place / PACKET, |place: usize| place % PACKET);
        let mut answers = vec![None; self.order.len()];
        for (place, &ray) in self.order.iter().enumerate() {
            answers[ray as usize] = match &self.records {
                Records::Closest(rays) => rays[place].t().map(f64::from),
                Records::Any(rays) => occluded(rays[place].far),
                Records::Closest16(packets) => packets[of(place)].1.t(lane(place)).map(f64::from),
                Records::Any16(packets) => occluded(packets[of(place)].1.far[lane(place)]),
            };
        }
        answers
    }

    fn bytes(&self) -> Option<usize> {
        Some(self.scene.bytes())
    }
}

fn single(ray: &RayF32, far: f32) -> Ray {
    Ray {
        origin: ray.origin,
        near: 0.0,
        direction: ray.direction,
        time: 0.0,
        far,
        mask: u32::MAX,
        id: 0,
        flags: 0,
    }
}

/// A packet of these rays of a set, the rest of its lanes idle.
fn packet(chunk: &[u32], set: &RaySet) -> (Valid, Ray16) {
    let mut valid = Valid([0; PACKET]);
    let mut packet = Ray16 {
        origin: [[0.0; PACKET]; 3],
        near: [0.0; PACKET],
        direction: [[1.0; PACKET]; 3],
        time: [0.0; PACKET],
        far: [set.far; PACKET],
        mask: [u32::MAX; PACKET],
        id: [0; PACKET],
        flags: [0; PACKET],
    };
    for (lane, &ray) in chunk.iter().enumerate() {
        valid.0[lane] = -1;
        let ray = &set.rays[ray as usize];
        for axis in 0..3 {
            packet.origin[axis][lane] = ray.origin[axis];
            packet.direction[axis][lane] = ray.direction[axis];
        }
    }
    (valid, packet)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peers;

    /// Embree 3 takes the reciprocal of a determinant by an estimate.
    const ROUNDED: f64 = 1e-6;

    #[test]
    fn every_name_has_its_setting() {
        for name in super::super::engine::NAMES {
            assert_eq!(Setting::named(name).is_some(), name.starts_with("embree"), "{name}");
        }
    }

    /// Where Embree is installed, it hits and misses a triangle as it should.
    #[test]
    fn a_triangle_is_hit_in_every_way() {
        let mesh = TriangleMesh {
            vertices: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            faces: vec![[0, 1, 2]],
        };
        let ray = |x| RayF32 { origin: [x, 0.25, 2.0], direction: [0.0, 0.0, -1.0] };
        let rays = (0..20).map(|i| ray(if i % 3 == 0 { 0.25 } else { 5.0 })).collect();
        let (far, pixels) = (f32::INFINITY, None);
        let mut set = RaySet { name: "test".into(), query: Query::Closest, rays, far, pixels };
        let installed = [("embree3", peers::embree3()), ("embree4", peers::embree4())];
        for (library, path) in installed {
            let Some(path) = path else { continue };
            let opened = Library::open(&path).unwrap();
            let names = super::super::engine::NAMES.into_iter();
            for name in names.filter(|name| name.starts_with(library)) {
                let job = Setting::named(name).unwrap().prepare(&opened, 1, &mesh).unwrap();
                let mut engine = job().unwrap();
                assert!(engine.bytes().unwrap() > 0, "{name}");
                for (query, hit) in [(Query::Closest, 2.0), (Query::Any, 0.0)] {
                    set.query = query;
                    engine.load(&set);
                    engine.trace();
                    for (i, answer) in engine.answers().into_iter().enumerate() {
                        let found = answer.map(|t| (t - hit).abs() < ROUNDED);
                        assert_eq!(found, (i % 3 == 0).then_some(true), "{name} {query:?} {i}");
                    }
                }
            }
        }
    }
}
