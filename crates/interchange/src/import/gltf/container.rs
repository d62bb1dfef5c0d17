//! The two forms of a glTF file: JSON alone, and GLB, which has the JSON and a
//! buffer in one.
//!
//! Source: "glTF 2.0 Specification", The Khronos Group, 2021, section "GLB File
//! Format".

use super::document::Document;
use crate::import::Unreadable;
use crate::import::mesh::unreadable_at_all;

const MAGIC: &[u8] = b"glTF";

/// The document, and the buffer that comes with it.
///
/// # Errors
/// What is neither form.
pub(super) fn open(bytes: &[u8]) -> Result<(Document, Option<&[u8]>), Unreadable> {
    let (json, buffer) = if bytes.starts_with(MAGIC) { chunks(bytes)? } else { (bytes, None) };
    let is_glb = json.len() < bytes.len();
    let document = serde_json::from_slice(json).map_err(|error| {
        let full = error.to_string();
        let what = full.split(" at line ").next().unwrap_or(&full);
        let place = (error.line(), error.column().max(1));
        let inside = if is_glb { " in the JSON of the GLB file" } else { "" };
        Unreadable {
            place: Some(place).filter(|_| !is_glb),
            message: format!("expected a glTF document{inside}, found: {what}"),
            help: None,
        }
    })?;
    Ok((document, buffer))
}

/// The JSON and the buffer of a GLB file.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Unreadable> {
    let word = |at: usize| -> Option<u32> {
        bytes.get(at..at + 4)?.try_into().ok().map(u32::from_le_bytes)
    };
    let cut = |what: &str| {
        let message = format!("expected {what}, found the end of the GLB file");
        let help = Some("the file is cut short".to_owned());
        Unreadable { help, ..unreadable_at_all(message) }
    };
    let (version, length) = word(4).zip(word(8)).ok_or_else(|| cut("a header of 12 bytes"))?;
    if version != 2 {
        let message = format!("expected version 2 of GLB, found {version}");
        return Err(unreadable_at_all(message));
    }
    if u64::from(length) != bytes.len() as u64 {
        let message =
            format!("expected a GLB file of {length} bytes, as it says, found {}", bytes.len());
        return Err(unreadable_at_all(message));
    }
    let chunk = |at: usize| -> Option<(&[u8], &[u8], usize)> {
        let end = at.checked_add(8)?.checked_add(word(at)? as usize)?;
        Some((bytes.get(at + 4..at + 8)?, bytes.get(at + 8..end)?, end))
    };
    let (kind, json, mut at) = chunk(12).ok_or_else(|| cut("a first chunk"))?;
    if kind != b"JSON" {
        return Err(unreadable_at_all("expected the first chunk of a GLB file to be JSON"));
    }
    while at < bytes.len() {
        let (kind, data, end) = chunk(at).ok_or_else(|| cut("another chunk"))?;
        if kind == b"BIN\0" {
            return Ok((json, Some(data)));
        }
        // Chunks of other kinds are an extension's, which the document names.
        at = end;
    }
    Ok((json, None))
}
