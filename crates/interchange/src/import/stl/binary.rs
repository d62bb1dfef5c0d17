//! STL as bytes: a header of 80, a count, and 50 for each facet.

use tracer::glam::DVec3;

use super::facets::Facets;
use crate::import::Unreadable;
use crate::import::mesh::stage::Stage;
use crate::import::mesh::unreadable_at_all;

const HEADER: usize = 80;
const START: usize = HEADER + 4;
const FACET: usize = 50;

/// How many facets the file says it has; `None` where it is too short to say.
fn declared(bytes: &[u8]) -> Option<u32> {
    bytes.get(HEADER..START)?.try_into().ok().map(u32::from_le_bytes)
}

/// The size that so many facets take.
fn size(count: u32) -> u64 {
    START as u64 + FACET as u64 * u64::from(count)
}

/// Whether the file has the very size that its count says.
pub(super) fn has_its_size(bytes: &[u8]) -> bool {
    declared(bytes).is_some_and(|count| size(count) == bytes.len() as u64)
}

/// What it says of its size and what that is.
pub(super) fn sizes(bytes: &[u8]) -> Option<String> {
    let count = declared(bytes)?;
    Some(format!("its {count} facets would take {} bytes, it has {}", size(count), bytes.len()))
}

/// Reads the facets.
///
/// # Errors
/// A file that is shorter than it says, and numbers that are none.
pub(super) fn read(bytes: &[u8], facets: &mut Facets, stage: &mut Stage) -> Result<(), Unreadable> {
    let Some(count) = declared(bytes) else {
        let message = format!(
            "expected an STL file, text that starts with \"solid\" or {START} bytes or more, \
             found {} bytes",
            bytes.len()
        );
        return Err(unreadable_at_all(message));
    };
    let needed = size(count);
    if (bytes.len() as u64) < needed {
        let message = format!("expected {needed} bytes for {count} facets, found {}", bytes.len());
        let help = "the file is cut short, or is no STL file at all".to_owned();
        return Err(Unreadable { help: Some(help), ..unreadable_at_all(message) });
    }
    let surplus = bytes.len() as u64 - needed;
    if surplus > 0 {
        let what = format!("{surplus} bytes after the last facet are left out");
        stage.lost.add(None, "end of the file", what);
    }
    let mut attributes = 0;
    let records = bytes[START..].as_chunks::<FACET>().0.iter();
    for (number, record) in records.take(count as usize).enumerate() {
        let float = |i: usize| {
            let at = 4 * i;
            f64::from(f32::from_le_bytes([
                record[at],
                record[at + 1],
                record[at + 2],
                record[at + 3],
            ]))
        };
        let point = |i: usize| DVec3::new(float(3 * i), float(3 * i + 1), float(3 * i + 2));
        facets
            .add(point(0), [point(1), point(2), point(3)])
            .map_err(|why| unreadable_at_all(format!("facet {number}: {why}")))?;
        attributes += usize::from(record[FACET - 2..] != [0, 0]);
    }
    if attributes > 0 {
        let what = format!("{attributes} of them, which are colors to some programs, are left out");
        stage.lost.add(None, "attributes of facets", what);
    }
    if bytes[..HEADER].windows(6).any(|word| word == b"COLOR=") {
        stage.lost.add(None, "COLOR in the header", "it is left out");
    }
    Ok(())
}
