//! Each relation met, and each one broken.
