//! Scratch.
use tracer::*;
fn main() {
    for known in stress::known::known_pictures().unwrap() {
        let n = known.truth.len() as f64;
        print!("{:14}", known.name);
        let run = |s: &Scene| {
            let (p, st) = render_counted(s, &Plan::new(s, Skipping::On));
            (
                known.rmse(&p),
                st.get(Event::EyeRay) as f64 / n,
                known.errors(&p).iter().fold(0.0f64, |m, e| m.max(e.abs())),
            )
        };
        for e in [3e-2, 1e-2, 3e-3, 1e-3] {
            let (r, rays, worst) = run(&known.scene.with_error(e).unwrap());
            print!(" | {:.2} {:.1} w{:.1}", r / e, rays, worst / e);
        }
        print!(" || grid");
        for s in [1u32, 2, 4, 8, 16, 32] {
            let (r, rays, _) =
                run(&known.scene.with_samples(Samples::grid(s * s).unwrap()).unwrap());
            print!(" {rays:.0}:{r:.1e}");
        }
        println!();
    }
}
