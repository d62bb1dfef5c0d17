//! The bench's rows as text to read, the fastest kernel of a family first.

use std::fmt::Write as _;

use super::{Report, Row};

/// What the build has, then a table for each family. A `*` is on the frontier.
pub fn text(report: &Report) -> String {
    let mut text = format!("built for: {}", report.features.join(", "));
    if !report.features.contains(&"fma") {
        text.push_str(" (no fma: mul_add is a call)");
    }
    text.push('\n');
    for rows in report.rows.chunk_by(|a, b| (a.primitive, a.family) == (b.primitive, b.family)) {
        let mut rows: Vec<_> = rows.iter().collect();
        rows.sort_by(|a, b| a.ns.total_cmp(&b.ns));
        let title = format!("{}/{}", rows[0].primitive, rows[0].family);
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "\n{title:<26} {:>8} {:>9} {:>9} {:>9} {:>10} {:>10}",
            "ns", "p50", "p99.9", "max", "wrong ppm", "leaks ppm"
        );
        for row in rows {
            let _ = writeln!(text, "{}", line(row));
        }
    }
    text.push_str("\nErrors are |t - exact| / |exact|; * is on the frontier of time and error.\n");
    text
}

fn line(row: &Row) -> String {
    let mark = if row.frontier { '*' } else { ' ' };
    let [p50, p999, max] = [row.error_p50, row.error_p999, row.error_max].map(error);
    let [wrong, leaks] = [row.misclassified_ppm, row.leaks_ppm].map(ppm);
    let (kernel, ns) = (row.kernel, row.ns);
    format!("{mark} {kernel:<24} {ns:>8.1} {p50:>9} {p999:>9} {max:>9} {wrong:>10} {leaks:>10}")
}

fn error(x: f64) -> String {
    if x.is_nan() {
        "-".to_owned()
    } else if x == 0.0 {
        "exact".to_owned()
    } else {
        format!("{x:.1e}")
    }
}

/// Parts per million with two digits or more; 0 is left empty.
pub(super) fn ppm(x: f64) -> String {
    /// From here on whole numbers have two digits.
    const WHOLE: f64 = 10.0;
    if x == 0.0 {
        String::new()
    } else if x < WHOLE {
        format!("{x:.1}")
    } else {
        format!("{x:.0}")
    }
}
