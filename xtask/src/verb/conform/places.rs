//! What a run writes must not lie where its own adapters and rubrics are.

use std::path::{Path, PathBuf};

use conform::run::Renderer;
use harness::store;

use crate::CannotAsk;

/// Refuses to write over what the run itself reads: `inputs`, the adapters' files, and
/// the programs that their commands name by a path.
///
/// # Errors
/// One of `outputs` is one of them, or a renderer's folder in `out`, which is emptied,
/// has one in it.
pub(super) fn keep_apart(
    renderers: &[Renderer],
    inputs: &[PathBuf],
    (out, outputs): (&Path, &[PathBuf]),
) -> Result<(), CannotAsk> {
    let own = renderers.iter().flat_map(Renderer::own_files);
    for input in own.chain(inputs.iter().cloned()) {
        if let Some(output) = outputs.iter().find(|output| is_same(output, &input)) {
            let what = "is read by this run, and would be written over: name another file";
            return Err(CannotAsk::file(output, what));
        }
        let emptied = renderers.iter().map(|renderer| out.join(&renderer.info.id));
        if let Some(folder) = emptied.into_iter().find(|folder| store::is_inside(&input, folder)) {
            return Err(CannotAsk(format!(
                "{}: is emptied for results, and {} is in it: name another --out",
                folder.display(),
                input.display()
            )));
        }
    }
    Ok(())
}

/// Whether a file that is written at `output` would take the place of `input`, or of
/// what it leads to.
fn is_same(output: &Path, input: &Path) -> bool {
    let leads_to_it = || Some(store::real_path(output).ok()? == store::real_path(input).ok()?);
    store::is_inside(output, input) || leads_to_it().unwrap_or(false)
}
