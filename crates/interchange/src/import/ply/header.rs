//! `Header`: what a PLY file declares.

use crate::import::Unreadable;
use crate::import::mesh::stage::Stage;
use crate::import::mesh::unreadable;
use crate::import::mesh::words::{Word, Words};

/// How numbers are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Text,
    LittleEndian,
    BigEndian,
}

/// The type of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// By both of its names.
    fn named(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// How many bytes it takes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Whether it is a whole number.
    pub(super) fn is_whole(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// A number of an element, or a list of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Property {
    pub(super) name: String,
    /// The type of a list's length.
    pub(super) length: Option<Scalar>,
    pub(super) of: Scalar,
}

/// So many things with the same properties.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

/// What a file declares.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) format: Format,
    pub(super) elements: Vec<Element>,
    /// Textures that comments name, as some programs do.
    textures: usize,
}

impl Header {
    /// The header, and the file from its end on.
    ///
    /// # Errors
    /// The first line that cannot be read.
    pub(super) fn of(bytes: &[u8]) -> Result<(Self, Words<'_>), Unreadable> {
        /// More than any program writes.
        const MOST_PROPERTIES: usize = 1_000;
        let mut words = Words::plain(bytes);
        let mut line = Vec::new();
        let first = words.next_word().filter(|word| word.text == b"ply");
        let place = words.place();
        let first = first.ok_or_else(|| unreadable((1, 1), "expected `ply` as the first word"))?;
        words.skip_line();
        let mut format = None;
        let mut elements: Vec<Element> = Vec::new();
        let mut textures = 0;
        let mut properties = 0;
        let mut at = (first.place.0, place.1);
        while words.next_header_line(&mut line) {
            let [keyword, given @ ..] = &line[..] else { continue };
            at = keyword.place;
            let bad = |expected: &str| {
                let message = format!("expected {expected} after `{}`", keyword.shown());
                unreadable(keyword.place, message)
            };
            match keyword.text {
                b"comment" => {
                    let names = given.first().is_some_and(|word| word.text == b"TextureFile");
                    textures += usize::from(names);
                }
                b"obj_info" => {}
                b"format" => format = Some(format_of(given).ok_or_else(|| bad(FORMATS))?),
                b"element" => {
                    let [name, count] = given else { return Err(bad("a name and a count")) };
                    let count = count.whole().map_err(|why| unreadable(count.place, why))?;
                    let name = name.shown();
                    if elements.iter().any(|known| known.name == name) {
                        let message = format!("expected another name: `{name}` is there already");
                        return Err(unreadable(keyword.place, message));
                    }
                    elements.push(Element { name, count, properties: Vec::new() });
                }
                b"property" => {
                    let element = elements.last_mut();
                    let element = element.ok_or_else(|| {
                        unreadable(keyword.place, "expected `element` before `property`")
                    })?;
                    properties += 1;
                    let property = property_of(given)
                        .filter(|_| properties <= MOST_PROPERTIES)
                        .ok_or_else(|| bad("a type and a name, or `list`, two types and a name"))?;
                    element.properties.push(property);
                }
                b"end_header" => {
                    let format = format.ok_or_else(|| {
                        unreadable(keyword.place, "expected a line `format` before")
                    })?;
                    return Ok((Self { format, elements, textures }, words));
                }
                _ => {
                    let message = format!(
                        "expected `comment`, `element`, `property` or `end_header`, found \"{}\"",
                        keyword.shown()
                    );
                    return Err(unreadable(keyword.place, message));
                }
            }
        }
        Err(unreadable(at, "expected a line `end_header` after this, found the file's end"))
    }

    /// What comments ask for.
    pub(super) fn note(&self, stage: &mut Stage) {
        if self.textures > 0 {
            let what = "the texture that a comment names is left out";
            stage.lost.add(None, "comment TextureFile", what);
        }
    }
}

const FORMATS: &str = "`ascii 1.0`, `binary_little_endian 1.0` or `binary_big_endian 1.0`";

fn format_of(given: &[Word<'_>]) -> Option<Format> {
    let [name, version] = given else { return None };
    let format = match name.text {
        b"ascii" => Format::Text,
        b"binary_little_endian" => Format::LittleEndian,
        b"binary_big_endian" => Format::BigEndian,
        _ => return None,
    };
    (version.text == b"1.0").then_some(format)
}

fn property_of(given: &[Word<'_>]) -> Option<Property> {
    match given {
        [list, length, of, name] if list.text == b"list" => Some(Property {
            name: name.shown(),
            length: Some(Scalar::named(length.text).filter(|length| length.is_whole())?),
            of: Scalar::named(of.text)?,
        }),
        [of, name] => {
            Some(Property { name: name.shown(), length: None, of: Scalar::named(of.text)? })
        }
        _ => None,
    }
}
