//! `Kept`: cases that once failed, as lines of text with exact numbers.
//!
//! A line is a family and its numbers in hexadecimal floating point, as C's
//! `%a` writes them: `sphere/grazing 0x1.8p+1 -0x0p+0`. `#` starts a comment.

use std::fmt::Write as _;

use crate::Case;

/// A case of a family.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// The family's label.
    pub family: String,
    /// Its numbers.
    pub case: Case,
}

impl Kept {
    /// The line that [`read`] takes.
    pub fn line(&self) -> String {
        let mut line = self.family.clone();
        for &x in self.case.numbers() {
            line.push(' ');
            line.push_str(&hex_of(x));
        }
        line
    }
}

/// The cases of a text.
///
/// # Errors
/// The first line that is not a family and numbers.
pub fn read(text: &str) -> Result<Vec<Kept>, String> {
    let mut all = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or("").trim();
        let mut words = line.split_whitespace();
        let Some(family) = words.next() else { continue };
        let mut numbers = Vec::new();
        for word in words {
            let number = of_hex(word).ok_or_else(|| {
                format!("line {}: expected a number such as -0x1.8p+3, found \"{word}\"", i + 1)
            })?;
            numbers.push(number);
        }
        let case = Case::of(&numbers).ok_or_else(|| {
            format!("line {}: expected at most 32 numbers, found {}", i + 1, numbers.len())
        })?;
        all.push(Kept { family: family.to_owned(), case });
    }
    Ok(all)
}

/// Bits of the mantissa, and of the exponent above them.
const MANTISSA_BITS: u32 = 52;
const EXPONENT_MASK: u64 = 0x7ff;
const EXPONENT_BIAS: i64 = 1023;

/// A number in hexadecimal, with its exact bits; NaN by name.
pub fn hex_of(x: f64) -> String {
    if x.is_nan() {
        return "nan".to_owned();
    }
    let sign = if x.is_sign_negative() { "-" } else { "" };
    if x.is_infinite() {
        return format!("{sign}inf");
    }
    let bits = x.to_bits();
    let mantissa = bits & ((1 << MANTISSA_BITS) - 1);
    let exponent = (bits >> MANTISSA_BITS & EXPONENT_MASK).cast_signed();
    let (lead, power) = match (exponent, mantissa) {
        (0, 0) => (0, 0),
        (0, _) => (0, 1 - EXPONENT_BIAS),
        _ => (1, exponent - EXPONENT_BIAS),
    };
    let mut text = format!("{sign}0x{lead}");
    let digits = format!("{mantissa:013x}");
    let digits = digits.trim_end_matches('0');
    if !digits.is_empty() {
        text.push('.');
        text.push_str(digits);
    }
    // Writing into a string does not fail.
    let _ = write!(text, "p{power:+}");
    text
}

/// The number of [`hex_of`]; `None` for anything else.
pub fn of_hex(word: &str) -> Option<f64> {
    let (sign, rest) = match word.strip_prefix('-') {
        Some(rest) => (1_u64 << 63, rest),
        None => (0, word),
    };
    let bits = match rest {
        "nan" => f64::NAN.to_bits(),
        "inf" => f64::INFINITY.to_bits(),
        _ => {
            let (digits, power) = rest.strip_prefix("0x")?.split_once('p')?;
            let power: i64 = power.strip_prefix('+').unwrap_or(power).parse().ok()?;
            let (lead, fraction) = digits.split_once('.').unwrap_or((digits, ""));
            let fits = fraction.len() <= 13 && fraction.bytes().all(|b| b.is_ascii_hexdigit());
            let mantissa = u64::from_str_radix(&format!("{fraction:0<13}"), 16).ok();
            let mantissa = mantissa.filter(|_| fits)?;
            let exponent = match lead {
                "0" if mantissa == 0 && power == 0 => 0,
                "0" if power == 1 - EXPONENT_BIAS => 0,
                "1" => {
                    let biased = power.checked_add(EXPONENT_BIAS)?;
                    (1..EXPONENT_MASK.cast_signed())
                        .contains(&biased)
                        .then_some(biased.cast_unsigned())?
                }
                _ => return None,
            };
            exponent << MANTISSA_BITS | mantissa
        }
    };
    Some(f64::from_bits(sign | bits))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_with_all_their_bits() {
        let mut numbers = vec![0.0, -0.0, 1.0, -1.5, f64::MAX, f64::MIN_POSITIVE, 5e-324, 0.1];
        numbers.extend([f64::INFINITY, f64::NEG_INFINITY, f64::MIN_POSITIVE.next_down()]);
        let mut rng = fastrand::Rng::with_seed(1);
        numbers.extend((0..10_000).map(|_| f64::from_bits(rng.u64(..))).filter(|x| !x.is_nan()));
        for x in numbers {
            let back = of_hex(&hex_of(x)).unwrap();
            assert_eq!(back.to_bits(), x.to_bits(), "{x} {}", hex_of(x));
        }
        assert!(of_hex(&hex_of(f64::NAN)).unwrap().is_nan());
        assert_eq!(hex_of(-3.0), "-0x1.8p+1");
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for word in ["", "1", "0x", "0x1.8", "0x2p+0", "0x1.80000000000000p+0", "0x1p+1024"] {
            assert_eq!(of_hex(word), None, "{word}");
        }
        assert!(of_hex("0x1.gp+0").is_none() && of_hex("0x1.+8p+0").is_none());
    }

    #[test]
    fn lines_come_back() {
        let case = Case::of(&[1.5, -0.0, 1e300]).unwrap();
        let kept = Kept { family: "sphere/grazing".to_owned(), case };
        let text = format!("# what it was\n\n{}  # why\n", kept.line());
        assert_eq!(read(&text), Ok(vec![kept]));
        assert!(read("sphere/grazing 1.5").unwrap_err().contains("line 1"));
        assert!(read(&format!("a{}", " 0x0p+0".repeat(33))).unwrap_err().contains("32"));
    }
}
