//! What is asked of the torus.

use std::f64::consts::TAU;

use tracer::glam::DVec3;
use tracer::shape::{Geometry, Torus};
use tracer::{Interval, Ray};

use super::closest::{self, towards};
use super::textbook_torus::first_hit as textbook;
use crate::family::{Family, Kernel, Volume};
use crate::truth::UNIT_ROUNDOFF;
use crate::truth::distance;
use crate::truth::torus::{self, TorusTruth};
use crate::{Case, Metric, Random, Tally};

/// Where a case has its ray: after the center, the axis and the two radii.
pub(super) const RAY_AT: usize = 8;

/// How many cases: the oracle takes some microseconds for one.
const VOLUME: Volume = Volume { quick: 32_768, full: 2_000_000 };

/// The largest distance of a hit from the surface, in major radii.
const POSITION_ERROR: f64 = 1e-14;

/// A torus and how to draw points about it.
#[derive(Clone, Copy)]
struct Drawn {
    center: DVec3,
    axis: DVec3,
    /// Across the axis.
    x: DVec3,
    y: DVec3,
    major: f64,
    minor: f64,
}

/// Thin, plain, fat and horn.
const TUBES: [f64; 6] = [1e-3, 0.05, 0.25, 0.6, 0.99, 1.0];

impl Drawn {
    fn new(random: &mut Random, tube: f64) -> Self {
        let major = random.decades(0.25, 4.0);
        let unit = random.direction();
        let x = random.across(unit);
        let (center, axis) = (random.point() * (4.0 * major), unit * random.decades(0.1, 10.0));
        Self { center, axis, x, y: unit.cross(x), major, minor: major * tube }
    }

    fn any(random: &mut Random) -> Self {
        let tube = random.one_of(&TUBES);
        Self::new(random, tube)
    }

    fn unit(&self) -> DVec3 {
        self.x.cross(self.y)
    }

    /// Outward from the axis, at this angle around.
    fn around(&self, angle: f64) -> DVec3 {
        libm::cos(angle) * self.x + libm::sin(angle) * self.y
    }

    /// At this angle around, this angle about the tube (0 is the outer rim, a
    /// half turn the inner), and this part of the minor radius from its middle.
    fn at(&self, around: f64, about: f64, part: f64) -> DVec3 {
        let out = self.around(around);
        self.center + out * self.major + self.normal(around, about) * (self.minor * part)
    }

    fn normal(&self, around: f64, about: f64) -> DVec3 {
        libm::cos(about) * self.around(around) + libm::sin(about) * self.unit()
    }

    fn case(&self, (origin, direction): (DVec3, DVec3)) -> Case {
        let torus = Case::EMPTY.with_point(self.center).with_point(self.axis);
        torus.with(self.major).with(self.minor).with_ray(&Ray::new(origin, direction))
    }

    /// A ray at `target` from so many major radii away.
    fn aimed(&self, random: &mut Random, target: DVec3, way: DVec3, radii: (f64, f64)) -> Case {
        let from = self.major * random.decades(radii.0, radii.1);
        self.case(towards(target, way, from, random.decades(0.1, 10.0)))
    }

    /// A ray that touches the tube but for a small part of the minor radius,
    /// at this angle about the tube.
    fn touching(&self, random: &mut Random, about: f64) -> Case {
        let around = random.between(0.0, TAU);
        // As near as the tie class lets it be, also on a thin tube.
        let least = 4.0 * torus::TIE * self.major / self.minor;
        let part = 1.0 + random.sign() * random.decades(least, 1e-1);
        let (touch, normal) = (self.at(around, about, part), self.normal(around, about));
        let way = random.across(normal);
        self.aimed(random, touch, way, (1e-1, 1e5))
    }
}

/// All its families.
pub(super) fn families() -> Vec<Family> {
    let about = |tube: Option<f64>, radii: (f64, f64)| {
        move |random: &mut Random| {
            let drawn = match tube {
                Some(tube) => Drawn::new(random, tube),
                None => Drawn::any(random),
            };
            let (around, about) = (random.between(0.0, TAU), random.between(0.0, TAU));
            let part = random.between(0.0, 1.2);
            let target = drawn.at(around, about, part);
            let way = random.direction();
            drawn.aimed(random, target, way, radii)
        }
    };
    let touching = |name, about: fn(&mut Random) -> f64| {
        let generate = move |random: &mut Random| {
            let about = about(random);
            Drawn::any(random).touching(random, about)
        };
        // Within 1e-14 of the surface is a tie, and these come that near.
        family(name, true, generate).with_ties(5000.0)
    };
    vec![
        family("random", true, about(None, (1.0, 1e2))),
        family("distance", true, about(None, (1.0, 1e5))),
        // Where `t` itself has no digits for this.
        family("distance-1e8", false, about(None, (1e5, 1e8))),
        family("thin", true, about(Some(1e-3), (1.0, 1e5))),
        family("fat", true, about(Some(0.99), (1.0, 1e5))),
        family("horn", true, about(Some(1.0), (1.0, 1e5))),
        touching("inner-rim", |_| TAU / 2.0),
        touching("outer-rim", |_| 0.0),
        touching("grazing", |random| random.between(0.0, TAU)),
        // The circle on which a plane lies upon the torus.
        touching("crown", |_| TAU / 4.0),
        family("in-plane", true, |random| {
            let drawn = Drawn::any(random);
            let (around, way) = (random.between(0.0, TAU), random.between(0.0, TAU));
            let target =
                drawn.center + drawn.around(around) * (drawn.major * random.between(0.0, 2.0));
            let way = drawn.around(way);
            drawn.aimed(random, target, way, (1e-2, 1e5))
        }),
        family("hole", true, |random| {
            let drawn = Drawn::any(random);
            let tilt = drawn.around(random.between(0.0, TAU)) * random.decades(1e-9, 1.0);
            let way = (drawn.unit() * random.sign() + tilt).normalize();
            let off = drawn.around(random.between(0.0, TAU));
            let hole = (drawn.major - drawn.minor).max(0.01 * drawn.minor);
            let target = drawn.center + off * (hole * random.decades(1e-9, 1.5));
            drawn.aimed(random, target, way, (1e-2, 1e5))
        }),
        family("inside", true, |random| {
            let drawn = Drawn::any(random);
            let (around, about) = (random.between(0.0, TAU), random.between(0.0, TAU));
            let origin = drawn.at(around, about, random.between(0.0, 0.99));
            drawn.case((origin, random.direction() * random.decades(0.1, 10.0)))
        }),
        family("near-surface", true, |random| {
            let drawn = Drawn::any(random);
            let (around, about) = (random.between(0.0, TAU), random.between(0.0, TAU));
            let part = 1.0 + random.sign() * random.decades(1e-10, 1e-1);
            let origin = drawn.at(around, about, part);
            drawn.case((origin, random.direction() * random.decades(0.1, 10.0)))
        }),
        family("tiny-to-huge", true, |random| {
            let mut drawn = Drawn::any(random);
            let scale = random.decades(1e-12, 1e12);
            drawn.center *= scale;
            drawn.major *= scale;
            drawn.minor *= scale;
            let target = drawn.at(random.between(0.0, TAU), random.between(0.0, TAU), 0.7);
            let way = random.direction();
            drawn.aimed(random, target, way, (1.0, 1e4))
        }),
        special(),
    ]
}

fn family(
    name: &'static str,
    held: bool,
    generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
) -> Family {
    let none = Some(0.0);
    Family {
        primitive: "torus",
        name: name.to_owned(),
        kernels: vec![Kernel::GOLDRAY, Kernel::textbook("quartic-f64")],
        targets: vec![
            (Metric::FalseMisses, none.filter(|_| held)),
            (Metric::FalseHits, none.filter(|_| held)),
            (Metric::WrongIdentity, none.filter(|_| held)),
            (Metric::NotFinite, none),
            (Metric::PositionError, Some(POSITION_ERROR).filter(|_| held)),
        ],
        volume: VOLUME,
        generate: Box::new(generate),
        judge: Box::new(|case, tallies| {
            let truth = exact(case).hits(&case.ray(RAY_AT));
            for (answer, tally) in [contact(case), textbook(case)].into_iter().zip(tallies) {
                judge(&truth, answer, tally);
            }
        }),
    }
}

/// The torus of a case, for the oracle.
fn exact(case: &Case) -> torus::Torus {
    let (major_radius, minor_radius) = (case.number(6), case.number(7));
    torus::Torus { center: case.point(0), axis: case.point(3), major_radius, minor_radius }
}

/// The tracer's first `t` above 0.
fn contact(case: &Case) -> Option<f64> {
    let shape = Torus::new(case.point(0), case.point(3), case.number(6), case.number(7)).ok()?;
    shape.intersect(&case.ray(RAY_AT), Interval::AHEAD).map(|contact| contact.t)
}

/// Holds one answer against the exact roots.
fn judge(truth: &TorusTruth, answer: Option<f64>, tally: &mut Tally) {
    if !closest::is_decided(truth.tie, answer, tally) {
        return;
    }
    match (truth.roots.split_first(), answer) {
        (None, None) => {}
        (Some(_), None) => tally.count(Metric::FalseMisses),
        (None, Some(_)) => tally.count(Metric::FalseHits),
        (Some((&first, others)), Some(t)) => {
            let error = distance(t, first);
            if others.iter().any(|&other| distance(t, other) < error) {
                tally.count(Metric::WrongIdentity);
                return;
            }
            // From far away the nearest `f64` to `t` is farther off than the
            // target; its rounding is always allowed for.
            let beyond = (error - UNIT_ROUNDOFF * first.0.abs()).max(0.0);
            tally.most(Metric::PositionError, beyond * truth.rate);
        }
    }
}

fn special() -> Family {
    let answers: Vec<closest::Answer> =
        vec![(Kernel::GOLDRAY, contact), (Kernel::textbook("quartic-f64"), textbook)];
    let volume = Volume { quick: 200_000, full: 2_000_000 };
    closest::special("torus", answers, RAY_AT, volume, |random| {
        let drawn = Drawn::any(random);
        let target = drawn.at(random.between(0.0, TAU), random.between(0.0, TAU), 0.5);
        let way = random.direction();
        drawn.aimed(random, target, way, (0.1, 1e2))
    })
}
