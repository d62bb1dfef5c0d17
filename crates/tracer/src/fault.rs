//! `Fault`: a mistake that can be seeded into the renderer, to see whether a
//! suite of fixtures notices.
//!
//! A place that can be wrong asks [`seeded`]. Without the feature `faults`, as
//! in every build that makes pictures for people, the answer is the constant
//! `false`, and nothing of the mistake is compiled. With it, one fault of the
//! process is on, by `seed`.
//!
//! To add one: its line in `faults!` below, and the place where it is made.

/// Makes the list of faults, each named by its line and described by its
/// comment.
macro_rules! faults {
    ($($(#[doc = $doc:literal])+ $name:ident,)*) => {
        /// A mistake that renderers are known to make.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Fault {
            $($(#[doc = $doc])+ $name,)*
        }

        impl Fault {
            /// All of them, in the order of a ray's way.
            pub const ALL: &[Self] = &[$(Self::$name,)*];

            /// What is wrong, in a sentence.
            pub fn words(self) -> &'static str {
                match self { $(Self::$name => concat!($($doc),+).trim_ascii(),)* }
            }

            /// The name, in words joined by `-`.
            pub fn name(self) -> String {
                let camel = match self { $(Self::$name => stringify!($name),)* };
                let mut name = String::new();
                for letter in camel.chars() {
                    if letter.is_ascii_uppercase() && !name.is_empty() {
                        name.push('-');
                    }
                    name.push(letter.to_ascii_lowercase());
                }
                name
            }
        }
    };
}

faults! {
    // The camera.
    /// Samples are in the corners of their cells, not in the middles.
    HalfPixelShift,
    /// The window's two coordinates are taken for each other.
    SwappedUAndV,
    /// The window's axis to the right points to the left.
    LeftHandedCamera,
    /// The window's axis upwards is the given up, not made upright to the others.
    UpNotUpright,
    /// The window's distance is taken along its normal, not along the view.
    DistanceAlongNormal,
    /// The window is as far away as the default, whatever the scene says.
    ProjDistanceIgnored,
    /// Rays of a parallel view start in the eye and spread.
    ParallelFromTheEye,
    /// The field of view is not halved.
    FovNotHalved,
    /// The picture's aspect is ignored by a field of view.
    AspectIgnored,
    /// The normal of an oblique window is ignored.
    ProjNormalIgnored,

    // Spheres.
    /// The far root is taken for the near one.
    FarRootOfSphere,
    /// A sphere is not seen from inside.
    SphereLostFromInside,
    /// A ray's direction is taken to have length 1.
    DirectionTakenAsUnit,
    /// The radius is not squared.
    RadiusNotSquared,

    // Boxes.
    /// A slab's sides are not swapped for a negative direction.
    SlabNotSwapped,
    /// A ray along a slab counts as inside wherever it is.
    ZeroDirectionAlwaysInside,
    /// A ray along a slab never counts as inside.
    ZeroDirectionNeverInside,
    /// A box is entered at the first of its three slabs, not at the last.
    BoxEnteredTooEarly,
    /// A box is not seen from inside.
    BoxLostFromInside,
    /// A box's normals point inward.
    BoxNormalInward,

    // Triangles and meshes.
    /// One of the three edge tests is inverted.
    EdgeTestInverted,
    /// One of the three edge tests is left out.
    EdgeTestMissing,
    /// A triangle is not seen from behind.
    BackFaceCulled,
    /// The order of a triangle's corners does not decide its normal's side.
    WindingIgnored,
    /// The weights of a triangle's second and third corner are swapped.
    WeightsSwapped,
    /// A mesh's normals are not interpolated.
    NormalsNotInterpolated,
    /// A mesh's normals are given to the next corner.
    NormalsOfTheNextCorner,

    // The other shapes.
    /// A disk is as endless as its plane.
    DiskWithoutRim,
    /// A plane is hit on the side of its normal only.
    PlaneOneSided,
    /// Cylinders and cones have no caps.
    CapsLost,
    /// A cylinder or cone is not cut off at its ends.
    EndlessSide,
    /// A cone's normal is that of a cylinder.
    ConeNormalOfCylinder,
    /// A torus' normal leads away from its center, not from its ring.
    TorusNormalFromCenter,

    // Which hit counts.
    /// A hit behind the ray's start counts.
    HitBehindTheEye,
    /// The lower end of the range counts as 0.
    TMinIgnored,
    /// The last surface tested wins, not the closest one.
    LastHitWins,
    /// Of two surfaces at the very same distance the last one wins.
    TieGoesToTheLast,
    /// The accelerator passes over one of a node's boxes.
    LeafSkipped,
    /// The accelerator stops at the first leaf with a hit.
    FirstLeafWins,
    /// The box of a group is left in the group's own space.
    GroupBoxNotMoved,

    // Groups.
    /// A group's steps are taken in the reverse order.
    GroupOrderSwapped,
    /// Rotations are about z, then y, then x.
    RotationOrderSwapped,
    /// Rotations turn the other way.
    RotationBackwards,
    /// A ray's direction is normalized on its way into a group.
    GroupRayNormalized,
    /// A normal leaves a group as a direction does, not by the inverse transpose.
    NormalAsDirection,
    /// A normal that leaves a group is not normalized again.
    NormalNotNormalized,
    /// An object without a material does not take that of its group.
    GroupMaterialIgnored,

    // Shading.
    /// No shadow ray is sent.
    ShadowRayDropped,
    /// A shadow ray does not end at its light.
    ShadowRayUnlimited,
    /// A shadow ray may meet the very surface that it leaves.
    ShadowAcne,
    /// What was in the last ray's way is taken to be in this one's as well.
    ShadowCacheTrusted,
    /// The cosine is that of the eye, not of the light.
    CosineOfTheEye,
    /// The cosine is not clamped at 0.
    CosineNotClamped,
    /// The cosine is that of a normal turned towards the light.
    CosineTwoSided,
    /// A light seen from behind the normal counts where it must not.
    TurnedAwayIgnored,
    /// Lambert's 1/pi is left out.
    PiForgotten,
    /// Every light has 0.98 of its intensity.
    LightDimmed,
    /// The last light is left out.
    LastLightLost,
    /// Every light is as red, green and blue as it is green.
    LightColorLost,
    /// Ambient light is left out.
    AmbientLost,
    /// A directional light comes from where it goes.
    DirectionReversed,
    /// Light does not weaken with distance.
    FalloffMissing,
    /// Light weakens with the distance, not with its square.
    FalloffLinear,
    /// A highlight's exponent is one less.
    ExponentOffByOne,
    /// The half vector is not normalized.
    HalfVectorNotNormalized,
    /// The highlight is about the mirrored ray, as in Phong's older model.
    HighlightOfPhong,
    /// A highlight is not multiplied by the cosine where it should be.
    HighlightWithoutCosine,
    /// A highlight has the diffuse color.
    HighlightColorDiffuse,

    // Mirrors and glass.
    /// A reflected ray goes the other way, into the mirror.
    ReflectionReversed,
    /// A mesh's interpolated normals do not bend reflections and refractions.
    ReflectionFaceted,
    /// A mirror reflects as much along its surface as straight on, where Schlick's law is asked for.
    SchlickForgotten,
    /// Glass reflects as much along its surface as straight on.
    FresnelForgotten,
    /// A ray leaves glass by the same ratio of indices as it enters.
    IndexNotInverted,
    /// What is totally reflected inside of glass is lost.
    TotalReflectionIgnored,
    /// Glass tints what it reflects as well.
    TintOfReflection,
    /// The light of a glaze is added to what is under it, which loses none.
    GlazeAdds,
    /// What a mirror shows of the background is black.
    BackgroundNotReflected,
    /// Rays are sent on once less than they may be.
    OneBounceTooFew,

    // What the picture shows.
    /// What is not hit is black.
    BackgroundIgnored,
    /// Exposure is ignored.
    ExposureIgnored,
    /// Depth is the ray's parameter, not the distance.
    DepthIsT,
    /// Normals are shown as they are, not moved into the range of colors.
    NormalsNotMoved,
    /// Objects are numbered from 1.
    IdsFromOne,

    // The picture.
    /// The lowest row is stored first.
    RowOrderFlipped,
    /// The last row is lost.
    LastRowLost,
    /// The last column is lost.
    LastColumnLost,
    /// A pixel's last sample is lost.
    SampleLost,
    /// Every pixel's samples are in the same places where they should be scattered.
    ScatteredAlike,
    /// Every filter is a box.
    FilterIgnored,
    /// The plan takes a member's last column of tiles for empty.
    TileLost,

    // The encoding.
    /// The curve is applied twice.
    GammaTwice,
    /// The sRGB curve stands in for the power of 1/2.2.
    SrgbForGamma,
    /// The power of 1/2.2 stands in for the sRGB curve.
    GammaForSrgb,
    /// Codes are rounded down, not to the nearest.
    RoundedDown,
    /// A value above 1 wraps around.
    OverflowWraps,
    /// Red and blue are swapped.
    RedAndBlueSwapped,
}

#[cfg(not(feature = "faults"))]
mod switch {
    use super::Fault;

    /// Whether this fault is on: never, in this build.
    #[inline(always)]
    pub const fn seeded(_: Fault) -> bool {
        false
    }
}

#[cfg(feature = "faults")]
mod switch {
    use std::sync::atomic::{AtomicBool, AtomicU8, Ordering::Relaxed};

    use super::Fault;

    /// The fault that is on, plus 1; 0 for none.
    static SEEDED: AtomicU8 = AtomicU8::new(0);
    /// Whether it was asked for since this was last read.
    static REACHED: AtomicBool = AtomicBool::new(false);

    /// Whether this fault is on.
    #[inline(always)]
    pub fn seeded(fault: Fault) -> bool {
        let is_on = SEEDED.load(Relaxed) == fault as u8 + 1;
        if is_on {
            REACHED.store(true, Relaxed);
        }
        is_on
    }

    /// Puts this fault on, and no other, for the whole process.
    pub fn seed(fault: Option<Fault>) {
        SEEDED.store(fault.map_or(0, |fault| fault as u8 + 1), Relaxed);
        REACHED.store(false, Relaxed);
    }

    /// Whether the place of the fault that is on was reached since this was last
    /// asked.
    pub fn was_reached() -> bool {
        REACHED.swap(false, Relaxed)
    }
}

pub use switch::*;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words_and_all_differ() {
        assert_eq!(Fault::SwappedUAndV.name(), "swapped-u-and-v");
        assert_eq!(Fault::TMinIgnored.name(), "t-min-ignored");
        let mut names: Vec<_> = Fault::ALL.iter().map(|fault| fault.name()).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), Fault::ALL.len());
        for fault in Fault::ALL {
            assert!(fault.words().ends_with('.'), "{fault:?}: {}", fault.words());
        }
    }

    #[cfg(not(feature = "faults"))]
    #[test]
    fn no_fault_is_on() {
        const NEVER: bool = seeded(Fault::HalfPixelShift);
        assert!(!NEVER && Fault::ALL.iter().all(|&fault| !seeded(fault)));
    }

    #[cfg(feature = "faults")]
    #[test]
    fn one_fault_is_on_and_says_that_it_was_reached() {
        seed(Some(Fault::FarRootOfSphere));
        assert!(!was_reached() && !seeded(Fault::GammaTwice) && !was_reached());
        assert!(seeded(Fault::FarRootOfSphere) && was_reached() && !was_reached());
        seed(None);
        assert!(Fault::ALL.iter().all(|&fault| !seeded(fault)));
    }
}
