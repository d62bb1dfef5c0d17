//! `regions`: pixels of one opinion that lie together.

/// Pixels of one value that are connected over sides and corners.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Area<T> {
    /// What they have in common.
    pub(super) value: T,
    /// Their places in the rows, the first in reading order first.
    pub(super) pixels: Vec<usize>,
}

/// The areas of a map with rows of `width`, `None` being in none of them; in the
/// order of their first pixels.
pub(super) fn areas<T: Copy + PartialEq>(map: &[Option<T>], width: usize) -> Vec<Area<T>> {
    let mut is_taken = vec![false; map.len()];
    let mut found = Vec::new();
    let mut waiting = Vec::new();
    for start in 0..map.len() {
        let Some(value) = map[start].filter(|_| !is_taken[start]) else { continue };
        is_taken[start] = true;
        waiting.push(start);
        let mut pixels = Vec::new();
        while let Some(pixel) = waiting.pop() {
            pixels.push(pixel);
            let (x, y) = (pixel % width, pixel / width);
            for y in y.saturating_sub(1)..=y + 1 {
                for x in x.saturating_sub(1)..=(x + 1).min(width - 1) {
                    let near = y * width + x;
                    if map.get(near) == Some(&Some(value)) && !is_taken[near] {
                        is_taken[near] = true;
                        waiting.push(near);
                    }
                }
            }
        }
        pixels.sort_unstable();
        found.push(Area { value, pixels });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(rows: &[&str], expected: &[(char, usize)]) {
        let width = rows.first().map_or(0, |row| row.len());
        let map: Vec<_> = rows.concat().chars().map(|c| Some(c).filter(|c| *c != '.')).collect();
        let found: Vec<_> =
            areas(&map, width).iter().map(|area| (area.value, area.pixels.len())).collect();
        assert_eq!(found, expected, "{rows:?}");
    }

    #[test]
    fn what_touches_is_together() {
        check(&[], &[]);
        check(&["..", ".."], &[]);
        check(&["a"], &[('a', 1)]);
        check(&["a.a"], &[('a', 1), ('a', 1)]);
        check(&["a..", ".a.", "..a"], &[('a', 3)]);
        check(&["..a", ".a.", "a.."], &[('a', 3)]);
        check(&["ab", "ba"], &[('a', 2), ('b', 2)]);
        // The end of one row does not touch the start of the next.
        check(&["...a", "....", "a..."], &[('a', 1), ('a', 1)]);
        check(&["..a", "a.."], &[('a', 1), ('a', 1)]);
        check(&["aaa", "a.a", "aaa"], &[('a', 8)]);
    }

    #[test]
    fn a_large_area_does_not_overflow_the_stack() {
        let map = vec![Some(1); 1 << 20];
        let found = areas(&map, 1 << 10);
        assert_eq!((found.len(), found[0].pixels.len()), (1, 1 << 20));
    }
}
