//! goldray's scene format: RON text to a valid [`tracer::Scene`], or every
//! problem of the text with its place.
//!
//! There are two steps from text to scene: what was written ([`SceneFile`])
//! and what is valid ([`tracer::Scene`]). [`load`] takes both and reports the
//! problems of both together.
//!
//! ```
//! use scene::{NoAssets, Unchecked, load};
//!
//! let text = r#"(
//!     version: 1,
//!     image: (64, 48),
//!     camera: LookAt(eye: (0, 0, 5), at: (0, 0, 0), fov_deg: 40),
//!     objects: [Sphere(center: (0, 0, 0), radius: 1)],
//!     lights: [Point(position: (3, 4, 5))],
//! )"#;
//! let loaded = load::<Unchecked>(text, &NoAssets, Default::default()).unwrap();
//! assert_eq!(tracer::render(&loaded.scene).size().width, 64);
//!
//! let wrong = text.replace("radius: 1", "radius: -1").replace("eye", "eie");
//! let problems = load::<Unchecked>(&wrong, &NoAssets, Default::default()).unwrap_err();
//! assert_eq!(problems.len(), 2, "a misspelled `eye`, a negative radius");
//! ```

mod assets;
mod compile;
mod diagnose;
pub mod format;
mod load;
mod mesh;
mod places;
mod read;
mod report;
mod texture;
mod visible;
mod write;

pub use assets::{Assets, MAX_ASSET_BYTES, MAX_SCENE_BYTES, NoAssets, check_path};
pub use diagnose::{Problem, Span, Step, line_column, nearest};
pub use format::{Encoding, SceneFile, Unchecked, VERSION};
pub use load::{Check, Loaded, load, parse, recompile, span_of};
pub use mesh::{MeshData, is_mesh, read as read_mesh};
pub use places::{Place, object_places};
pub use read::read;
pub use report::report;
pub use texture::{as_rgb, is_texture, without_alpha};
pub use visible::{is_invisible, visible};
pub use write::write;
