//! `Axis`: one of three, found and used without a branch or a check.
#![allow(unsafe_code)]

/// The x, y or z axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Axis(
    /// Below 3, which [`Axis::from_longest`] sees to, the only way to one.
    u8,
);

impl Axis {
    /// The axis along which a direction is longest, last, and the other two, in
    /// a cycle. Without a branch: it is as good as random.
    #[inline(always)]
    pub(crate) fn from_longest(direction: &[f64; 3]) -> [Self; 3] {
        let [x, y, z] = [direction[0].abs(), direction[1].abs(), direction[2].abs()];
        let is_x = u8::from(x >= y) & u8::from(x >= z);
        let is_z = u8::from(!(y >= z)) & (1 - is_x);
        // 0, 1 or 2, as at most one of them is 1.
        let last = 1 - is_x + is_z;
        let next = |axis: u8| if axis == 2 { 0 } else { axis + 1 };
        [Self(next(last)), Self(next(next(last))), Self(last)]
    }

    /// This axis of something that has three.
    #[inline(always)]
    pub(crate) fn of<T>(self, three: &[T; 3]) -> &T {
        // SAFETY: the type: the number is below 3.
        unsafe { three.get_unchecked(usize::from(self.0)) }
    }

    /// This axis of something that has three, to be written.
    #[inline(always)]
    pub(crate) fn of_mut<T>(self, three: &mut [T; 3]) -> &mut T {
        // SAFETY: the type: the number is below 3.
        unsafe { three.get_unchecked_mut(usize::from(self.0)) }
    }
}
