//! `import`: scenes of other programs, as scene files.

mod compare;
mod pattern;
mod place;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use harness::store::{self, FolderAssets};
use interchange::import::{self, Camera, Imported, Shading, Source, Unreadable, Wishes};

use crate::{Answer, CannotAsk, Here};
use compare::{Compare, Compared};
use place::Place;

/// Flags of `import`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// Scenes: the course's XML (.xml), the Standard Procedural Databases' (.nff), meshes with or
    /// without materials (.obj, .ply, .stl), glTF 2.0 (.gltf, .glb), scenes as JSON (.json)
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// The scene file to write (.ron), or a folder for one of each FILE
    #[arg(long, value_name = "FILE|DIR", required_unless_present = "compare_to")]
    out: Option<PathBuf>,
    /// Where to put the meshes: the folder of the scene file or one below it [default: beside it]
    #[arg(long, value_name = "DIR", requires = "out")]
    assets: Option<PathBuf>,
    /// The folder that a FILE may name files of, if it is not its own
    #[arg(long, value_name = "DIR")]
    assets_from: Option<PathBuf>,
    /// Go on without what goldray cannot do; it is listed all the same
    #[arg(long)]
    lossy: bool,
    /// The shading convention: classic, attenuated or radiometric [default: guessed, and said]
    #[arg(long, value_name = "NAME", value_parser = Wishes::shading)]
    shading: Option<Shading>,
    /// A camera in place of the file's, as a scene file has it
    #[arg(long, value_name = "RON", value_parser = Wishes::camera)]
    camera: Option<Camera>,
    /// The picture's size in place of the file's
    #[arg(long, value_name = "WxH", value_parser = Wishes::image)]
    image: Option<(u32, u32)>,
    /// Write over files that are there and differ
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    compare: Compare,
}

const EXAMPLES: &str = "\
Examples:
  cargo xtask import old/one-sphere.xml --out one-sphere.ron
  cargo xtask import old/*.xml --out scenes/ --assets scenes/meshes --assets-from old/
  cargo xtask import balls.nff --out balls.ron --lossy --image 256x256
  cargo xtask import old/*.xml --compare-to '{file}.png' --max-abs 1 --most 1
  cargo xtask import new/*.xml --shading radiometric --compare-to '{file}_ref.exr' --within 5e-5";

/// The largest foreign scene that is read, in bytes.
const MAX_BYTES: u64 = 256 << 20;

/// How it went with one file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Verdict {
    Done,
    /// Rendered, where the file has no picture and need have none.
    Alone,
    Refused,
    Differs,
    Unreadable,
}

pub(crate) fn run(here: &Here, args: &Args) -> Result<Answer, CannotAsk> {
    let places = places(args)?;
    let wishes = Wishes { camera: args.camera, image: args.image, shading: args.shading };
    let (mut verdicts, mut ours) = (Vec::new(), BTreeSet::new());
    for (file, place) in args.files.iter().zip(&places) {
        verdicts.push(one(here, (args, &wishes), (file, place.as_ref()), &mut ours));
    }
    let alone = verdicts.iter().filter(|&&one| one == Verdict::Alone).count();
    let is_uncompared = |one: &Verdict| matches!(one, Verdict::Alone | Verdict::Refused);
    if alone > 0 && verdicts.iter().all(is_uncompared) {
        println!("no answer   {}", args.compare.none_found(alone));
        return Ok(Answer::Code(2));
    }
    Ok(match verdicts.into_iter().max() {
        None | Some(Verdict::Done | Verdict::Alone) => Answer::Yes,
        Some(Verdict::Refused | Verdict::Differs) => Answer::No,
        Some(Verdict::Unreadable) => Answer::Code(2),
    })
}

/// Where each file's scene goes.
fn places(args: &Args) -> Result<Vec<Option<Place>>, CannotAsk> {
    let Some(out) = &args.out else {
        return Ok(args.files.iter().map(|_| None).collect());
    };
    let is_scene = out.extension().is_some_and(|ending| ending == "ron");
    if is_scene && args.files.len() > 1 {
        return Err(CannotAsk::file(
            out,
            "expected a folder, as there are several files to import",
        ));
    }
    if !is_scene && store::is_file(out) {
        return Err(CannotAsk::file(out, "expected a folder or a name that ends in .ron"));
    }
    let mut taken = BTreeSet::new();
    let place = |file: &PathBuf| {
        let ron = match file.file_stem() {
            _ if is_scene => out.clone(),
            Some(stem) => out.join(stem).with_added_extension("ron"),
            None => return Err(CannotAsk::file(file, "expected a file")),
        };
        if !taken.insert(ron.clone()) {
            let what = "two files would be written here: give their scenes folders of their own";
            return Err(CannotAsk::file(&ron, what));
        }
        Place::new(ron, args.assets.as_deref()).map(Some)
    };
    args.files.iter().map(place).collect()
}

/// Imports one file and says how it went.
fn one(
    here: &Here,
    (args, wishes): (&Args, &Wishes),
    (file, place): (&Path, Option<&Place>),
    ours: &mut BTreeSet<PathBuf>,
) -> Verdict {
    let label = interchange::visible(&file.display().to_string());
    let (mut imported, text) = match read(args, wishes, file, place) {
        Ok(found) => found,
        Err(problems) => {
            print_problems(&label, &problems);
            println!("unreadable  {label}: {}", counted(problems.len(), "problem"));
            return Verdict::Unreadable;
        }
    };
    for chosen in &imported.chosen {
        println!("{label}: chosen: {}", interchange::visible(chosen));
    }
    for lost in &imported.lost {
        let (element, what) =
            (interchange::visible(&lost.element), interchange::visible(&lost.what));
        println!("{}{element}: {what}", at(&label, lost.place));
    }
    let lost = imported.lost.len();
    if lost > 0 && !args.lossy {
        let what = counted(lost, "thing");
        println!("refused     {label}: {what} would be lost: --lossy goes on without");
        return Verdict::Refused;
    }
    let without =
        if lost > 0 { format!(", without {}", counted(lost, "thing")) } else { String::new() };
    if let Some(place) = place {
        let files = std::mem::take(&mut imported.files);
        if let Err(CannotAsk(why)) = place.write(here, &text, &files, (args.force, ours)) {
            println!("not written {label}: {why}");
            return Verdict::Unreadable;
        }
        let beside = match files.len() {
            0 => String::new(),
            n => format!(" and {}", counted(n, "file")),
        };
        println!("imported    {label}: wrote {}{beside}{without}", place.ron().display());
        imported.files = files;
    }
    let Some(found) = args.compare.with_reference(file, &label, &text, &imported.files) else {
        return Verdict::Done;
    };
    match found {
        Ok(Compared::Alone) => {
            println!("rendered    {label}: no picture to compare it with{without}");
            Verdict::Alone
        }
        Ok(Compared::Apart(distance)) if distance.is_within(args.compare.allowed()) => {
            println!("agrees      {label}: {distance}{without}");
            Verdict::Done
        }
        Ok(Compared::Apart(distance)) => {
            println!("differs     {label}: {distance}{without}");
            Verdict::Differs
        }
        Err(why) => {
            println!("no answer   {label}: {why}");
            Verdict::Unreadable
        }
    }
}

/// The scene of a file, with its text; or every reason why there is none.
fn read(
    args: &Args,
    wishes: &Wishes,
    file: &Path,
    place: Option<&Place>,
) -> Result<(Imported, String), Vec<Unreadable>> {
    let problem = |message: String| vec![Unreadable { place: None, message, help: None }];
    let bytes = store::read(file, MAX_BYTES)
        .map_err(|error| problem(error.what))?
        .ok_or_else(|| problem("there is no such file".to_owned()))?;
    let assets = match &args.assets_from {
        Some(home) => FolderAssets::within(file, home),
        None => FolderAssets::beside(file),
    };
    let name = file.display().to_string();
    let source = Source { name: &name, bytes: &bytes };
    let mut imported = import::import(source, wishes, &assets)?;
    if let Some(folder) = place.and_then(Place::assets) {
        imported.move_files(folder);
    }
    let text = imported.text(&name)?;
    Ok((imported, text))
}

fn print_problems(label: &str, problems: &[Unreadable]) {
    for problem in problems {
        println!("{}{}", at(label, problem.place), interchange::visible(&problem.message));
        if let Some(help) = problem.help.as_ref().filter(|help| !help.is_empty()) {
            println!("  = help: {help}");
        }
    }
}

/// `file:line:column: `, as far as it is known.
fn at(label: &str, place: Option<(usize, usize)>) -> String {
    match place {
        Some((line, column)) => format!("{label}:{line}:{column}: "),
        None => format!("{label}: "),
    }
}

fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
