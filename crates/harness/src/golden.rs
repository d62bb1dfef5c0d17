//! `Golden`: an accepted picture as a PNG file, with a note of the scene it
//! was accepted for.

mod layout;
#[cfg(test)]
mod tests;

use png::Filter;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::digest;
use crate::encode::EncodedImage;
use crate::picture_file::png::{Decoded, decode};
use layout::Layout;

/// The keyword of the PNG text chunk that holds the provenance.
pub(crate) const KEYWORD: &str = "goldray";

/// Which scene a golden was accepted for: content hashes that survive renames
/// and squashed histories, and that no comment or space in the fixture changes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Provenance {
    /// The version of this note.
    pub schema: u32,
    /// Hash of the parsed scene: everything in it but its `check`.
    pub scene: String,
    /// Hash of the files that the scene names, with their names.
    pub assets: String,
}

impl Provenance {
    /// The version of the notes that are written. Version 1 had no digest of
    /// the picture.
    pub const SCHEMA: u32 = 2;

    /// Whether a newer goldray wrote this note. What it says of the scene is
    /// then not known, and both hashes are empty.
    pub fn is_later(&self) -> bool {
        self.schema > Self::SCHEMA
    }
}

/// The text of the chunk.
#[derive(Serialize, Deserialize)]
struct Note {
    #[serde(flatten)]
    provenance: Provenance,
    /// The digest of the picture that was accepted, as in `golden/digests.txt`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    picture: Option<String>,
}

impl Note {
    /// Another program may have damaged it; a note without what its version
    /// promises is none.
    fn read(text: &str) -> Option<Self> {
        /// All that is known of the notes of every version.
        #[derive(Deserialize)]
        struct Version {
            schema: u32,
        }
        let Version { schema } = serde_json::from_str(text).ok()?;
        let later = Provenance { schema, scene: String::new(), assets: String::new() };
        if later.is_later() {
            return Some(Self { provenance: later, picture: None });
        }
        let note: Self = serde_json::from_str(text).ok()?;
        (note.picture.is_some() || note.provenance.schema < Provenance::SCHEMA).then_some(note)
    }

    fn write(picture: &EncodedImage, provenance: &Provenance) -> Result<String, String> {
        let note =
            Self { provenance: provenance.clone(), picture: Some(digest::of_encoded(picture)) };
        serde_json::to_string(&note).map_err(|error| error.to_string())
    }
}

/// An accepted picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Golden {
    /// The picture.
    pub picture: EncodedImage,
    /// Its note; `None` where the file has none, as after another program has
    /// saved it.
    pub provenance: Option<Provenance>,
    /// The digest of the picture that was accepted; `None` without a note and
    /// in notes of version 1 and of later versions.
    pub accepted: Option<String>,
    /// The size of the file, in bytes.
    pub file_bytes: usize,
}

impl Golden {
    /// Whether a newer goldray accepted it, so that it is not for this one to
    /// replace.
    pub fn is_later(&self) -> bool {
        self.provenance.as_ref().is_some_and(Provenance::is_later)
    }

    /// Whether the picture is another than its note was written for.
    pub fn is_tampered(&self) -> bool {
        self.accepted.as_ref().is_some_and(|digest| *digest != digest::of_encoded(&self.picture))
    }
}

/// The PNG file of a picture, with a note where it is a golden. It is made
/// fast; [`smallest_png`] makes it small.
///
/// # Errors
/// What the encoder says.
pub fn to_png(picture: &EncodedImage, provenance: Option<&Provenance>) -> Result<Vec<u8>, String> {
    let note = provenance.map(|provenance| Note::write(picture, provenance)).transpose()?;
    Layout::rgb(picture).to_png(picture.size(), Filter::Adaptive, note.as_deref())
}

/// The PNG file of a picture for a page: gray where it has no color, made fast.
///
/// # Errors
/// What the encoder says.
pub fn page_png(picture: &EncodedImage) -> Result<Vec<u8>, String> {
    let layout = Layout::gray(picture).unwrap_or_else(|| Layout::rgb(picture));
    layout.to_png(picture.size(), Filter::Adaptive, None)
}

/// The PNG file of a golden in few bytes: of all layouts that hold the picture
/// and all filters, the pair that compresses best, the first of equals. The
/// same bytes for the same picture and note.
///
/// # Errors
/// What the encoder says.
pub fn smallest_png(picture: &EncodedImage, provenance: &Provenance) -> Result<Vec<u8>, String> {
    const FILTERS: [Filter; 7] = [
        Filter::NoFilter,
        Filter::Sub,
        Filter::Up,
        Filter::Avg,
        Filter::Paeth,
        Filter::Adaptive,
        Filter::MinEntropy,
    ];
    let note = Note::write(picture, provenance)?;
    let layouts = Layout::all(picture);
    let ways = layouts.iter().flat_map(|layout| FILTERS.map(|filter| (layout, filter)));
    let ways: Vec<_> = ways.collect();
    let files = ways.into_par_iter().enumerate().map(|(place, (layout, filter))| {
        let png = layout.to_png(picture.size(), filter, Some(&note))?;
        Ok((png.len(), place, png))
    });
    match files.try_reduce_with(|a, b| Ok(a.min(b))) {
        Some(smallest) => smallest.map(|(_, _, png)| png),
        None => Err("there is no way to write the picture".to_owned()),
    }
}

/// Reads a PNG file as an 8-bit RGB picture. Gray and palette pictures are
/// taken as the colors they stand for.
///
/// # Errors
/// Why it is not such a picture: no PNG, cut short or damaged, 16 bits deep,
/// or partly transparent, none of which can be compared without losing
/// something.
pub fn from_png(bytes: &[u8]) -> Result<Golden, String> {
    let Decoded { size, width, rgb, texts } = decode(bytes)?;
    if width != 1 {
        return Err("has 16 bits a channel: expected 8".to_owned());
    }
    let picture = EncodedImage::from_bytes(size, rgb).ok_or("has a wrong count of pixels")?;
    let note = texts.iter().find(|(keyword, _)| keyword == KEYWORD);
    let note = note.and_then(|(_, text)| Note::read(text));
    let (provenance, accepted) = note.map(|note| (note.provenance, note.picture)).unzip();
    Ok(Golden { picture, provenance, accepted: accepted.flatten(), file_bytes: bytes.len() })
}
