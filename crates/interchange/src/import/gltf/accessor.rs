//! Accessors: lists of numbers in the views of a glTF file's buffers.

use super::buffer::{Buffers, none};
use super::document::{Accessor, Document, SparsePart};
use crate::import::mesh::part::MOST_ELEMENTS;

/// The type of a number.
#[derive(Debug, Clone, Copy)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(number: u32) -> Result<Self, String> {
        Ok(match number {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return Err(format!("expected a componentType such as 5126, found {number}")),
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    fn is_index(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }

    /// The number at the start of `bytes`, which are enough.
    fn read(self, bytes: &[u8], is_normalized: bool) -> f64 {
        let mut four = [0; 4];
        four[..self.size()].copy_from_slice(&bytes[..self.size()]);
        let bits = u32::from_le_bytes(four);
        let (number, most) = match self {
            Self::I8 => (f64::from((bits as u8).cast_signed()), 127.0),
            Self::U8 => (f64::from(bits), 255.0),
            Self::I16 => (f64::from((bits as u16).cast_signed()), 32_767.0),
            Self::U16 => (f64::from(bits), 65_535.0),
            Self::U32 => (f64::from(bits), 4_294_967_295.0),
            Self::F32 => return f64::from(f32::from_bits(bits)),
        };
        if is_normalized { (number / most).max(-1.0) } else { number }
    }
}

/// Tuples of numbers, as many as the type has.
///
/// # Errors
/// What is wrong with the accessor, the views or the buffers that it is in, and
/// numbers that are not finite.
pub(super) fn tuples<const N: usize>(
    document: &Document,
    buffers: &mut Buffers<'_>,
    index: usize,
) -> Result<Vec<[f64; N]>, String> {
    let (accessor, component) = find::<N>(document, index)?;
    let within = |why| format!("accessors[{index}]: {why}");
    let all = numbers(buffers, accessor, component).map_err(within)?;
    if let Some(bad) = all.as_flattened().iter().position(|x: &f64| !x.is_finite()) {
        return Err(within(format!("expected finite numbers, found another as number {bad}")));
    }
    Ok(all)
}

/// Whole numbers from 0.
///
/// # Errors
/// As [`tuples`], and numbers of another type.
pub(super) fn indices(
    document: &Document,
    buffers: &mut Buffers<'_>,
    index: usize,
) -> Result<Vec<u32>, String> {
    let (accessor, component) = find::<1>(document, index)?;
    if !component.is_index() || accessor.normalized {
        return Err(format!("accessors[{index}]: expected whole numbers from 0 for `indices`"));
    }
    let all = tuples::<1>(document, buffers, index)?;
    Ok(all.into_iter().map(|[number]| number as u32).collect())
}

fn find<const N: usize>(
    document: &Document,
    index: usize,
) -> Result<(&Accessor, Component), String> {
    let all = &document.accessors;
    let accessor = all.get(index).ok_or_else(|| none("accessors", all.len(), index))?;
    let within = |why: String| format!("accessors[{index}]: {why}");
    let component = Component::of(accessor.component_type).map_err(within)?;
    let shape = match N {
        1 => "SCALAR",
        2 => "VEC2",
        _ => "VEC3",
    };
    if accessor.shape != shape {
        let found: String = accessor.shape.chars().take(20).collect();
        return Err(within(format!("expected the type {shape}, found \"{found}\"")));
    }
    if accessor.count > MOST_ELEMENTS as u64 {
        let message =
            format!("expected at most {MOST_ELEMENTS} elements, found {}", accessor.count);
        return Err(within(message));
    }
    Ok((accessor, component))
}

fn numbers<const N: usize>(
    buffers: &mut Buffers<'_>,
    accessor: &Accessor,
    component: Component,
) -> Result<Vec<[f64; N]>, String> {
    let count = accessor.count as usize;
    let mut all = match accessor.buffer_view {
        Some(view) => {
            dense(buffers, (view, accessor.byte_offset), count, component, accessor.normalized)?
        }
        None => zeros(accessor)?,
    };
    let Some(sparse) = &accessor.sparse else { return Ok(all) };
    if sparse.count > accessor.count {
        return Err(format!("expected at most {count} sparse elements, found {}", sparse.count));
    }
    let few = sparse.count as usize;
    let SparsePart { buffer_view, byte_offset, component_type } = sparse.indices;
    let kind = Component::of(component_type)?;
    if !kind.is_index() {
        return Err("expected whole numbers from 0 for the sparse indices".to_owned());
    }
    let places = dense::<1>(buffers, (buffer_view, byte_offset), few, kind, false)?;
    let SparsePart { buffer_view, byte_offset, .. } = sparse.values;
    let place = (buffer_view, byte_offset);
    let values = dense::<N>(buffers, place, few, component, accessor.normalized)?;
    for ([place], value) in places.into_iter().zip(values) {
        let old = all.get_mut(place as usize);
        *old.ok_or_else(|| format!("expected sparse indices below {count}, found {place}"))? =
            value;
    }
    Ok(all)
}

/// What an accessor has without a view, of which a lie could make too many.
fn zeros<const N: usize>(accessor: &Accessor) -> Result<Vec<[f64; N]>, String> {
    const MOST: u64 = 1 << 20;
    if accessor.count > MOST {
        return Err(format!("expected a bufferView for {} elements", accessor.count));
    }
    Ok(vec![[0.0; N]; accessor.count as usize])
}

fn dense<const N: usize>(
    buffers: &mut Buffers<'_>,
    (view, offset): (usize, u64),
    count: usize,
    component: Component,
    is_normalized: bool,
) -> Result<Vec<[f64; N]>, String> {
    let (bytes, stride) = buffers.view(view)?;
    let size = component.size();
    let width = (N * size) as u64;
    let stride = stride.unwrap_or(width);
    if stride < width {
        return Err(format!("expected a byteStride of at least {width}, found {stride}"));
    }
    if count == 0 {
        return Ok(Vec::new());
    }
    let last = (count as u64 - 1).checked_mul(stride);
    let end = last.and_then(|last| last.checked_add(offset)?.checked_add(width));
    if end.is_none_or(|end| end > bytes.len() as u64) {
        return Err(format!(
            "expected room for {count} elements of {width} bytes from byte {offset} on in \
             bufferViews[{view}], which has {}",
            bytes.len()
        ));
    }
    let element = |i: usize| {
        let start = offset as usize + i * stride as usize;
        std::array::from_fn(|k| component.read(&bytes[start + k * size..], is_normalized))
    };
    Ok((0..count).map(element).collect())
}
