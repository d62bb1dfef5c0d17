//! Kernels that are shown beside what renders, and held to nothing.

pub mod textbook_f32;
