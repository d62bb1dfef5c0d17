//! `Colors`: the spaces of color that FLIP filters and compares in.

use tracer::glam::{DMat3, DVec3};

/// XYZ of linear sRGB, row by row: IEC 61966-2-1 with the primaries' exact
/// fractions, as `flip-evaluator` has them.
const XYZ_FROM_RGB: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// The scales of CIE L*a*b*, which Y Cx Cz is the linear form of.
const L_SCALE: f64 = 116.0;
const L_OFFSET: f64 = 16.0;
const A_SCALE: f64 = 500.0;
const B_SCALE: f64 = 200.0;
/// Where the cube root of L*a*b* gives way to a straight line, cubed.
const DELTA: f64 = 6.0 / 29.0;
/// The Hunt effect: colors fade with their lightness, in full at L* = 100.
const HUNT: f64 = 0.01;

/// Conversions among spaces of color, for 8-bit sRGB.
pub(super) struct Colors {
    /// The linear value of every code.
    linear: Vec<f64>,
    /// From linear sRGB to XYZ where white is (1, 1, 1).
    xyz_from_rgb: DMat3,
    rgb_from_xyz: DMat3,
}

impl Colors {
    pub(super) fn new() -> Self {
        let rows = XYZ_FROM_RGB.map(DVec3::from);
        // White is the sum of the three primaries, a row's sum in each of XYZ.
        let [x, y, z] = rows.map(|row| row / row.element_sum());
        let xyz_from_rgb = DMat3::from_cols(x, y, z).transpose();
        let linear = (0..=u8::MAX).map(linear_of_srgb).collect();
        Self { linear, xyz_from_rgb, rgb_from_xyz: xyz_from_rgb.inverse() }
    }

    /// The opponent colors Y Cx Cz of a pixel: lightness from -16 to 100, red
    /// against green, yellow against blue. They are linear, so they can be blurred.
    pub(super) fn opponent(&self, srgb: [u8; 3]) -> DVec3 {
        let xyz = self.xyz_from_rgb * DVec3::from(srgb.map(|code| self.linear[usize::from(code)]));
        let DVec3 { x, y, z } = xyz;
        DVec3::new(L_SCALE * y - L_OFFSET, A_SCALE * (x - y), B_SCALE * (y - z))
    }

    /// Linear sRGB of opponent colors, cut to what a display can show.
    pub(super) fn shown(&self, opponent: DVec3) -> DVec3 {
        let y = (opponent.x + L_OFFSET) / L_SCALE;
        let xyz = DVec3::new(opponent.y / A_SCALE + y, y, y - opponent.z / B_SCALE);
        (self.rgb_from_xyz * xyz).clamp(DVec3::ZERO, DVec3::ONE)
    }

    /// L*a*b* of linear sRGB from 0 to 1, faded by the Hunt effect.
    pub(super) fn perceived(&self, rgb: DVec3) -> DVec3 {
        let [x, y, z] = (self.xyz_from_rgb * rgb).to_array().map(lightness);
        let l = L_SCALE * y - L_OFFSET;
        DVec3::new(l, HUNT * l * A_SCALE * (x - y), HUNT * l * B_SCALE * (y - z))
    }
}

/// Brightness from 0 to 1 of a pixel's lightness Y.
pub(super) fn brightness(opponent: DVec3) -> f64 {
    (opponent.x + L_OFFSET) / L_SCALE
}

/// The distance of two perceived colors: city blocks between lightnesses, the
/// straight line between hues. The source's equation 11.
pub(super) fn hyab(a: DVec3, b: DVec3) -> f64 {
    let DVec3 { x, y, z } = a - b;
    x.abs() + (y * y + z * z).sqrt()
}

/// The function `f` of L*a*b*.
fn lightness(t: f64) -> f64 {
    const AT_ZERO: f64 = L_OFFSET / L_SCALE;
    if t > DELTA * DELTA * DELTA { libm::cbrt(t) } else { t / (3.0 * DELTA * DELTA) + AT_ZERO }
}

/// The linear value of an sRGB code, IEC 61966-2-1.
fn linear_of_srgb(code: u8) -> f64 {
    const KNEE: f64 = 0.04045;
    const SLOPE: f64 = 12.92;
    const OFFSET: f64 = 0.055;
    const GAMMA: f64 = 2.4;
    let c = f64::from(code) / f64::from(u8::MAX);
    if c <= KNEE { c / SLOPE } else { libm::pow((c + OFFSET) / (1.0 + OFFSET), GAMMA) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(srgb: [u8; 3], expected: [f64; 3]) {
        let colors = Colors::new();
        let found = colors.perceived(colors.shown(colors.opponent(srgb)));
        assert!((found - DVec3::from(expected)).abs().max_element() < 5e-3, "{srgb:?}: {found}");
    }

    #[test]
    fn known_colors() {
        // L*, then a* and b* times L* / 100, of the published L*a*b* of sRGB
        // under D65.
        check([0; 3], [0.0; 3]);
        check([255; 3], [100.0, 0.0, 0.0]);
        check([119; 3], [50.034, 0.0, 0.0]);
        check([255, 0, 0], [53.241, 0.532_41 * 80.092, 0.532_41 * 67.203]);
        check([0, 255, 0], [87.735, 0.877_35 * -86.183, 0.877_35 * 83.179]);
        check([0, 0, 255], [32.297, 0.322_97 * 79.188, 0.322_97 * -107.860]);
        check([1; 3], [0.274, 0.0, 0.0]);
    }

    #[test]
    fn there_and_back() {
        let colors = Colors::new();
        for srgb in [[0; 3], [255; 3], [1, 2, 3], [255, 0, 128], [11, 10, 250]] {
            let linear = DVec3::from(srgb.map(linear_of_srgb));
            let found = colors.shown(colors.opponent(srgb));
            assert!((found - linear).abs().max_element() < 1e-14, "{srgb:?}: {found} {linear}");
        }
    }

    #[test]
    fn what_no_display_shows_is_cut() {
        let colors = Colors::new();
        assert_eq!(colors.shown(DVec3::new(1000.0, 0.0, 0.0)), DVec3::ONE);
        assert_eq!(colors.shown(DVec3::new(-1000.0, 0.0, 0.0)), DVec3::ZERO);
    }

    #[test]
    fn hues_are_straight_lines_and_lightness_is_added() {
        assert_eq!(hyab(DVec3::new(2.0, 3.0, 0.0), DVec3::new(1.0, 0.0, 4.0)), 6.0);
    }
}
