//! A face's corner: `v`, `v/t`, `v//n` or `v/t/n`.

use crate::import::mesh::words::shown;

/// Indices from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    pub(super) uv: Option<u32>,
    pub(super) normal: Option<u32>,
}

/// How many of each there are so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct Counts {
    pub(super) vertices: usize,
    pub(super) uvs: usize,
    pub(super) normals: usize,
}

impl Corner {
    /// Reads a corner.
    ///
    /// # Errors
    /// What was expected and found.
    pub(super) fn of(text: &[u8], counts: Counts) -> Result<Self, String> {
        let mut parts = text.split(|&byte| byte == b'/');
        let [vertex, uv, normal] = [0; 3].map(|_| parts.next().unwrap_or_default());
        if parts.next().is_some() {
            return Err(format!("expected a corner such as 1/2/3, found \"{}\"", shown(text)));
        }
        let optional = |text: &[u8], count, what| match text {
            b"" => Ok(None),
            text => index(text, count, what).map(Some),
        };
        Ok(Self {
            vertex: index(vertex, counts.vertices, "vertices")?,
            uv: optional(uv, counts.uvs, "texture coordinates")?,
            normal: optional(normal, counts.normals, "normals")?,
        })
    }
}

/// Counted from 1, or backwards from the last so far, which is -1.
fn index(text: &[u8], count: usize, what: &str) -> Result<u32, String> {
    let number: Option<i64> = std::str::from_utf8(text).ok().and_then(|text| text.parse().ok());
    let number = number.ok_or_else(|| {
        format!("expected the number of one of the {what}, found \"{}\"", shown(text))
    })?;
    let from_zero = match number {
        1.. => number - 1,
        _ if number < 0 => count.cast_signed() as i64 + number.max(i64::MIN / 2),
        _ => -1,
    };
    let found = u32::try_from(from_zero).ok().filter(|&i| (i as usize) < count);
    found.ok_or_else(|| {
        format!(
            "expected a number from 1 to {count}, or from -{count} to -1, as there are {count} \
             {what} before it, found {number}"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNTS: Counts = Counts { vertices: 3, uvs: 2, normals: 1 };

    #[track_caller]
    fn check(text: &str, vertex: u32, uv: Option<u32>, normal: Option<u32>) {
        assert_eq!(
            Corner::of(text.as_bytes(), COUNTS),
            Ok(Corner { vertex, uv, normal }),
            "{text}"
        );
    }

    #[track_caller]
    fn check_error(text: &str, expected: &str) {
        let error = Corner::of(text.as_bytes(), COUNTS).unwrap_err();
        assert!(error.contains(expected), "{text}: {error}");
    }

    #[test]
    fn corners_of_every_form() {
        check("3", 2, None, None);
        check("1/2", 0, Some(1), None);
        check("1//1", 0, None, Some(0));
        check("2/1/1", 1, Some(0), Some(0));
        check("-1/-2/-1", 2, Some(0), Some(0));
        check("-3//", 0, None, None);
    }

    #[test]
    fn corners_that_are_none() {
        check_error("", "expected the number of one of the vertices, found \"\"");
        check_error("/1", "one of the vertices");
        check_error("1/2/1/1", "expected a corner such as 1/2/3");
        check_error("0", "from 1 to 3, or from -3 to -1");
        check_error("4", "found 4");
        check_error("-4", "found -4");
        check_error("1/3", "2 texture coordinates before it, found 3");
        check_error("1//2", "1 normals before it, found 2");
        check_error("1.0", "found \"1.0\"");
        check_error("9223372036854775807", "found 9223372036854775807");
        check_error("-9223372036854775808", "found -9223372036854775808");
        check_error("9223372036854775808", "one of the vertices");
    }
}
