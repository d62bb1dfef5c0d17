//! Scratch.
use tracer::*;
fn main() {
    for known in stress::known::known_pictures().unwrap() {
        let s = known.scene.with_error(1e-3).unwrap();
        let (p, _) = render_counted(&s, &Plan::new(&s, Skipping::On));
        let e = known.errors(&p);
        let mut idx: Vec<usize> = (0..e.len()).collect();
        idx.sort_by(|a, b| e[*b].abs().total_cmp(&e[*a].abs()));
        println!("{}", known.name);
        for &k in &idx[..8] {
            let (x, y) = (k % 93, k / 93);
            println!(
                "   px ({x},{y}) lower left ({},{}) truth {:.5} off {:+.5}",
                x as f64 - 46.5,
                (69 - y) as f64 - 35.0,
                known.truth[k],
                e[k]
            );
        }
    }
}
