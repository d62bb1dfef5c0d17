//! `trace`: millions of rays a second through meshes, beside other tracers in
//! one interleaved run.

mod aimed;
mod builds;
mod embree;
mod engine;
mod goldray;
mod measure;
mod peer;
mod plot;
mod rays;
mod report;
mod table;
mod threads;

use std::path::PathBuf;

use tracer::accel::Build;
use tracer::shape::{Geometry, Mesh};

use self::engine::Libraries;
use self::rays::{Kind, RaySet};
use self::report::{Checked, Report, Row, SCHEMA};
use crate::files;
use crate::machine::Machine;
use crate::meshes::{self, SceneMesh};

/// The balls that `--scenes growth` stands for.
const GROWTH: [&str; 5] =
    ["bumpy-100", "bumpy-1000", "bumpy-10000", "bumpy-100000", "bumpy-1000000"];
/// What `--quick` measures: enough to see that all of it works.
const QUICK_SCENE: &str = "bumpy-10000";
const QUICK_SIZE: u32 = 64;
const QUICK_REPS: u32 = 3;
const QUICK_AIMED: usize = 1000;
/// Exact answers are looked at twice for about so many tests of a triangle, and
/// for no more rays than this.
const CHECKED_TESTS: usize = 50_000_000;
const CHECKED_RAYS: usize = 1000;

/// Flags of `bench trace`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Scenes: dragon-11k, dragon-47k, dragon-202k, dragon-871k, kitchen, hall,
    /// bumpy-N, a generated ball of N triangles, or growth, balls of 100 to a
    /// million
    #[arg(long, value_delimiter = ',', default_values = meshes::USUAL)]
    scenes: Vec<String>,
    /// Kinds of rays
    #[arg(long, value_delimiter = ',', value_enum, default_values_t = Kind::ALL)]
    rays: Vec<Kind>,
    /// Engines; all of them without
    #[arg(long, value_delimiter = ',')]
    engines: Vec<String>,
    /// Repetitions, in each of which every engine has a turn
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u32).range(1..))]
    reps: u32,
    /// Width and height of the picture whose eye rays start it all
    #[arg(long, default_value_t = 512, value_parser = clap::value_parser!(u32).range(8..=8192))]
    size: u32,
    /// Measure building, this many times
    #[arg(long, default_value_t = 0, value_name = "REPS")]
    builds: u32,
    /// Count wrong answers to rays aimed at edges and corners
    #[arg(long)]
    aimed: bool,
    /// A small generated mesh, few rays, everything once: seconds
    #[arg(long, conflicts_with_all = ["scenes", "size", "reps", "builds", "aimed"])]
    quick: bool,
    /// Write what was found to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Draw what was found into this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

pub(crate) fn run(args: &Args) -> Result<(), String> {
    let mut run = Run::new(args)?;
    let scenes = if args.quick { vec![QUICK_SCENE.to_owned()] } else { args.scenes.clone() };
    for name in scenes {
        let names = if name == "growth" { GROWTH.map(str::to_owned).to_vec() } else { vec![name] };
        for name in names {
            match meshes::named(&name)? {
                Some(scene) => run.measure(&scene)?,
                None => {
                    eprintln!("{name}: left out, not installed: cargo xtask bench peers --install");
                }
            }
        }
    }
    let report = &run.report;
    let Checked { rays, differ } = report.checked;
    print!("{}{}", table::means(report), table::growth(&report.rows));
    println!("exact answers that a walk over all triangles gives otherwise: {differ} of {rays}");
    if let Some(path) = &args.json {
        files::write(path, report.json()?.as_bytes())?;
    }
    if let Some(path) = &args.svg {
        files::write(path, plot::svg(&report.rows).as_bytes())?;
    }
    if differ > 0 {
        return Err(format!(
            "{differ} of {rays} sampled rays: expected goldray's exact answers to be those of a \
             walk over all triangles, found others: what is called wrong above is not to be \
             trusted"
        ));
    }
    Ok(())
}

/// What one run measures, and what it has found.
struct Run {
    names: Vec<&'static str>,
    kinds: Vec<Kind>,
    size: u32,
    reps: usize,
    builds: usize,
    aimed: Option<usize>,
    libraries: Libraries,
    report: Report,
}

impl Run {
    fn new(args: &Args) -> Result<Self, String> {
        let libraries = Libraries::open();
        let (machine, peers) = (Machine::here(), libraries.versions());
        let report = Report {
            schema: SCHEMA,
            machine,
            peers,
            rows: Vec::new(),
            builds: Vec::new(),
            aimed: Vec::new(),
            checked: Checked::default(),
        };
        let quick = |value: u32, quick: u32| if args.quick { quick } else { value };
        let aimed = if args.quick { QUICK_AIMED } else { aimed::COUNT };
        Ok(Self {
            names: engine_names(&args.engines)?,
            kinds: args.rays.clone(),
            size: quick(args.size, QUICK_SIZE),
            reps: quick(args.reps, QUICK_REPS) as usize,
            builds: quick(args.builds, 1) as usize,
            aimed: (args.aimed || args.quick).then_some(aimed),
            libraries,
            report,
        })
    }

    fn measure(&mut self, scene: &SceneMesh) -> Result<(), String> {
        let goldray = goldray::Meshes::new(&self.names, &scene.mesh)?;
        let (mut engines, left_out) =
            engine::make(&self.names, &scene.mesh, &goldray, &self.libraries);
        for (name, why) in left_out {
            eprintln!("{name}: left out: {why}");
        }
        let list = goldray::build(&scene.mesh, Build::List)?;
        let exact = &*goldray.accurate;
        let first = self.report.rows.len();
        for set in rays::sets(scene, exact, self.size, &self.kinds) {
            if set.rays.is_empty() {
                eprintln!("{} {}: left out: no eye ray hits the mesh", scene.name, set.name);
                continue;
            }
            let reference = self.reference(exact, &list, &set);
            let measured = measure::measure(&mut engines, &set, &reference, self.reps);
            let triangles = scene.mesh.faces.len();
            let rows = measured.iter().map(|found| Row::new(&scene.name, triangles, &set, found));
            self.report.rows.extend(rows);
        }
        println!("{}", table::scene(&self.report.rows[first..]));
        if let Some(count) = self.aimed {
            let first = self.report.aimed.len();
            for set in aimed::sets(scene, count) {
                let reference = self.reference(exact, &list, &set);
                self.report.aimed.extend(aimed::measure(scene, &mut engines, &set, &reference));
            }
            println!("{}", table::aimed(&self.report.aimed[first..]));
        }
        drop(engines);
        if self.builds > 0 {
            let built = builds::measure(scene, &self.names, &self.libraries, self.builds);
            println!("{}", table::builds(&built));
            self.report.builds.extend(built);
        }
        Ok(())
    }

    /// The exact answers to a set, some of them looked at twice.
    fn reference(&mut self, exact: &Mesh, list: &Mesh, set: &RaySet) -> Vec<Option<f64>> {
        let answers = exact_answers(exact, set);
        let budget = CHECKED_TESTS / list.triangle_count();
        let step = set.rays.len().div_ceil(budget.clamp(1, CHECKED_RAYS));
        for (ray, answer) in set.rays.iter().zip(&answers).step_by(step) {
            let twice = list.intersect(&ray.exact(), set.range()).map(|hit| hit.t);
            self.report.checked.rays += 1;
            self.report.checked.differ += usize::from(twice != *answer);
        }
        answers
    }
}

/// The engines asked for, in the order of the tables.
fn engine_names(asked: &[String]) -> Result<Vec<&'static str>, String> {
    if let Some(wrong) = asked.iter().find(|name| !engine::NAMES.contains(&&***name)) {
        let names = engine::NAMES.join(", ");
        return Err(format!("--engines: expected some of {names}, found `{wrong}`"));
    }
    let is_asked = |name: &&str| asked.is_empty() || asked.iter().any(|asked| asked == name);
    Ok(engine::NAMES.into_iter().filter(is_asked).collect())
}

/// What is right: goldray's exact answer to every ray.
fn exact_answers(exact: &Mesh, set: &RaySet) -> Vec<Option<f64>> {
    let answer = |ray: &rays::RayF32| exact.intersect(&ray.exact(), set.range()).map(|hit| hit.t);
    set.rays.iter().map(answer).collect()
}

#[cfg(test)]
mod tests;
