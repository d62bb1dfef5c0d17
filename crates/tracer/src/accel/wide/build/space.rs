//! `Space`: where the references of a set are, and where those of its sides
//! may go.

use super::reference::Reference;

/// Two stretches of memory of one length, between which sets are put back and
/// forth as they are cut. They may be longer than the set, so that references
/// of which both sides get a part find room.
pub(super) struct Space<'a> {
    pub here: &'a mut [Reference],
    pub there: &'a mut [Reference],
    /// As many of the tree's items, and where these start.
    pub items: &'a mut [u32],
    pub first: u32,
    /// Where in `here` the set is: it ends or starts where that does.
    pub start: usize,
    pub count: usize,
    /// How many inner nodes are above.
    pub level: usize,
    /// How many sets above it, one above the other and the last of those that
    /// planes were looked for in, had none that pays.
    pub misses: u32,
}

impl<'a> Space<'a> {
    /// The set.
    pub(super) fn set(&self) -> &[Reference] {
        &self.here[self.start..self.start + self.count]
    }

    /// The set, and room for its sides: for the left one from the start on, for
    /// the right one back from the end.
    pub(super) fn set_and_room(&mut self) -> (&mut [Reference], &mut [Reference]) {
        (&mut self.here[self.start..self.start + self.count], self.there)
    }

    /// How many more references there is room for.
    pub(super) fn spare(&self) -> usize {
        self.here.len() - self.count
    }

    /// That of both sides, when there are so many references in either and they
    /// are where they should be. What room is left goes to them by their size.
    pub(super) fn split(self, left: usize, right: usize) -> [Space<'a>; 2] {
        let spare = self.here.len() - left - right;
        let at = left + (spare as u64 * left as u64 / (left + right) as u64) as usize;
        let (left_here, right_here) = self.there.split_at_mut(at);
        let (left_there, right_there) = self.here.split_at_mut(at);
        let (left_items, right_items) = self.items.split_at_mut(at);
        let (level, misses) = (self.level + 1, self.misses);
        let start = right_here.len() - right;
        [
            Space {
                here: left_here,
                there: left_there,
                items: left_items,
                first: self.first,
                start: 0,
                count: left,
                level,
                misses,
            },
            Space {
                here: right_here,
                there: right_there,
                items: right_items,
                first: self.first + at as u32,
                start,
                count: right,
                level,
                misses,
            },
        ]
    }
}
