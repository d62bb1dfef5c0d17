//! `trace`: millions of rays a second through meshes, beside other tracers in
//! one interleaved run.

mod embree;
mod engine;
mod goldray;
mod measure;
mod peer;
mod rays;
mod report;
mod table;

use std::path::PathBuf;

use tracer::shape::{Geometry, Mesh};

use self::engine::Libraries;
use self::rays::{Kind, RaySet};
use self::report::{Report, Row, SCHEMA};
use crate::files;
use crate::meshes::{self, SceneMesh};

/// Flags of `bench trace`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Scenes: dragon-11k, dragon-47k, dragon-202k, dragon-871k, kitchen, hall,
    /// or bumpy-N, a generated ball of N triangles
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
    /// Write what was found to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub(crate) fn run(args: &Args) -> Result<(), String> {
    let names = engine_names(&args.engines)?;
    let machine = files::machine();
    let mut report = Report { schema: SCHEMA, machine, rows: Vec::new() };
    let libraries = Libraries::open();
    for name in &args.scenes {
        match meshes::named(name)? {
            Some(scene) => measure_scene(args, &scene, &names, &libraries, &mut report)?,
            None => eprintln!("{name}: left out, not installed: cargo xtask bench peers --install"),
        }
    }
    print!("{}", table::means(&report));
    if let Some(path) = &args.json {
        let text = serde_json::to_string_pretty(&report).map_err(|why| why.to_string())?;
        files::write(path, text.as_bytes())?;
    }
    Ok(())
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

fn measure_scene(
    args: &Args,
    scene: &SceneMesh,
    names: &[&'static str],
    libraries: &Libraries,
    report: &mut Report,
) -> Result<(), String> {
    let goldray = goldray::Meshes::new(names, &scene.mesh)?;
    let (mut engines, left_out) = engine::make(names, &scene.mesh, &goldray, libraries);
    for (name, why) in left_out {
        eprintln!("{name}: left out: {why}");
    }
    let triangles = scene.mesh.faces.len();
    let first = report.rows.len();
    for set in rays::sets(scene, &goldray.accurate, args.size, &args.rays) {
        if set.rays.is_empty() {
            eprintln!("{} {}: left out: no eye ray hits the mesh", scene.name, set.name);
            continue;
        }
        let reference = exact_answers(&goldray.accurate, &set);
        let measured = measure::measure(&mut engines, &set, &reference, args.reps as usize);
        let rows = measured.iter().map(|found| Row::new(&scene.name, triangles, &set, found));
        report.rows.extend(rows);
    }
    println!("{}", table::scene(&report.rows[first..]));
    Ok(())
}

/// What is right: goldray's exact answer to every ray.
fn exact_answers(exact: &Mesh, set: &RaySet) -> Vec<Option<f64>> {
    let answer = |ray: &rays::RayF32| exact.intersect(&ray.exact(), set.range()).map(|hit| hit.t);
    set.rays.iter().map(answer).collect()
}
