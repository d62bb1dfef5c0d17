//! The records that Embree reads rays from, and writes hits to.

use std::ffi::c_int;

/// "No hit": the geometry's number before, and after a miss.
pub(super) const NO_GEOMETRY: u32 = u32::MAX;
/// Rays in a packet.
pub(super) const PACKET: usize = 16;

/// `RTCRay`.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(16))]
pub(super) struct Ray {
    pub(super) origin: [f32; 3],
    pub(super) near: f32,
    pub(super) direction: [f32; 3],
    pub(super) time: f32,
    pub(super) far: f32,
    pub(super) mask: u32,
    pub(super) id: u32,
    pub(super) flags: u32,
}

/// `RTCRayHit`, with the field that version 4.3 added at its end: a record that
/// is longer than the library knows is none of its business.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(16))]
pub(super) struct RayHit {
    pub(super) ray: Ray,
    normal: [f32; 3],
    uv: [f32; 2],
    primitive: u32,
    geometry: u32,
    instance: [u32; 2],
}

/// `RTCRay16`.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct Ray16 {
    pub(super) origin: [[f32; PACKET]; 3],
    pub(super) near: [f32; PACKET],
    pub(super) direction: [[f32; PACKET]; 3],
    pub(super) time: [f32; PACKET],
    pub(super) far: [f32; PACKET],
    pub(super) mask: [u32; PACKET],
    pub(super) id: [u32; PACKET],
    pub(super) flags: [u32; PACKET],
}

/// `RTCRayHit16`, as long as [`RayHit`] is.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct RayHit16 {
    pub(super) ray: Ray16,
    normal: [[f32; PACKET]; 3],
    uv: [[f32; PACKET]; 2],
    primitive: [u32; PACKET],
    geometry: [u32; PACKET],
    instance: [[u32; PACKET]; 2],
}

/// Which lanes of a packet are rays: -1 for those, 0 for others.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct Valid(pub(super) [c_int; PACKET]);

impl RayHit {
    pub(super) fn new(ray: Ray) -> Self {
        let (normal, uv) = ([0.0; 3], [0.0; 2]);
        let none = NO_GEOMETRY;
        Self { ray, normal, uv, primitive: none, geometry: none, instance: [none; 2] }
    }

    /// Where it hit.
    pub(super) fn t(&self) -> Option<f32> {
        (self.geometry != NO_GEOMETRY).then_some(self.ray.far)
    }
}

impl RayHit16 {
    pub(super) fn new(ray: &Ray16) -> Self {
        let none = [NO_GEOMETRY; PACKET];
        Self {
            ray: *ray,
            normal: [[0.0; PACKET]; 3],
            uv: [[0.0; PACKET]; 2],
            primitive: none,
            geometry: none,
            instance: [none; 2],
        }
    }

    pub(super) fn t(&self, lane: usize) -> Option<f32> {
        (self.geometry[lane] != NO_GEOMETRY).then_some(self.ray.far[lane])
    }
}

#[cfg(test)]
mod tests {
    use std::mem::{align_of, offset_of, size_of};

    use super::*;

    /// What the C headers' structures come to on a 64-bit system.
    #[test]
    fn records_lie_as_the_headers_say() {
        assert_eq!((size_of::<Ray>(), align_of::<Ray>()), (48, 16));
        assert_eq!(offset_of!(Ray, far), 32);
        assert_eq!((offset_of!(RayHit, normal), offset_of!(RayHit, geometry)), (48, 72));
        assert_eq!((size_of::<RayHit>(), align_of::<RayHit>()), (96, 16));
        assert_eq!((size_of::<Ray16>(), align_of::<Ray16>()), (768, 64));
        assert_eq!((offset_of!(RayHit16, normal), offset_of!(RayHit16, geometry)), (768, 1152));
        assert_eq!((offset_of!(RayHit16, instance), align_of::<RayHit16>()), (1216, 64));
    }
}
