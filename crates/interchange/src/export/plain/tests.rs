//! Scenes made plain.
