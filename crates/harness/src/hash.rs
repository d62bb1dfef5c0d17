//! `content_hash`: what bytes are known by in notes, plans and records.

/// Hexadecimal letters of a hash: 128 bits tell any two files apart.
const LETTERS: usize = 32;

/// The first 128 bits of BLAKE3 in hexadecimal.
pub(crate) fn content_hash(bytes: impl AsRef<[u8]>) -> String {
    short(&blake3::hash(bytes.as_ref()))
}

/// The first 128 bits in hexadecimal.
pub(crate) fn short(hash: &blake3::Hash) -> String {
    let mut hex = hash.to_hex().to_string();
    hex.truncate(LETTERS);
    hex
}
