//! `Metric`: what is counted or measured over the cases of a family.

/// How a metric adds up over many cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sum {
    /// How many cases show it.
    Count,
    /// The largest value of any case.
    Most,
    /// The value that 99.9 % of the cases stay below.
    P999,
    /// How many cases in a million show it.
    Ppm,
}

macro_rules! metrics {
    ($($(#[$doc:meta])* $name:ident, $word:literal, $sum:ident;)*) => {
        /// A number with a meaning, a unit and a way of adding up.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Metric {
            $($(#[$doc])* $name,)*
        }

        impl Metric {
            /// Every metric, in the order of [`Metric::index`].
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The name in tables and files.
            pub fn name(self) -> &'static str {
                match self { $(Self::$name => $word,)* }
            }

            /// How it adds up.
            pub fn sum(self) -> Sum {
                match self { $(Self::$name => Sum::$sum,)* }
            }
        }
    };
}

metrics! {
    /// Exact hits that the kernel missed, ties left out.
    FalseMisses, "false_misses", Count;
    /// Exact misses that the kernel hit, ties left out.
    FalseHits, "false_hits", Count;
    /// Hits of another face, part or root than the exact one.
    WrongIdentity, "wrong_identity", Count;
    /// Rays that left a closed surface without a hit.
    Leaks, "leaks", Count;
    /// Rays that cross a surface once and were given more than one hit.
    DoubleHits, "double_hits", Count;
    /// Spawned rays that met the very surface they left.
    SelfHits, "self_hits", Count;
    /// Rays on which the accelerator and a loop over everything disagree.
    Disagreements, "disagreements", Count;
    /// Answers that hold a NaN or an infinity, or to a question that does.
    NotFinite, "not_finite", Count;
    /// Cases that decide nothing: too close to call, or not judged at all. A
    /// family has few of them, or it would be green without having asked.
    Ties, "ties_ppm", Ppm;
    /// Panics.
    Panics, "panics", Count;
    /// Mirrored questions whose answers are not mirrored to the bit.
    MirrorFlaws, "mirror_flaws", Count;
    /// Pictures with other bits than the table has.
    OtherBits, "other_bits", Count;
    /// The largest error of `t`, rounded to `f32`, in units of its last place
    /// in `f32`; to six digits after the point.
    Ulp32, "ulp32_max", Most;
    /// What 99.9 % of those errors stay below.
    Ulp32Usual, "ulp32_p99.9", P999;
    /// The largest error of `t` in units of its last place in `f64`.
    Ulp64, "ulp64_max", Most;
    /// What 99.9 % of those errors stay below.
    Ulp64Usual, "ulp64_p99.9", P999;
    /// The largest error of `t` over what one rounding of each of the inputs
    /// may change it by: `|dt| / (kappa u |t|)`.
    ConditionError, "condition_error", Most;
    /// The largest distance of a hit from where it should be, over the
    /// object's size.
    PositionError, "position_error", Most;
    /// The largest angle between a normal and the exact one, in units of 2^-53.
    NormalError, "normal_error", Most;
    /// The largest distance of a spawned ray's origin from the surface, over
    /// the object's size.
    OffsetOverSize, "offset_over_size", Most;
    /// The largest distance of a hit's point from the true surface, over the
    /// error bound that the hit states.
    ErrorOverBound, "error_over_bound", Most;
    /// The largest distance in pixels of an eye ray from its pixel's center.
    PixelError, "pixel_error", Most;
}

impl Metric {
    /// The place in [`Metric::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// The metric of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|metric| metric.name() == name)
    }
}
