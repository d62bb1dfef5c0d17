//! The report as people read it.

use std::fmt::Write as _;

use super::report::{Report, TARGETS};

/// Width of the column of engines, and of one error.
const NAMES: usize = 23;
const CELL: usize = 20;

/// A table for each scene: seconds to each error, and how many times goldray's
/// best way that is.
pub(crate) fn text(report: &Report) -> String {
    let mut text = String::new();
    // Writing into a string does not fail.
    for scene in &report.scenes {
        let (width, height) = scene.image;
        let closest: Vec<_> =
            scene.closest.iter().map(|(engine, rmse)| format!("{engine} {rmse:.1e}")).collect();
        let _ = writeln!(
            text,
            "{}: {}, {width} x {height}, truth {}; closest to it: {}",
            scene.scene,
            scene.about,
            scene.truth,
            closest.join(", ")
        );
        let heads = TARGETS.map(|rmse| format!("{:>CELL$}", format!("RMSE {rmse:e}"))).concat();
        let _ = writeln!(text, "  {:<NAMES$}{heads}", "seconds to");
        let of_scene = || report.reached.iter().filter(|one| one.scene == scene.scene);
        let mut engines: Vec<_> = of_scene().map(|one| one.engine.as_str()).collect();
        engines.dedup();
        for engine in engines {
            let cells = of_scene().filter(|one| one.engine == engine).map(|one| {
                let sign = match one.how {
                    "cheapest" => "<=",
                    "between" => "",
                    _ => "> ",
                };
                let ratio = report.ratios.iter().find(|ratio| {
                    (ratio.scene.as_str(), ratio.engine.as_str()) == (&scene.scene, engine)
                        && ratio.rmse == one.rmse
                });
                let times = ratio.map_or(String::new(), |ratio| {
                    format!("{}{}x", if ratio.at_least { ">" } else { "" }, digits(ratio.times))
                });
                format!("{:>11}{times:>9}", format!("{sign}{}", digits(one.seconds)))
            });
            let cells: String = cells.collect();
            let _ = writeln!(text, "  {engine:<NAMES$}{cells}");
        }
        text.push('\n');
    }
    for (engine, why) in &report.missing {
        let _ = writeln!(text, "missing: {engine}: {why}");
    }
    text
}

/// A number with three digits.
pub(super) fn digits(x: f64) -> String {
    match x {
        _ if x >= 100.0 => format!("{x:.0}"),
        _ if x >= 10.0 => format!("{x:.1}"),
        _ if x >= 1.0 => format!("{x:.2}"),
        _ => format!("{x:.3}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::report::tests::report;

    #[test]
    fn a_table_says_what_is_not_reached_and_who_is_missing() {
        let text = text(&report());
        let expected = "\
balls: 7 spheres, 640 x 480, truth integrated; closest to it: povray 1.0e-4
  seconds to                        RMSE 1e-2           RMSE 1e-3           RMSE 1e-4
  goldray-adaptive           <=0.100               0.224               0.707         
  povray                       0.600    6.00x     > 3.00   >13.4x     > 3.00   >4.24x

missing: mitsuba-llvm: not installed
";
        assert_eq!(text, expected, "{text}");
    }

    #[test]
    fn numbers_have_three_digits() {
        let all = [123.4, 12.34, 1.234, 0.1234, 0.001_234].map(digits);
        assert_eq!(all, ["123", "12.3", "1.23", "0.123", "0.001"]);
    }
}
