//! Proof with whole numbers of any size that every threshold is the right one.
//!
//! A positive `f64` is `m * 2^e` with whole m and e, so "c has at least code
//! k" is a comparison of whole numbers once both sides are raised to the
//! power that clears the root. Nothing here rounds.

use std::fmt::Write;

use num_bigint::BigUint;

use super::Transfer;
use super::thresholds::{GAMMA22, SRGB};

/// `c = m * 2^-shift`, for c in (0, 1].
fn parts(c: f64) -> (BigUint, usize) {
    assert!(0.0 < c && c <= 1.0);
    let fraction = c.to_bits() & ((1 << 52) - 1);
    match (c.to_bits() >> 52) as usize {
        0 => (fraction.into(), 1074),
        exponent => ((fraction | 1 << 52).into(), 1075 - exponent),
    }
}

/// Whether `c^power >= (numerator / denominator)^root`.
fn power_reaches(c: f64, power: u32, numerator: u64, denominator: u64, root: u32) -> bool {
    let (m, shift) = parts(c);
    let left = m.pow(power) * BigUint::from(denominator).pow(root);
    left >= BigUint::from(numerator).pow(root) << (shift * power as usize)
}

/// Whether the code of c is at least k: `255 f(c) + 1/2 >= k`, which is
/// `f(c) >= (2k - 1) / 510`.
fn has_code(transfer: Transfer, c: f64, k: u64) -> bool {
    match transfer {
        // c^(5/11) >= q is c^5 >= q^11.
        Transfer::Gamma22 => power_reaches(c, 5, 2 * k - 1, 510, 11),
        Transfer::Srgb if is_straight(c) => straight_has_code(c, k),
        Transfer::Srgb => curve_has_code(c, k),
    }
}

/// Whether `c <= 0.0031308`, the decimal number, not its nearest `f64`.
fn is_straight(c: f64) -> bool {
    let (m, shift) = parts(c);
    m * 10_000_000_u32 <= BigUint::from(31_308_u32) << shift
}

/// `12.92 c >= (2k - 1) / 510`.
fn straight_has_code(c: f64, k: u64) -> bool {
    power_reaches(c, 1, 100 * (2 * k - 1), 1292 * 510, 1)
}

/// `1.055 c^(5/12) - 0.055 >= (2k - 1) / 510`, which is
/// `c^5 >= ((1000 (2k - 1) + 55 * 510) / (1055 * 510))^12`.
fn curve_has_code(c: f64, k: u64) -> bool {
    power_reaches(c, 5, 1000 * (2 * k - 1) + 55 * 510, 1055 * 510, 12)
}

/// The bits of the smallest `f64` whose code is at least k.
fn smallest(transfer: Transfer, k: u64) -> u64 {
    let (mut below, mut reached) = (0, 1.0_f64.to_bits());
    while below + 1 < reached {
        let middle = u64::midpoint(below, reached);
        if has_code(transfer, f64::from_bits(middle), k) {
            reached = middle;
        } else {
            below = middle;
        }
    }
    reached
}

fn table(name: &str, doc: &str, transfer: Transfer) -> String {
    let mut text = format!("\n/// {doc}\n#[rustfmt::skip]\n");
    let _ = write!(text, "pub(super) const {name}: [u64; 255] = [");
    for k in 1..=255 {
        let hex = format!("{:016x}", smallest(transfer, k));
        let (a, b, c, d) = (&hex[..4], &hex[4..8], &hex[8..12], &hex[12..]);
        let _ = write!(text, "{}0x{a}_{b}_{c}_{d},", if k % 4 == 1 { "\n    " } else { " " });
    }
    text + "\n];\n"
}

/// The text of `thresholds.rs`.
fn generated() -> String {
    let head = "\
//! Generated: the `f64` bits at which each 8-bit code begins.
//!
//! Entry `k - 1` is the smallest `f64` whose exact code is at least k. The test
//! `the_file_is_what_whole_numbers_give` in `proof.rs` computes this file
//! again and prints it where it differs.
";
    head.to_owned()
        + &table("GAMMA22", "Thresholds of `c^(1/2.2)`.", Transfer::Gamma22)
        + &table("SRGB", "Thresholds of the sRGB curve.", Transfer::Srgb)
}

#[test]
fn the_file_is_what_whole_numbers_give() {
    let file = include_str!("thresholds.rs");
    let text = generated();
    assert!(file == text, "encode/thresholds.rs should read:\n{text}");
}

#[test]
fn each_threshold_has_its_code_and_the_next_value_down_has_not() {
    for (transfer, table) in [(Transfer::Gamma22, &GAMMA22), (Transfer::Srgb, &SRGB)] {
        for (k, &bits) in (1..).zip(table) {
            let threshold = f64::from_bits(bits);
            assert!(has_code(transfer, threshold, k), "{transfer:?} {k}");
            assert!(!has_code(transfer, threshold.next_down(), k), "{transfer:?} {k}");
            assert_eq!(u64::from(transfer.code(threshold)), k);
            assert_eq!(u64::from(transfer.code(threshold.next_down())), k - 1);
        }
    }
}

/// Each part of each curve rises, so the thresholds prove every value between
/// them; what is left is that sRGB does not fall back where its parts meet.
#[test]
fn both_parts_of_srgb_meet_inside_code_10() {
    let near = 0.003_130_8_f64;
    for c in [near.next_down().next_down(), near, near.next_up().next_up()] {
        for has_code in [straight_has_code, curve_has_code] {
            assert!(has_code(c, 10) && !has_code(c, 11), "{c}");
        }
    }
    assert!(is_straight(near.next_down()) && !is_straight(near.next_up()));
}

#[test]
fn random_values_have_their_exact_code() {
    let mut rng = fastrand::Rng::with_seed(1);
    for _ in 0..2000 {
        // Squares put half of the values below 1/4, where the codes are dense.
        let c = rng.f64().powi(2).max(1e-9);
        for transfer in [Transfer::Gamma22, Transfer::Srgb] {
            let code = u64::from(transfer.code(c));
            assert!(code == 0 || has_code(transfer, c, code), "{transfer:?} {c}");
            assert!(code == 255 || !has_code(transfer, c, code + 1), "{transfer:?} {c}");
        }
    }
}

/// The formulas as they are printed in their sources, in case the whole
/// numbers above are made from wrong ones.
#[test]
fn codes_are_within_a_half_of_the_formulas() {
    for i in 0..=100_000 {
        let c = f64::from(i) / 100_000.0;
        let gamma22 = libm::pow(c, 1.0 / 2.2);
        let srgb =
            if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055 };
        for (transfer, f) in [(Transfer::Gamma22, gamma22), (Transfer::Srgb, srgb)] {
            let off = f64::from(transfer.code(c)) - 255.0 * f;
            assert!(off.abs() < 0.5 + 1e-9, "{transfer:?} of {c} is off by {off}");
        }
    }
}
