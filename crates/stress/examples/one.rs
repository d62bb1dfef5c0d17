//! Scratch.
use tracer::*;
fn main() {
    let known =
        stress::known::known_pictures().unwrap().into_iter().find(|k| k.name == "needles").unwrap();
    let s = known.scene.with_error(1e-3).unwrap();
    let (p, _) = render_counted(&s, &Plan::new(&s, Skipping::On));
    let errs = known.errors(&p);
    for y in 50..58 {
        for x in 12..26 {
            let k = y * 93 + x;
            if known.truth[k] > 0.0 {
                print!(" {:.3}{:+.3}", known.truth[k], errs[k]);
            } else {
                print!("      -      ");
            }
        }
        println!();
    }
}
