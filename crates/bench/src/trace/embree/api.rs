//! Embree's C functions, declared by hand for versions 3 and 4, and found in a
//! shared library at run time.
//!
//! This is the one file that calls them. Source: the public headers
//! `rtcore_*.h` of Embree 3.13 and 4.4 (Intel Corporation, Apache-2.0).
#![allow(unsafe_code)]

use std::ffi::{CString, c_char, c_int, c_void};
use std::mem::ManuallyDrop;
use std::path::Path;
use std::ptr;
use std::rc::Rc;
use std::sync::atomic::{AtomicIsize, Ordering};

use super::record::{NO_GEOMETRY, Ray, Ray16, RayHit, RayHit16, Valid};

/// `RTC_GEOMETRY_TYPE_TRIANGLE`, `RTC_BUFFER_TYPE_INDEX` and `_VERTEX`.
const TRIANGLES: c_int = 0;
const INDICES: c_int = 0;
const VERTICES: c_int = 1;
/// `RTC_FORMAT_UINT3` and `RTC_FORMAT_FLOAT3`.
const UINT3: c_int = 0x5003;
const FLOAT3: c_int = 0x9003;
/// `RTC_SCENE_FLAG_ROBUST`; `RTC_BUILD_QUALITY_MEDIUM` and `_HIGH`.
const ROBUST: c_int = 1 << 2;
const MEDIUM: c_int = 1;
const HIGH: c_int = 2;
/// "Optimize for coherent rays" in either version.
const COHERENT_3: u32 = 1;
const COHERENT_4: u32 = 1 << 16;
/// `RTC_FEATURE_FLAG_ALL`.
const ALL_FEATURES: u32 = u32::MAX;
/// `RTC_DEVICE_PROPERTY_VERSION`: 40400 for 4.4.0.
const VERSION: c_int = 0;
const FLOAT3_BYTES: usize = 12;

type Handle = *mut c_void;

/// `RTCIntersectArguments` and `RTCOccludedArguments` of version 4, which have
/// the same fields.
#[repr(C)]
struct Arguments4 {
    flags: u32,
    features: u32,
    context: Handle,
    filter: Handle,
    function: Handle,
    min_width: f32,
}

/// `RTCIntersectContext` of version 3, with a word to spare for the build
/// option that has one more.
#[repr(C)]
struct Context3 {
    flags: u32,
    filter: Handle,
    instance: u32,
    min_width: f32,
}

type TraceOne = unsafe extern "C" fn(Handle, *mut c_void, *mut c_void);
type TracePacket = unsafe extern "C" fn(*const c_int, Handle, *mut c_void, *mut c_void);

/// The functions that are called, as the library has them.
struct Functions {
    new_device: unsafe extern "C" fn(*const c_char) -> Handle,
    release_device: unsafe extern "C" fn(Handle),
    device_property: unsafe extern "C" fn(Handle, c_int) -> isize,
    device_error: unsafe extern "C" fn(Handle) -> c_int,
    set_memory_monitor: unsafe extern "C" fn(Handle, MemoryMonitor, *mut c_void),
    new_geometry: unsafe extern "C" fn(Handle, c_int) -> Handle,
    new_buffer: unsafe extern "C" fn(Handle, c_int, u32, c_int, usize, usize) -> *mut c_void,
    commit_geometry: unsafe extern "C" fn(Handle),
    release_geometry: unsafe extern "C" fn(Handle),
    new_scene: unsafe extern "C" fn(Handle) -> Handle,
    attach: unsafe extern "C" fn(Handle, Handle) -> u32,
    set_flags: unsafe extern "C" fn(Handle, c_int),
    set_quality: unsafe extern "C" fn(Handle, c_int),
    commit_scene: unsafe extern "C" fn(Handle),
    release_scene: unsafe extern "C" fn(Handle),
    intersect1: TraceOne,
    occluded1: TraceOne,
    intersect16: TracePacket,
    occluded16: TracePacket,
}

type MemoryMonitor = unsafe extern "C" fn(*mut c_void, isize, bool) -> bool;

/// An Embree library, open until the process ends.
pub(crate) struct Library {
    functions: Functions,
    /// 3 or 4.
    generation: isize,
    /// Major, minor and patch.
    pub(crate) version: String,
    // Never closed: worker threads of its scheduler run its code until the
    // process ends.
    _opened: ManuallyDrop<libloading::Library>,
}

impl Library {
    /// Opens the shared library at `path`.
    ///
    /// # Errors
    /// A file that is no library, lacks one of the functions, or is another
    /// version than 3 or 4.
    pub(crate) fn open(path: &Path) -> Result<Rc<Self>, String> {
        let at = |why: &dyn std::fmt::Display| format!("{}: {why}", path.display());
        // SAFETY: loading runs the library's initializers. The path is that of
        // the Embree library out of the wheel or package that the user
        // installed for this bench, whose initializers set up its own state.
        let library = unsafe { libloading::Library::new(path) }.map_err(|why| at(&why))?;
        macro_rules! function {
            ($name:literal) => {{
                // SAFETY: the type is that of the field it is put into, which
                // is the header's declaration of this name, the same in both
                // versions; `open` refuses others below. The library
                // is closed only where `open` fails, and the pointer with it.
                *unsafe { library.get(concat!($name, "\0").as_bytes()) }.map_err(|why| at(&why))?
            }};
        }
        let functions = Functions {
            new_device: function!("rtcNewDevice"),
            release_device: function!("rtcReleaseDevice"),
            device_property: function!("rtcGetDeviceProperty"),
            device_error: function!("rtcGetDeviceError"),
            set_memory_monitor: function!("rtcSetDeviceMemoryMonitorFunction"),
            new_geometry: function!("rtcNewGeometry"),
            new_buffer: function!("rtcSetNewGeometryBuffer"),
            commit_geometry: function!("rtcCommitGeometry"),
            release_geometry: function!("rtcReleaseGeometry"),
            new_scene: function!("rtcNewScene"),
            attach: function!("rtcAttachGeometry"),
            set_flags: function!("rtcSetSceneFlags"),
            set_quality: function!("rtcSetSceneBuildQuality"),
            commit_scene: function!("rtcCommitScene"),
            release_scene: function!("rtcReleaseScene"),
            intersect1: function!("rtcIntersect1"),
            occluded1: function!("rtcOccluded1"),
            intersect16: function!("rtcIntersect16"),
            occluded16: function!("rtcOccluded16"),
        };
        // SAFETY: a null configuration is the default one, and the device is
        // released before anything else is done with it.
        let version = unsafe {
            let device = (functions.new_device)(ptr::null());
            let version = (functions.device_property)(device, VERSION);
            (functions.release_device)(device);
            version
        };
        let [generation, minor, patch] = [version / 10_000, version / 100 % 100, version % 100];
        if ![3, 4].contains(&generation) {
            return Err(at(&format!("expected Embree 3 or 4, found {version}")));
        }
        let version = format!("{generation}.{minor}.{patch}");
        Ok(Rc::new(Self { functions, generation, version, _opened: ManuallyDrop::new(library) }))
    }
}

/// A triangle mesh in a scene of its own, on a device of its own.
pub(crate) struct Scene {
    library: Rc<Library>,
    device: Handle,
    handle: Handle,
    /// The bytes that the device holds; its callback adds to them.
    bytes: Box<AtomicIsize>,
}

/// How a scene is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Quality {
    pub(crate) is_high: bool,
    pub(crate) is_robust: bool,
}

unsafe extern "C" fn count_bytes(total: *mut c_void, bytes: isize, _: bool) -> bool {
    // SAFETY: `total` is the counter that was registered with this function,
    // boxed in the `Scene` that releases the device before it.
    let total = unsafe { &*total.cast::<AtomicIsize>() };
    total.fetch_add(bytes, Ordering::Relaxed);
    true
}

impl Scene {
    /// A scene of these triangles that is ready to commit, on a device made by
    /// this configuration, as `threads=1,isa=avx2`.
    ///
    /// # Errors
    /// What Embree's error number is, where it refuses.
    pub(crate) fn prepare(
        library: &Rc<Library>,
        configuration: &str,
        quality: Quality,
        vertices: &[[f32; 3]],
        faces: &[[u32; 3]],
    ) -> Result<Self, String> {
        let f = &library.functions;
        let text =
            CString::new(configuration).map_err(|why| format!("{configuration:?}: {why}"))?;
        let bytes = Box::new(AtomicIsize::new(0));
        // SAFETY: `text` is a C string that lives until the call returns.
        let device = unsafe { (f.new_device)(text.as_ptr()) };
        if device.is_null() {
            return Err(format!("Embree makes no device from {configuration:?}"));
        }
        // SAFETY: handles come from this library and are used before they are
        // released: the geometry once the scene holds it, the device and the
        // scene in `drop`. A buffer of `n` items of 12 bytes is written with as
        // many bytes, from a slice of `n` arrays of three 4-byte numbers; the
        // library pads it by itself. Null buffers are not written. The counter
        // outlives the device, being dropped after it.
        unsafe {
            let counter = ptr::from_ref::<AtomicIsize>(&bytes).cast_mut().cast();
            (f.set_memory_monitor)(device, count_bytes, counter);
            let geometry = (f.new_geometry)(device, TRIANGLES);
            let corners =
                (f.new_buffer)(geometry, VERTICES, 0, FLOAT3, FLOAT3_BYTES, vertices.len());
            let triangles = (f.new_buffer)(geometry, INDICES, 0, UINT3, FLOAT3_BYTES, faces.len());
            if !corners.is_null() && !triangles.is_null() {
                ptr::copy_nonoverlapping(vertices.as_ptr(), corners.cast(), vertices.len());
                ptr::copy_nonoverlapping(faces.as_ptr(), triangles.cast(), faces.len());
            }
            (f.commit_geometry)(geometry);
            let scene = (f.new_scene)(device);
            (f.set_flags)(scene, if quality.is_robust { ROBUST } else { 0 });
            (f.set_quality)(scene, if quality.is_high { HIGH } else { MEDIUM });
            (f.attach)(scene, geometry);
            (f.release_geometry)(geometry);
            let made = Self { library: library.clone(), device, handle: scene, bytes };
            made.refused().map(|()| made)
        }
    }

    /// Builds the hierarchy, without which nothing may be sent.
    ///
    /// # Errors
    /// What Embree's error number is, where it refuses.
    pub(crate) fn commit(&self) -> Result<(), String> {
        // SAFETY: the scene is live, and nothing else uses it meanwhile: it is
        // not `Sync`.
        unsafe { (self.library.functions.commit_scene)(self.handle) };
        self.refused()
    }

    fn refused(&self) -> Result<(), String> {
        // SAFETY: the device is live.
        match unsafe { (self.library.functions.device_error)(self.device) } {
            0 => Ok(()),
            error => Err(format!("Embree refuses the mesh: its error {error}")),
        }
    }

    /// The bytes that the device and all on it hold.
    pub(crate) fn bytes(&self) -> usize {
        self.bytes.load(Ordering::Relaxed).max(0) as usize
    }

    /// Sends single rays, each for its closest hit.
    pub(super) fn intersect1(&self, rays: &mut [RayHit]) {
        self.each1(self.library.functions.intersect1, rays);
    }

    /// Sends single rays for any hit, which sets their `far` to minus infinity.
    pub(super) fn occluded1(&self, rays: &mut [Ray]) {
        self.each1(self.library.functions.occluded1, rays);
    }

    fn each1<R>(&self, function: TraceOne, rays: &mut [R]) {
        let mut context = context3(0);
        let context = ptr::from_mut(&mut context).cast::<c_void>();
        for ray in rays {
            let ray = ptr::from_mut(ray).cast::<c_void>();
            // SAFETY: the scene is committed by `Embree`, which alone
            // sends rays. `ray` is a record of the kind that
            // the function wants, by the two callers above, aligned and
            // exclusively ours. Version 3 takes a context before it, version 4
            // arguments after it, which may be null.
            unsafe {
                match self.library.generation {
                    3 => function(self.handle, context, ray),
                    _ => function(self.handle, ray, ptr::null_mut()),
                }
            }
        }
    }

    /// Sends packets for their closest hits.
    pub(super) fn intersect16(&self, packets: &mut [(Valid, RayHit16)], is_coherent: bool) {
        self.each16(self.library.functions.intersect16, packets, is_coherent);
    }

    /// Sends packets for any hits.
    pub(super) fn occluded16(&self, packets: &mut [(Valid, Ray16)], is_coherent: bool) {
        self.each16(self.library.functions.occluded16, packets, is_coherent);
    }

    fn each16<R>(&self, function: TracePacket, packets: &mut [(Valid, R)], is_coherent: bool) {
        let flag = |coherent| if is_coherent { coherent } else { 0 };
        let (mut context, null) = (context3(flag(COHERENT_3)), ptr::null_mut());
        let mut arguments = Arguments4 {
            flags: flag(COHERENT_4),
            features: ALL_FEATURES,
            context: null,
            filter: null,
            function: null,
            min_width: 0.0,
        };
        let context = ptr::from_mut(&mut context).cast::<c_void>();
        let arguments = ptr::from_mut(&mut arguments).cast::<c_void>();
        for (valid, packet) in packets {
            let packet = ptr::from_mut(packet).cast::<c_void>();
            let valid = valid.0.as_ptr();
            // SAFETY: as in `each1`; the mask has a number for each lane, and
            // mask and packet are aligned to 64 bytes as the header asks.
            unsafe {
                match self.library.generation {
                    3 => function(valid, self.handle, context, packet),
                    _ => function(valid, self.handle, packet, arguments),
                }
            }
        }
    }
}

fn context3(flags: u32) -> Context3 {
    Context3 { flags, filter: ptr::null_mut(), instance: NO_GEOMETRY, min_width: 0.0 }
}

impl Drop for Scene {
    fn drop(&mut self) {
        // SAFETY: both are ours, live, and not used again; the scene goes
        // before the device that it is on.
        unsafe {
            (self.library.functions.release_scene)(self.handle);
            (self.library.functions.release_device)(self.device);
        }
    }
}
