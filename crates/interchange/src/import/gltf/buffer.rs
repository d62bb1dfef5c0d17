//! `Buffers`: the bytes that a glTF file names, each read when first asked for.
//!
//! A buffer is the GLB file's own, text in the document, or a file in the
//! document's folder or below it. No address leads anywhere else.

use base64::Engine as _;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use scene::{Assets, check_path};

use super::document::{Buffer, Document, Image};

/// The most bytes of all buffers together.
const MOST_BYTES: u64 = 2 * scene::MAX_ASSET_BYTES;

/// Padding is often left out.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The buffers of a document.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    own: Option<&'a [u8]>,
    assets: &'a dyn Assets,
    read: Vec<Option<Vec<u8>>>,
    total: u64,
}

impl<'a> Buffers<'a> {
    /// Nothing is read yet.
    pub(super) fn new(
        document: &'a Document,
        own: Option<&'a [u8]>,
        assets: &'a dyn Assets,
    ) -> Self {
        let read = document.buffers.iter().map(|_| None).collect();
        Self { document, own, assets, read, total: 0 }
    }

    /// The bytes of a view, and the stride that it says.
    ///
    /// # Errors
    /// What is wrong with it, or with its buffer.
    pub(super) fn view(&mut self, index: usize) -> Result<(&[u8], Option<u64>), String> {
        let document = self.document;
        let views = &document.buffer_views;
        let view = views.get(index).ok_or_else(|| none("bufferViews", views.len(), index))?;
        let bytes = self.buffer(view.buffer)?;
        let end = view.byte_offset.checked_add(view.byte_length);
        let range = end.and_then(|end| {
            Some(usize::try_from(view.byte_offset).ok()?..usize::try_from(end).ok()?)
        });
        let found = range.and_then(|range| bytes.get(range)).ok_or_else(|| {
            format!(
                "bufferViews[{index}]: expected {} bytes from byte {} on in buffers[{}], which has {}",
                view.byte_length,
                view.byte_offset,
                view.buffer,
                bytes.len()
            )
        })?;
        Ok((found, view.byte_stride))
    }

    fn buffer(&mut self, index: usize) -> Result<&[u8], String> {
        let buffers = &self.document.buffers;
        let buffer = buffers.get(index).ok_or_else(|| none("buffers", buffers.len(), index))?;
        if self.read[index].is_none() {
            let bytes =
                self.bytes(index, buffer).map_err(|why| format!("buffers[{index}]: {why}"))?;
            self.read[index] = Some(bytes);
        }
        Ok(self.read[index].as_deref().unwrap_or_default())
    }

    fn bytes(&mut self, index: usize, buffer: &Buffer) -> Result<Vec<u8>, String> {
        let mut bytes = match &buffer.uri {
            None => {
                let own = self.own.filter(|_| index == 0);
                own.ok_or("expected a `uri`, as there is no binary chunk for it")?.to_vec()
            }
            Some(uri) => match scheme(uri) {
                Some(data) => in_document(data)?,
                None => self.file(uri)?,
            },
        };
        let length = usize::try_from(buffer.byte_length).unwrap_or(usize::MAX);
        if bytes.len() < length {
            return Err(format!("expected {length} bytes, found {}", bytes.len()));
        }
        bytes.truncate(length);
        self.total += bytes.len() as u64;
        if self.total > MOST_BYTES {
            return Err(format!("expected at most {MOST_BYTES} bytes of all buffers together"));
        }
        Ok(bytes)
    }

    /// The bytes of a picture, and the file's name where it is one.
    ///
    /// # Errors
    /// What is wrong with its address or view, as the end of a sentence.
    pub(super) fn picture(&mut self, image: &Image) -> Result<(Option<String>, Vec<u8>), String> {
        let within = |why: String| format!("is not there: {why}");
        match (&image.uri, image.buffer_view) {
            (Some(uri), None) => {
                if let Some(data) = scheme(uri) {
                    return Ok((None, in_document(data).map_err(within)?));
                }
                let bytes = self.file(uri).map_err(within)?;
                let name = decoded(uri).map(|path| without_dot(&path).to_owned());
                Ok((name, bytes))
            }
            (None, Some(view)) => Ok((None, self.view(view).map_err(within)?.0.to_vec())),
            _ => Err(within("expected a `uri` or a `bufferView`, one of them".to_owned())),
        }
    }

    fn file(&self, uri: &str) -> Result<Vec<u8>, String> {
        let path = decoded(uri).filter(|path| check_path(without_dot(path)).is_ok());
        let path = path.ok_or_else(|| {
            let short: String = uri.chars().take(80).collect();
            format!(
                "expected a file in the document's own folder or below it, relative, with `/` \
                 between its parts and no `..`, found \"{}\"",
                short.escape_debug()
            )
        })?;
        let path = without_dot(&path);
        self.assets.read(path).map_err(|why| format!("the file \"{path}\" {why}"))
    }
}

/// What a `data:` address holds behind that.
fn scheme(uri: &str) -> Option<&str> {
    let (scheme, data) = uri.split_at_checked(5)?;
    scheme.eq_ignore_ascii_case("data:").then_some(data)
}

/// The bytes that a `data:` address holds behind its scheme.
fn in_document(data: &str) -> Result<Vec<u8>, String> {
    let expected = "expected `data:` with a type, `;base64,` and bytes";
    let (kind, text) = data.split_once(',').ok_or(expected)?;
    if !kind.ends_with(";base64") {
        return Err(expected.to_owned());
    }
    BASE64.decode(text).map_err(|error| format!("expected bytes in base 64, found: {error}"))
}

/// An address with its `%41` put back; `None` where that is no text.
fn decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        if *first == b'%' {
            let (digits, after) = rest.split_first_chunk::<2>()?;
            let digit = |d: u8| char::from(d).to_digit(16);
            bytes.push((16 * digit(digits[0])? + digit(digits[1])?) as u8);
            rest = after;
        } else {
            bytes.push(*first);
        }
    }
    String::from_utf8(bytes).ok()
}

fn without_dot(path: &str) -> &str {
    path.strip_prefix("./").unwrap_or(path)
}

/// An index that leads nowhere.
pub(super) fn none(list: &str, count: usize, found: usize) -> String {
    format!("expected one of the {count} {list}, found number {found}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_put_back_before_they_are_judged() {
        assert_eq!(decoded("a%20b%2ebin").as_deref(), Some("a b.bin"));
        assert_eq!(decoded("%2e%2E/a").as_deref(), Some("../a"));
        for bad in ["%", "%2", "%zz", "%ff", "a%+1"] {
            assert_eq!(decoded(bad), None, "{bad}");
        }
    }

    #[test]
    fn bytes_in_the_document() {
        assert_eq!(in_document("application/octet-stream;base64,AQI="), Ok(vec![1, 2]));
        assert_eq!(in_document(";base64,AQI"), Ok(vec![1, 2]));
        assert!(in_document("text/plain,abc").is_err());
        assert!(in_document(";base64,A*").is_err());
        assert!(in_document("").is_err());
    }
}
