//! Nodes: which are seen, and where each is.

use tracer::glam::{DAffine3, DMat3, DVec3, DVec4};

use super::buffer::none;
use super::document::{Document, Node};
use crate::import::Unreadable;
use crate::import::mesh::stage::Stage;
use crate::import::mesh::unreadable_at_all;

/// A node by its number, with the map from its space into the world.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed {
    pub(super) node: usize,
    pub(super) world: DAffine3,
}

/// The nodes of the scene, each before those inside it.
///
/// # Errors
/// A node that is reached twice, so that they are no trees, and one that is not
/// there.
pub(super) fn placed(document: &Document, stage: &mut Stage) -> Result<Vec<Placed>, Unreadable> {
    let nodes = &document.nodes;
    let mut seen = vec![false; nodes.len()];
    let mut placed = Vec::new();
    let mut roots = roots(document, stage)?;
    roots.reverse();
    let mut next: Vec<Placed> = Vec::new();
    while let Some(Placed { node: number, world }) =
        next.pop().or_else(|| roots.pop().map(|node| Placed { node, world: DAffine3::IDENTITY }))
    {
        let node = nodes.get(number);
        let node = node.ok_or_else(|| unreadable_at_all(none("nodes", nodes.len(), number)))?;
        if std::mem::replace(&mut seen[number], true) {
            let message =
                format!("nodes[{number}]: expected a tree of nodes, found this one in it twice");
            return Err(unreadable_at_all(message));
        }
        let own =
            transform(node).map_err(|why| unreadable_at_all(format!("nodes[{number}]: {why}")))?;
        let world = world * own;
        placed.push(Placed { node: number, world });
        next.extend(node.children.iter().rev().map(|&node| Placed { node, world }));
    }
    Ok(placed)
}

fn roots(document: &Document, stage: &mut Stage) -> Result<Vec<usize>, Unreadable> {
    let scenes = &document.scenes;
    if scenes.is_empty() {
        let mut is_inside = vec![false; document.nodes.len()];
        for &child in document.nodes.iter().flat_map(|node| &node.children) {
            if let Some(is_inside) = is_inside.get_mut(child) {
                *is_inside = true;
            }
        }
        stage.chosen.push("no scene is in the file: all nodes are shown".to_owned());
        return Ok((0..document.nodes.len()).filter(|&node| !is_inside[node]).collect());
    }
    let number = document.scene.unwrap_or(0);
    if scenes.len() > 1 {
        let whose = if document.scene.is_some() { "as the file says" } else { "the first" };
        let count = scenes.len();
        stage.chosen.push(format!("of {count} scenes number {number} is shown, {whose}"));
    }
    let scene = scenes.get(number);
    let scene = scene.ok_or_else(|| unreadable_at_all(none("scenes", scenes.len(), number)))?;
    Ok(scene.nodes.clone())
}

/// The map from a node's space into its parent's.
fn transform(node: &Node) -> Result<DAffine3, String> {
    let Node { matrix, translation, rotation, scale, .. } = node;
    let has_steps = translation.is_some() || rotation.is_some() || scale.is_some();
    if let Some(matrix) = matrix {
        if has_steps {
            return Err("expected a matrix or its steps, found both".to_owned());
        }
        let column = |i: usize| DVec4::from_slice(&matrix[4 * i..]);
        let last = DVec4::from_array([0, 1, 2, 3].map(|i| column(i).w));
        if last != DVec4::W {
            return Err(format!("expected a matrix whose last row is 0, 0, 0, 1, found {last}"));
        }
        let [x, y, z, moved] = [0, 1, 2, 3].map(|i| column(i).truncate());
        let linear = DMat3::from_cols(x, y, z);
        return Ok(DAffine3::from_mat3_translation(linear, moved));
    }
    let turn = rotated(rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]))?;
    let linear = turn * DMat3::from_diagonal(scale.map_or(DVec3::ONE, DVec3::from));
    Ok(DAffine3::from_mat3_translation(linear, translation.map_or(DVec3::ZERO, DVec3::from)))
}

/// The rotation of a quaternion of any length, which rounds nothing that a
/// square root would.
///
/// Source: K. Shoemake, "Animating Rotation with Quaternion Curves", 1985.
fn rotated([x, y, z, w]: [f64; 4]) -> Result<DMat3, String> {
    /// Of the square of its length; beyond, its products are none.
    const SANE: std::ops::RangeInclusive<f64> = 1e-120..=1e120;
    let square = x * x + y * y + z * z + w * w;
    if !SANE.contains(&square) {
        return Err(format!("expected a rotation of length 1, found {:?}", [x, y, z, w]));
    }
    let s = 2.0 / square;
    Ok(DMat3::from_cols_array(&[
        1.0 - s * (y * y + z * z),
        s * (x * y + w * z),
        s * (x * z - w * y),
        s * (x * y - w * z),
        1.0 - s * (x * x + z * z),
        s * (y * z + w * x),
        s * (x * z + w * y),
        s * (y * z - w * x),
        1.0 - s * (x * x + y * y),
    ]))
}
