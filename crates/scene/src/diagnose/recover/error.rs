//! What serde says of a value, kept in its parts.

use std::fmt::{self, Display};

use serde::de::{self, Expected, Unexpected};

/// Why a value could not be made.
#[derive(Debug)]
pub(super) enum Error {
    /// What there is to say is recorded, or will be by the next run.
    Reported,
    /// A stand-in was refused, so what is around it needs one.
    Unfit,
    UnknownField,
    UnknownVariant,
    MissingField(&'static str),
    Length {
        expected: String,
    },
    Expected(String),
    Custom(String),
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reported | Self::Unfit => f.write_str("reported elsewhere"),
            Self::UnknownField => f.write_str("unknown name of a field"),
            Self::UnknownVariant => f.write_str("unknown variant"),
            Self::MissingField(name) => write!(f, "expected a field `{name}`"),
            Self::Length { expected } | Self::Expected(expected) => {
                write!(f, "expected {expected}")
            }
            Self::Custom(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for Error {}

impl de::Error for Error {
    fn custom<T: Display>(message: T) -> Self {
        Self::Custom(message.to_string())
    }

    fn invalid_type(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::Expected(expected.to_string())
    }

    fn invalid_value(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::Expected(expected.to_string())
    }

    fn invalid_length(_: usize, expected: &dyn Expected) -> Self {
        Self::Length { expected: expected.to_string() }
    }

    fn unknown_variant(_: &str, _: &'static [&'static str]) -> Self {
        Self::UnknownVariant
    }

    fn unknown_field(_: &str, _: &'static [&'static str]) -> Self {
        Self::UnknownField
    }

    fn missing_field(field: &'static str) -> Self {
        Self::MissingField(field)
    }

    fn duplicate_field(field: &'static str) -> Self {
        Self::Custom(format!("the field `{field}` is given twice"))
    }
}
