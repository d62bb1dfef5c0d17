//! How a picture must be like that of a related scene: goldens that need no
//! golden.
//!
//! A relation makes another scene of the fixture's own, as it was written, of
//! which it is known how its picture and today's picture hang together: moved
//! together with the camera a scene looks the same, in other units too, and a
//! window of it shows what is seen there. So a picture is held against the
//! tracer itself where nobody has worked out a pixel. A relation that would do
//! nothing to a scene is a problem of the fixture.
//!
//! To add one: write its file, add its line to `relations!` below.

mod alike;
mod broken;
mod crop;
mod exposure;
mod flatten_groups;
mod identity_group;
mod mirror;
mod motion;
mod no_accelerator;
mod no_skipping;
mod objects;
mod permute_objects;
mod quarter_turn;
mod scale_units;
mod scale_window;
mod split_boxes;
mod sum_of_lights;
mod threads;
mod translate;
mod window;

pub use alike::{LOOSEST, MOST_EDGES};
pub use broken::Broken;
pub use crop::Crop;
pub use exposure::Exposure;
pub use flatten_groups::FlattenGroups;
pub use mirror::Mirror;
pub use motion::Axis;
pub use permute_objects::PermuteObjects;
pub use quarter_turn::QuarterTurn;
pub use scale_units::ScaleUnits;
pub use scale_window::ScaleWindow;
pub use split_boxes::SplitBoxes;
pub use sum_of_lights::SumOfLights;
pub use translate::Translate;

use serde::{Deserialize, Serialize};
use tracer::LinearImage;

use crate::check::File;
use crate::expectation::Rendered;
use crate::fixture::Fixture;
use alike::Alike;
use motion::Motion;
pub(crate) use window::Window;

/// A problem: the field that it is in, if it is in one, and what it is.
type Problem = (Option<&'static str>, String);

/// A fixture and its picture of today.
struct Today<'a> {
    fixture: &'a Fixture,
    picture: &'a LinearImage,
}

impl Today<'_> {
    /// Whether the picture of the scene, moved, is this one, moved.
    fn moves(&self, motion: Motion, alike: Alike) -> Result<(), Broken> {
        let file = &self.fixture.file;
        let found = self.fixture.render_related(&motion.file(file))?;
        alike.compare(&motion.picture(file, self.picture), &found)
    }
}

/// What every relation can say.
trait Relate {
    /// Itself, as a fixture has it, without what may be left out.
    fn words(&self) -> String;

    /// How alike the pictures must be.
    fn alike(&self) -> Alike {
        Alike::BITS
    }

    /// What makes no sense in it for this scene, or that it would do nothing.
    fn problems(&self, file: &File) -> Vec<Problem>;

    /// Whether the picture is as the related scene's says.
    ///
    /// # Errors
    /// Where it is not, or why there is no related picture.
    fn holds(&self, today: &Today<'_>) -> Result<(), Broken>;
}

/// Makes the enum of all relations and its dispatch from two lists.
macro_rules! relations {
    (
        with fields { $($(#[$doc:meta])* $name:ident,)* }
        without { $($(#[$plain_doc:meta])* $plain:ident in $module:ident,)* }
    ) => {
        /// Any relation.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields)]
        pub enum Relation {
            $($(#[$doc])* $name($name),)*
            $($(#[$plain_doc])* $plain,)*
        }

        impl Relation {
            /// The names of all, as a fixture has them.
            pub const NAMES: &[&str] = &[$(stringify!($name),)* $(stringify!($plain),)*];

            fn inner(&self) -> &dyn Relate {
                match self {
                    $(Self::$name(inner) => inner,)*
                    $(Self::$plain => &$module::$plain,)*
                }
            }

            /// Its name in a fixture.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$name(_) => stringify!($name),)*
                    $(Self::$plain => stringify!($plain),)*
                }
            }
        }
    };
}

relations! {
    with fields {
        /// Moved together with its camera, a scene looks the same.
        Translate,
        /// Turned together with its camera, a scene looks the same.
        QuarterTurn,
        /// Mirrored together with its camera, a scene is seen mirrored.
        Mirror,
        /// In other units of length a scene looks the same.
        ScaleUnits,
        /// A window as much larger as it is farther away shows the same.
        ScaleWindow,
        /// A box looks like its twelve triangles.
        SplitBoxes,
        /// A shape in a group looks like one that lies where the group puts it.
        FlattenGroups,
        /// The order of objects does not matter.
        PermuteObjects,
        /// All lights together give what each gives alone, added up.
        SumOfLights,
        /// More exposure makes all brighter alike.
        Exposure,
        /// A window of the view shows those very pixels.
        Crop,
    }
    without {
        /// An object in a group that does nothing to it looks the same.
        IdentityGroup in identity_group,
        /// The number of threads does not matter.
        Threads in threads,
        /// The accelerator does not matter.
        NoAccelerator in no_accelerator,
        /// What is skipped does not matter.
        NoSkipping in no_skipping,
    }
}

impl Relation {
    /// What makes no sense in it for this scene, by field where there is one.
    pub(crate) fn problems(&self, file: &File) -> Vec<Problem> {
        let relation = self.inner();
        let mut problems = relation.alike().problems(file.image);
        problems.extend(relation.problems(file));
        let named = |(field, why)| (field, format!("{}: {why}", self.name()));
        problems.into_iter().map(named).collect()
    }

    /// Whether the picture, the fixture's own of today, is as the related scene
    /// says.
    ///
    /// # Errors
    /// The relation and what was expected and found, in one sentence.
    pub fn check(&self, fixture: &Fixture, picture: &LinearImage) -> Result<(), Broken> {
        let relation = self.inner();
        let held = relation.holds(&Today { fixture, picture });
        held.map_err(|broken| broken.map(|why| format!("{}: {why}", self.said())))
    }

    /// How what [`Relation::check`] says of it begins.
    pub(crate) fn said(&self) -> String {
        format!("relation {}", self.inner().words())
    }
}

/// The relations of its fixture that the picture breaks, in words. Each of them
/// renders.
pub fn broken(fixture: &Fixture, picture: &Rendered) -> Vec<String> {
    let check = |relation: &Relation| relation.check(fixture, &picture.linear).err();
    fixture.check.relations.iter().filter_map(check).map(|broken| broken.to_string()).collect()
}

/// A number as it would be written in a fixture.
fn shown(x: f64) -> String {
    format!("{x:?}").trim_end_matches(".0").to_owned()
}

/// A problem of the whole relation where `is_wrong`.
fn problem_if(is_wrong: bool, why: &str) -> Vec<Problem> {
    if is_wrong { vec![(None, why.to_owned())] } else { Vec::new() }
}

/// A problem of one field where `is_wrong`.
fn problem_in(field: &'static str, is_wrong: bool, why: impl FnOnce() -> String) -> Vec<Problem> {
    if is_wrong { vec![(Some(field), format!("`{field}`: {}", why()))] } else { Vec::new() }
}

/// A problem of a factor that changes next to nothing, or so much that digits are
/// lost.
fn problem_of_factor(by: f64) -> Vec<Problem> {
    const RANGE: std::ops::RangeInclusive<f64> = 1e-6..=1e6;
    const LEAST: f64 = 0.01;
    let is_factor = RANGE.contains(&by) && (by - 1.0).abs() >= LEAST;
    problem_in("by", !is_factor, || {
        format!(
            "expected a number from {:e} to {:e} that is not 1, but for {LEAST} or more, found {by}",
            RANGE.start(),
            RANGE.end()
        )
    })
}

/// A problem where samples follow the picture, so that another scene has others.
fn problem_of_error(file: &File) -> Vec<Problem> {
    problem_if(
        file.error.is_some(),
        "expected a scene without `error`, as other pictures have other samples",
    )
}

#[cfg(test)]
mod tests;
