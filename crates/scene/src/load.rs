//! `load`: text to scene, with the problems of every step together.

use serde::de::DeserializeOwned;
use tracer::Scene;
use tracer::accel::Build;

use crate::compile::{Finding, compile as compile_all};
use crate::diagnose::{Diagnosis, Problem, Tree, diagnose, ron_options};
use crate::{Assets, MAX_SCENE_BYTES, SceneFile, Span, Step, Unchecked};

/// What a caller keeps under a scene's `check`.
pub trait Check: DeserializeOwned {
    /// Calls `report(path, message)` for everything that makes no sense in it,
    /// given the picture's size; `path` starts inside `check`.
    fn examine(&self, image: (u32, u32), report: &mut dyn FnMut(Vec<Step>, String));

    /// The same for what makes no sense beside this scene, which is asked only
    /// where everything in it could be read.
    fn examine_beside(&self, _file: &SceneFile<Self>, _report: &mut dyn FnMut(Vec<Step>, String)) {}
}

impl Check for Unchecked {
    fn examine(&self, _: (u32, u32), _: &mut dyn FnMut(Vec<Step>, String)) {
        match *self {}
    }
}

/// A scene file without problems.
#[derive(Debug, Clone)]
pub struct Loaded<C> {
    /// What was written.
    pub file: SceneFile<C>,
    /// What can be rendered.
    pub scene: Scene,
}

/// Reads a scene.
///
/// `assets` gives the files that the scene names; `build` says which
/// accelerator its groups and meshes get, which no picture depends on.
///
/// # Errors
/// Every problem of the text, by place: of its form and of its meaning. What a
/// problem of form leaves unknown is not judged for its meaning.
pub fn load<C: Check>(
    text: &str,
    assets: &dyn Assets,
    build: Build,
) -> Result<Loaded<C>, Vec<Problem>> {
    if text.len() > MAX_SCENE_BYTES {
        return Err(vec![Problem {
            span: Span { start: 0, end: 0 },
            message: format!(
                "expected a scene of at most {MAX_SCENE_BYTES} bytes, found {}",
                text.len()
            ),
            help: Some("put large meshes into OBJ or PLY files".to_owned()),
        }]);
    }
    match ron_options().from_str::<SceneFile<C>>(text) {
        Ok(file) => {
            let (scene, mut findings) = judge(&file, assets, build);
            if let Some(check) = &file.check {
                check.examine_beside(&file, &mut in_check(&mut findings));
            }
            match scene {
                Some(scene) if findings.is_empty() => Ok(Loaded { file, scene }),
                _ => {
                    let (tree, _) = Tree::read(text);
                    Err(arranged(findings.into_iter().map(|f| f.problem(&tree)).collect()))
                }
            }
        }
        Err(_) => Err(explain::<C>(text, assets, build)),
    }
}

/// What was written in a text, whether it makes sense or not; `None` where it
/// cannot be read at all, which [`load`] explains.
pub fn parse<C: DeserializeOwned>(text: &str) -> Option<SceneFile<C>> {
    ron_options().from_str(text).ok()
}

/// The scene of a file that was changed after it was read; its `check` is not
/// looked at.
///
/// # Errors
/// Every problem of its meaning, without a place: there is no text.
pub fn recompile<C>(
    file: &SceneFile<C>,
    assets: &dyn Assets,
    build: Build,
) -> Result<Scene, Vec<String>> {
    match compile_all(file, assets, build) {
        (Some(scene), findings) if findings.is_empty() => Ok(scene),
        (_, findings) => Err(findings.into_iter().map(|finding| finding.message).collect()),
    }
}

/// The place in a text of the value at `path`; where it is not written down, of
/// the nearest value around it that is.
pub fn span_of(text: &str, path: &[Step]) -> Span {
    Tree::read(text).0.locate(path)
}

/// What is wrong with a text that `ron` refuses.
fn explain<C: Check>(text: &str, assets: &dyn Assets, build: Build) -> Vec<Problem> {
    let diagnosis: Diagnosis<SceneFile<C>> = diagnose(text);
    let mut problems = Vec::new();
    if let Some(file) = &diagnosis.value {
        let (_, findings) = judge(file, assets, build);
        let certain = findings.into_iter().filter(|f| !diagnosis.is_doubtful(&f.path));
        problems.extend(certain.map(|f| f.problem(&diagnosis.tree)));
    }
    problems.extend(diagnosis.problems);
    arranged(problems)
}

/// The scene, if there is one, and what makes no sense in the file.
fn judge<C: Check>(
    file: &SceneFile<C>,
    assets: &dyn Assets,
    build: Build,
) -> (Option<Scene>, Vec<Finding>) {
    let (scene, mut findings) = compile_all(file, assets, build);
    if let Some(check) = &file.check {
        check.examine(file.image, &mut in_check(&mut findings));
    }
    (scene, findings)
}

/// Notes what is found inside `check`.
fn in_check(findings: &mut Vec<Finding>) -> impl FnMut(Vec<Step>, String) {
    |inside, message| {
        let path = std::iter::once(Step::from("check")).chain(inside).collect();
        findings.push(Finding { path, message, help: None });
    }
}

/// The most problems that are listed: nobody mends more at a time, and a file
/// may be all mistakes.
const MOST_PROBLEMS: usize = 1_000;

/// By place, and not too many.
fn arranged(mut problems: Vec<Problem>) -> Vec<Problem> {
    problems.sort_by_key(|p| p.span);
    let more = problems.len().saturating_sub(MOST_PROBLEMS);
    if more > 0 {
        problems.truncate(MOST_PROBLEMS);
        if let Some(last) = problems.last_mut() {
            last.help = Some(format!("{more} further problems are not listed"));
        }
    }
    problems
}

impl Finding {
    fn problem(self, tree: &Tree) -> Problem {
        Problem { span: tree.locate(&self.path), message: self.message, help: self.help }
    }
}
