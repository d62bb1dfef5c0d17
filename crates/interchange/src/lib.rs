//! Scenes of other programs: foreign files read as goldray's scenes
//! ([`import`]), and goldray's scenes written in the languages of other
//! renderers ([`export`]).
//!
//! Both go through [`scene::format`], what is written in a scene file: an
//! importer makes a [`SceneFile`](scene::SceneFile), which is judged like any
//! other; a writer starts from one. Nothing is opened here: bytes are given by
//! [`scene::Assets`], and files are handed back in memory.
//!
//! What one side cannot say is a [`Feature`] or a [`Lost`](import::Lost), never
//! left out in silence.

pub mod export;
pub mod feature;
pub mod import;
pub mod polygon;

pub use feature::Feature;
pub use scene::visible;
