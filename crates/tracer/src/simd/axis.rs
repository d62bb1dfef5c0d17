//! `Axis` and `Side`: one of three and one of six, found and used without a branch
//! or a check.
#![allow(unsafe_code)]

/// The x, y or z axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Axis(
    /// Below 3, as all in [`CYCLES`] are, which are the only ones.
    u8,
);

/// For the y, x and z axis the other two, in a cycle, and itself; the last has no
/// meaning.
const CYCLES: [[Axis; 3]; 4] = [
    [Axis(2), Axis(0), Axis(1)],
    [Axis(1), Axis(2), Axis(0)],
    [Axis(0), Axis(1), Axis(2)],
    [Axis(0), Axis(1), Axis(2)],
];

impl Axis {
    /// The axis along which a direction is longest, last, and the other two, in
    /// a cycle. Without a branch: it is as good as random.
    #[inline(always)]
    pub(crate) fn from_longest(direction: &[f64; 3]) -> [Self; 3] {
        let [x, y, z] = [direction[0].abs(), direction[1].abs(), direction[2].abs()];
        let is_x = u32::from(x >= y) & u32::from(x >= z);
        Self::cycle(is_x, u32::from(!(y >= z)) & !is_x)
    }

    /// The x or z axis, whose lowest bit is set, or the y axis; last, and the
    /// other two, in a cycle.
    #[inline(always)]
    pub(crate) fn cycle(is_x: u32, is_z: u32) -> [Self; 3] {
        CYCLES[((is_z & 1) << 1 | is_x & 1) as usize]
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

/// The lower or the upper side of boxes along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Side(
    /// Where its row begins among those of all sides, in bytes: the number of a
    /// row times its size, which every constructor sees to.
    usize,
);

impl Side {
    /// A row of eight sides, in bytes.
    const ROW: usize = size_of::<[f32; 8]>();

    /// For each axis the side by which a ray enters whose direction has these
    /// reciprocals: the upper where it goes down, a -0 too.
    #[inline(always)]
    pub(crate) fn entries(recip: [f32; 3]) -> [Self; 3] {
        let upper = |x: f32| (x.to_bits() >> 31) as usize;
        let [x, y, z] = recip;
        let row = |axis: usize, upper: usize| Self(2 * axis * Self::ROW + upper * Self::ROW);
        [row(0, upper(x)), row(1, upper(y)), row(2, upper(z))]
    }

    /// The other side along the axis.
    #[inline(always)]
    pub(crate) fn other(self) -> Self {
        // Rows come in pairs.
        Self(self.0 ^ Self::ROW)
    }

    /// The row of this side, for axes that have a lower and an upper one each.
    #[inline(always)]
    pub(crate) fn of(self, planes: &[[[f32; 8]; 2]; 3]) -> &[f32; 8] {
        // SAFETY: the type: it is one of the six rows, which are one behind the
        // other.
        unsafe { &*std::ptr::from_ref(planes).cast::<[f32; 8]>().byte_add(self.0) }
    }
}
