//! `Body`: the numbers after a PLY file's header.

use super::header::{Element, Format, Property, Scalar};
use crate::import::Unreadable;
use crate::import::mesh::part::MOST_ELEMENTS;
use crate::import::mesh::stage::Stage;
use crate::import::mesh::words::{Place, Words};

/// The values of one thing: for each property its numbers, which are one unless
/// it is a list.
pub(super) type Values = Vec<Vec<f64>>;

/// What is not read yet.
#[derive(Debug)]
pub(super) struct Body<'a> {
    format: Format,
    words: Words<'a>,
    bytes: &'a [u8],
    place: Option<Place>,
}

impl<'a> Body<'a> {
    /// What follows a header.
    pub(super) fn new(format: Format, words: Words<'a>) -> Self {
        let bytes = words.rest();
        Self { format, words, bytes, place: None }
    }

    /// Whether there may be as many things as an element says.
    ///
    /// # Errors
    /// Where there are fewer bytes left than they take at least.
    pub(super) fn has_room_for(&self, element: &Element) -> Result<(), Unreadable> {
        let least: usize = match self.format {
            // A digit and a space, but for the last.
            Format::Text => 2 * element.properties.len(),
            _ => element.properties.iter().map(|p| p.length.unwrap_or(p.of).size()).sum(),
        };
        let rest = match self.format {
            Format::Text => self.words.rest().len() + 1,
            _ => self.bytes.len(),
        };
        let needed = u128::from(element.count) * least.max(1) as u128;
        if needed <= rest as u128 {
            return Ok(());
        }
        Err(Unreadable {
            place: self.place,
            message: format!(
                "expected {needed} bytes or more for {} of element `{}`, found {rest}",
                element.count, element.name
            ),
            help: Some("the file is cut short, or its header is wrong".to_owned()),
        })
    }

    /// Reads the values of one thing.
    ///
    /// # Errors
    /// A file that ends before, and what is no number of its type.
    pub(super) fn read(
        &mut self,
        element: &Element,
        number: u64,
        values: &mut Values,
    ) -> Result<(), Unreadable> {
        values.resize_with(element.properties.len(), Vec::new);
        for (property, values) in element.properties.iter().zip(values) {
            values.clear();
            let read = self.property(property, values);
            read.map_err(|why| {
                self.error(element, number, &format!("property `{}`: {why}", property.name))
            })?;
        }
        Ok(())
    }

    /// An error in one of an element's things.
    pub(super) fn error(&self, element: &Element, number: u64, why: &str) -> Unreadable {
        let message = format!("`{}` number {number}: {why}", element.name);
        Unreadable { place: self.place, message, help: None }
    }

    fn property(&mut self, property: &Property, values: &mut Vec<f64>) -> Result<(), String> {
        let count = match property.length {
            None => 1,
            Some(length) => {
                let count = self.scalar(length)?;
                if count < 0.0 {
                    return Err(format!("expected a list's length, found {count}"));
                }
                if count > MOST_ELEMENTS as f64 {
                    return Err(format!(
                        "expected a list of at most {MOST_ELEMENTS}, found {count}"
                    ));
                }
                count as u64
            }
        };
        for _ in 0..count {
            values.push(self.scalar(property.of)?);
        }
        Ok(())
    }

    fn scalar(&mut self, of: Scalar) -> Result<f64, String> {
        if self.format == Format::Text {
            return self.word(of);
        }
        let ended = || "expected more bytes, found the file's end".to_owned();
        let (bytes, rest) = self.bytes.split_at_checked(of.size()).ok_or_else(ended)?;
        self.bytes = rest;
        let mut eight = [0; 8];
        let bits = if self.format == Format::BigEndian {
            eight[8 - bytes.len()..].copy_from_slice(bytes);
            u64::from_be_bytes(eight)
        } else {
            eight[..bytes.len()].copy_from_slice(bytes);
            u64::from_le_bytes(eight)
        };
        let number = match of {
            Scalar::I8 => f64::from((bits as u8).cast_signed()),
            Scalar::U8 => f64::from(bits as u8),
            Scalar::I16 => f64::from((bits as u16).cast_signed()),
            Scalar::U16 => f64::from(bits as u16),
            Scalar::I32 => f64::from((bits as u32).cast_signed()),
            Scalar::U32 => f64::from(bits as u32),
            Scalar::F32 => f64::from(f32::from_bits(bits as u32)),
            Scalar::F64 => f64::from_bits(bits),
        };
        if number.is_finite() {
            Ok(number)
        } else {
            Err(format!("expected a number, found {number}"))
        }
    }

    fn word(&mut self, of: Scalar) -> Result<f64, String> {
        let ended = "expected a number, found the file's end";
        let word = self.words.next_word().ok_or(ended)?;
        self.place = Some(word.place);
        let number = word.number()?;
        let range = match of {
            Scalar::I8 => -128.0..=127.0,
            Scalar::U8 => 0.0..=255.0,
            Scalar::I16 => -32_768.0..=32_767.0,
            Scalar::U16 => 0.0..=65_535.0,
            Scalar::I32 => -2_147_483_648.0..=2_147_483_647.0,
            Scalar::U32 => 0.0..=4_294_967_295.0,
            Scalar::F32 | Scalar::F64 => return Ok(number),
        };
        if range.contains(&number) && number.trunc() == number {
            return Ok(number);
        }
        let (min, max) = (range.start(), range.end());
        Err(format!("expected a whole number from {min} to {max}, found \"{}\"", word.shown()))
    }

    /// Notes what is left when all has been read.
    pub(super) fn end(mut self, stage: &mut Stage) {
        let left = match self.format {
            Format::Text => {
                self.words.next_word().map(|word| (Some(word.place), "words".to_owned()))
            }
            _ if self.bytes.is_empty() => None,
            _ => Some((None, format!("{} bytes", self.bytes.len()))),
        };
        if let Some((place, what)) = left {
            let what = format!("{what} after all that the header declares are left out");
            stage.lost.add(place, "end of the file", what);
        }
    }
}
