//! `codes`: the three codes of a pixel, or what a seeded fault makes of them.

use tracer::fault::{Fault, seeded};

use super::Transfer;

/// The codes of a pixel's channels.
#[inline(always)]
pub(super) fn codes(mut channels: [f64; 3], transfer: Transfer) -> [u8; 3] {
    if seeded(Fault::RedAndBlueSwapped) {
        channels.reverse();
    }
    let transfer = match transfer {
        Transfer::Gamma22 if seeded(Fault::SrgbForGamma) => Transfer::Srgb,
        Transfer::Srgb if seeded(Fault::GammaForSrgb) => Transfer::Gamma22,
        right => right,
    };
    channels.map(|c| code(c, transfer))
}

#[inline(always)]
fn code(c: f64, transfer: Transfer) -> u8 {
    if seeded(Fault::RoundedDown) {
        return (LARGEST * curve(c.clamp(0.0, 1.0), transfer)) as u8;
    }
    if c > 1.0 && seeded(Fault::OverflowWraps) {
        return (LARGEST * curve(c, transfer) + 0.5) as u64 as u8;
    }
    let code = transfer.code(c);
    if seeded(Fault::GammaTwice) { transfer.code(f64::from(code) / LARGEST) } else { code }
}

/// The largest code.
const LARGEST: f64 = 255.0;

/// The curve by its formula, which rounds: right codes come from thresholds.
fn curve(c: f64, transfer: Transfer) -> f64 {
    match transfer {
        Transfer::Gamma22 => libm::pow(c, 1.0 / 2.2),
        Transfer::Srgb if c <= 0.003_130_8 => 12.92 * c,
        Transfer::Srgb => 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055,
    }
}
