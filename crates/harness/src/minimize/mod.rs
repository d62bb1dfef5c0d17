//! `minimize`: a failing fixture made smaller while it still fails.
//!
//! Less of a scene needs another picture, of which there is no golden. So what
//! fails must be something that can be asked of any scene: a relation that the
//! renderer breaks, or that its picture is not the one that another renderer
//! makes of the same scene.

mod less;
mod simpler;

use tracer::LinearImage;

use crate::called::command;
use crate::check::{Check, File};
use crate::encode::EncodedImage;
use crate::fixture::Fixture;
use crate::limits::Limits;
use crate::metric::compare;
use crate::relation::Relation;
use crate::report::numbers;
use crate::suite::Suite;

/// How a renderer that is right makes a picture of a fixture's text.
pub type Reference<'a> = dyn Fn(&str) -> Result<EncodedImage, String> + 'a;

/// What a scene is held against.
pub enum Failure<'a> {
    /// Itself, by a relation that its picture breaks.
    Relation(Relation),
    /// The picture of another renderer, from which it must not be farther than
    /// the fixture's limits allow.
    Reference(&'a Reference<'a>),
}

/// A failing scene that nothing can be taken from.
#[derive(Debug, Clone, PartialEq)]
pub struct Smallest {
    /// What is left.
    pub file: File,
    /// How it fails.
    pub why: String,
    /// What the other renderer makes of it, if it is held against one.
    pub expected: Option<EncodedImage>,
    /// How many scenes were rendered on the way.
    pub tries: u32,
}

impl Smallest {
    /// A fixture of it, made of the one called `name`.
    ///
    /// # Errors
    /// A file that cannot be written as text.
    pub fn text(&self, name: &str) -> Result<String, String> {
        let scene = scene::write(&self.file)?;
        Ok(format!(
            "// What is left of {} by `{} minimize` while it fails:\n// {}\n{scene}",
            Suite::fixture_label(name),
            command(),
            self.why
        ))
    }
}

/// The most scenes that are tried: far more than any fixture of a few hundred
/// objects needs.
const MOST_TRIES: u32 = 5_000;

impl Failure<'_> {
    /// The relation that a fixture breaks: the first of its own, else the first
    /// of those that can be asked of any scene; `None` if it keeps them all.
    /// `on_relation` hears of each before it is asked.
    pub fn of(fixture: &Fixture, on_relation: &dyn Fn(&str)) -> Option<Self> {
        let own = fixture.check.relations.iter();
        let all = own.chain(&[
            Relation::NoAccelerator,
            Relation::NoSkipping,
            Relation::Threads,
            Relation::IdentityGroup,
        ]);
        let picture = fixture.render_linear();
        let is_asked = |relation: &&Relation| relation.problems(&fixture.file).is_empty();
        let mut broken = all.filter(is_asked).filter(|relation| {
            on_relation(relation.name());
            differs(relation, fixture, &picture).is_some()
        });
        broken.next().cloned().map(Failure::Relation)
    }

    /// How a scene fails; `None` where it does not, or is none.
    fn why(&self, fixture: &Fixture, file: &File) -> Option<String> {
        let pixels = u64::from(file.image.0) * u64::from(file.image.1);
        let limits = fixture.check.limits.as_ref();
        if limits.is_some_and(|limits| !limits.problems(pixels).is_empty()) {
            return None;
        }
        let now = fixture.with_file(file.clone()).ok()?;
        let picture = now.render().ok()?;
        match self {
            Self::Relation(relation) if relation.problems(file).is_empty() => {
                differs(relation, &now, &picture.linear)
            }
            Self::Relation(_) => None,
            Self::Reference(render) => {
                let expected = render(&scene::write(file).ok()?).ok()?;
                let comparison = compare(&expected, &picture.encoded)?;
                let broken = Limits::broken_by(limits, &comparison);
                let words = || format!("{}; {}", broken.join("; "), numbers(&comparison));
                (!broken.is_empty()).then(words)
            }
        }
    }

    /// What a smaller fixture is held to: nothing that is only known of the
    /// whole.
    fn check(&self, whole: &Check) -> Check {
        let relations = match self {
            Self::Relation(relation) => vec![relation.clone()],
            Self::Reference(_) => Vec::new(),
        };
        Check { limits: whole.limits.clone(), relations, ..Check::default() }
    }
}

/// How a picture is known to break a relation.
fn differs(relation: &Relation, fixture: &Fixture, picture: &LinearImage) -> Option<String> {
    let broken = relation.check(fixture, picture).err()?;
    broken.differs().then(|| broken.to_string())
}

/// The smallest scene that fails as the fixture does; `None` if it does not fail.
/// `on_try` hears of each scene that is tried: how many objects and pixels are
/// left.
///
/// # Errors
/// Why the other renderer makes no picture of the fixture.
pub fn minimize(
    fixture: &Fixture,
    failure: &Failure<'_>,
    on_try: &dyn Fn(usize, u64),
) -> Result<Option<Smallest>, String> {
    let mut file = fixture.file.clone();
    file.check = None;
    if let Failure::Reference(render) = failure {
        render(&scene::write(&file)?)?;
    }
    let Some(why) = failure.why(fixture, &file) else { return Ok(None) };
    let mut search = Search { fixture, failure, on_try, best: file, why, tries: 0 };
    loop {
        let before = search.best.clone();
        // Objects before pixels: of one pixel all that it shows may be needed.
        less::objects(&mut search);
        less::lights(&mut search);
        less::materials(&mut search);
        simpler::settings(&mut search);
        simpler::picture(&mut search);
        if search.best == before || search.tries >= MOST_TRIES {
            break;
        }
    }
    let Search { best, why, tries, .. } = search;
    let expected = match failure {
        Failure::Relation(_) => None,
        Failure::Reference(render) => scene::write(&best).and_then(|text| render(&text)).ok(),
    };
    let check = Some(failure.check(&fixture.check)).filter(|check| *check != Check::default());
    let file = File { check, ..best };
    Ok(Some(Smallest { file, why, expected, tries }))
}

/// The way to a smaller scene.
struct Search<'a> {
    fixture: &'a Fixture,
    failure: &'a Failure<'a>,
    on_try: &'a dyn Fn(usize, u64),
    /// The smallest so far that fails, and how.
    best: File,
    why: String,
    tries: u32,
}

impl Search<'_> {
    /// Takes a scene for the best one if it fails.
    fn take(&mut self, smaller: File) -> bool {
        if smaller == self.best || self.tries >= MOST_TRIES {
            return false;
        }
        self.tries += 1;
        let (width, height) = smaller.image;
        (self.on_try)(less::count(&smaller.objects), u64::from(width) * u64::from(height));
        let Some(why) = self.failure.why(self.fixture, &smaller) else { return false };
        (self.best, self.why) = (smaller, why);
        true
    }

    /// [`Search::take`] of the best one after a change.
    fn take_with(&mut self, change: impl FnOnce(&mut File)) -> bool {
        let mut smaller = self.best.clone();
        change(&mut smaller);
        self.take(smaller)
    }
}

#[cfg(test)]
mod tests;
