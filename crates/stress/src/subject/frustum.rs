//! What cylinders and cones are asked alike: families of rays at a round body
//! with a straight axis, and the kernels' common form.

use std::f64::consts::TAU;

use tracer::Ray;
use tracer::glam::DVec3;

use super::closest::{self, Inputs, Subject, towards};
use super::textbook_frustum;
use crate::family::{Family, Kernel, Volume};
use crate::random::{f32_of, f32_point};
use crate::truth::Truth;
use crate::truth::frustum::{Frustum, FrustumTruth};
use crate::{Case, Metric, Random};

/// Where a case has its ray: after the two ends, the radius and whether there
/// are caps.
pub(super) const RAY_AT: usize = 8;

/// The tracer's answer: the contact's `t` and part.
pub(super) type Contact = Option<(f64, u32)>;

/// One of the two primitives.
#[derive(Clone, Copy)]
pub(super) struct Body {
    pub(super) primitive: &'static str,
    /// The exact form of a case.
    pub(super) exact: fn(&Case) -> Frustum,
    /// The tracer's first contact beyond this `t`.
    pub(super) contact: fn(&Case, f64) -> Contact,
    /// The tracer's number of the cap at the second end.
    pub(super) far_cap: u32,
    /// What rays are aimed at from outside and inside: the end of the axis at
    /// which the surface is a point or, without one, a disk's center.
    pub(super) tip: &'static str,
}

/// A body and how to draw points about it.
#[derive(Clone, Copy)]
struct Drawn {
    a: DVec3,
    b: DVec3,
    radius: f64,
    /// The radius at `a`, over that at `b`.
    narrowing: f64,
}

/// Sizes of the bodies of a family; lengths log-uniform between the ends.
#[derive(Clone, Copy)]
struct Sizes {
    radius: (f64, f64),
    /// The length over the radius.
    aspect: (f64, f64),
    /// How far from the world's origin, over the radius.
    world: f64,
}

/// Bodies about as long as wide.
const PLAIN: Sizes = Sizes { radius: (0.25, 4.0), aspect: (0.5, 8.0), world: 4.0 };
/// Needles, plates, and far from the origin.
const UNEVEN: Sizes = Sizes { radius: (0.25, 4.0), aspect: (1e-3, 1e3), world: 1e3 };
/// From the size of atoms to that of planets, in meters and about the origin.
const TINY_TO_HUGE: Sizes = Sizes { radius: (1e-12, 1e12), aspect: (0.5, 8.0), world: 4.0 };

/// How many cases: the oracle takes some microseconds for one.
const VOLUME: Volume = Volume { quick: 50_000, full: 2_000_000 };

/// The largest error held to: 8 times what one rounding of the inputs may do.
const DOUBLE: Inputs = Inputs::Double { condition_error: 8.0 };

impl Drawn {
    fn new(random: &mut Random, body: Body, sizes: Sizes) -> Self {
        let radius = random.decades(sizes.radius.0, sizes.radius.1);
        let length = radius * random.decades(sizes.aspect.0, sizes.aspect.1);
        let a = random.point() * (radius * sizes.world);
        let narrowing = if body.is_cone() { 0.0 } else { 1.0 };
        Self { a, b: a + random.direction() * length, radius, narrowing }
    }

    fn axis(&self) -> DVec3 {
        self.b - self.a
    }

    /// A point at this part of the way from `a` to `b` and this part of the
    /// radius there from the axis.
    fn at(&self, random: &mut Random, s: f64, part: f64) -> DVec3 {
        let radius = self.radius * (self.narrowing + (1.0 - self.narrowing) * s);
        self.a + s * self.axis() + (part * radius) * random.across(self.axis())
    }

    fn inside(&self, random: &mut Random) -> DVec3 {
        let (s, part) = (random.between(0.05, 0.95), random.between(0.0, 0.95));
        self.at(random, s, part)
    }

    /// On the rim of an end.
    fn rim(&self, random: &mut Random) -> DVec3 {
        let s = if self.narrowing > 0.0 && random.coin() { 0.0 } else { 1.0 };
        self.at(random, s, 1.0)
    }

    /// A hair from a rim: along the side, or along the end's disk.
    fn near_rim(&self, random: &mut Random) -> DVec3 {
        let end = if self.narrowing > 0.0 && random.coin() { 0.0 } else { 1.0 };
        let off = random.sign() * random.decades(1e-13, 1e-1);
        if random.coin() {
            self.at(random, end + off, 1.0)
        } else {
            self.at(random, end, 1.0 + off)
        }
    }

    fn case(&self, caps: bool, (origin, direction): (DVec3, DVec3)) -> Case {
        let caps = f64::from(u8::from(caps));
        let body = Case::EMPTY.with_point(self.a).with_point(self.b).with(self.radius);
        body.with(caps).with_ray(&Ray::new(origin, direction))
    }

    /// The same with every number an `f32`.
    fn single(&self, caps: bool, (origin, direction): (DVec3, DVec3)) -> Case {
        let (a, b) = (f32_point(self.a), f32_point(self.b));
        let radius = f32_of(self.radius);
        Self { a, b, radius, ..*self }.case(caps, (f32_point(origin), f32_point(direction)))
    }

    /// A ray at `target` from so many radii away.
    fn aimed(&self, random: &mut Random, target: DVec3, radii: (f64, f64)) -> (DVec3, DVec3) {
        let distance = self.radius * random.decades(radii.0, radii.1);
        towards(target, random.direction(), distance, random.decades(0.1, 10.0))
    }
}

impl Body {
    fn is_cone(self) -> bool {
        self.tip == "apex"
    }

    /// All families, closed and open.
    pub(super) fn families(self) -> Vec<Family> {
        let mut families: Vec<_> =
            [true, false].into_iter().flat_map(|caps| self.each(caps)).collect();
        families.extend([true, false].map(|at_tip| self.leaks(at_tip)));
        families.push(self.special());
        families
    }

    fn each(self, caps: bool) -> Vec<Family> {
        let single =
            self.family(caps, "random-f32", Inputs::Single { ulp32: 0.5 }, move |random| {
                let drawn = Drawn::new(random, self, PLAIN);
                let (s, part) = (random.between(-0.2, 1.2), random.between(0.0, 1.2));
                let target = drawn.at(random, s, part);
                let ray = drawn.aimed(random, target, (2.0, 1e8));
                drawn.single(caps, ray)
            });
        let about = |name, sizes, radii| {
            self.family(caps, name, DOUBLE, move |random| {
                let drawn = Drawn::new(random, self, sizes);
                let (s, part) = (random.between(-0.2, 1.2), random.between(0.0, 1.2));
                let target = drawn.at(random, s, part);
                let ray = drawn.aimed(random, target, radii);
                drawn.case(caps, ray)
            })
        };
        // Into or out of the body there: past it would be a tie.
        let aimed = |name, target: fn(&mut Random, &Drawn) -> DVec3, radii: (f64, f64)| {
            self.family(caps, name, DOUBLE, move |random| {
                let sizes = random.one_of(&[PLAIN, UNEVEN]);
                let drawn = Drawn::new(random, self, sizes);
                let target = target(random, &drawn);
                let way = (drawn.inside(random) - target).normalize() * random.sign();
                let distance = drawn.radius * random.decades(radii.0, radii.1);
                drawn.case(caps, towards(target, way, distance, random.decades(0.1, 10.0)))
            })
        };
        let mut families = vec![
            single,
            about("random", PLAIN, (2.0, 1e2)),
            about("distance", PLAIN, (1.0, 1e8)),
            about("uneven", UNEVEN, (1.0, 1e4)),
            about("tiny-to-huge", TINY_TO_HUGE, (1.0, 1e4)),
            aimed(self.tip, |_, drawn| drawn.a, (1e-3, 1e6)),
            // An open body's rim is itself a place of ties.
            aimed("near-rim", |random, drawn| drawn.near_rim(random), (1e-3, 1e3))
                .with_ties(if caps { 1000.0 } else { 150_000.0 }),
            self.family(caps, "axis-parallel", DOUBLE, move |r| self.axis_parallel(r, caps, true)),
            self.family(caps, "axis-nearly", DOUBLE, move |r| self.axis_parallel(r, caps, false)),
            self.family(caps, "across-axis", DOUBLE, move |r| self.across_axis(r, caps, true)),
            // Those that pass beyond an end are not told from rays that meet
            // its plane far away.
            self.family(caps, "nearly-across", DOUBLE, move |r| self.across_axis(r, caps, false))
                .with_ties(if caps { 150_000.0 } else { 1000.0 }),
            self.family(caps, "grazing", DOUBLE, move |random| {
                let angle = random.between(0.0, TAU);
                self.grazing(random, caps, angle)
            }),
            // Along a line of the side: tangent all along it, or nearly.
            self.family(caps, "along-side", DOUBLE, move |random| {
                let angle = random.sign() * TAU / 4.0 + random.sign() * random.decades(1e-9, 1.0);
                self.grazing(random, caps, angle)
            })
            .with_ties(if caps { 1000.0 } else { 60_000.0 }),
            self.family(caps, "inside", DOUBLE, move |random| {
                let sizes = random.one_of(&[PLAIN, UNEVEN, TINY_TO_HUGE]);
                let drawn = Drawn::new(random, self, sizes);
                let origin = drawn.inside(random);
                drawn.case(caps, (origin, random.direction() * random.decades(1e-3, 1e3)))
            }),
            self.family(caps, "near-surface", DOUBLE, move |r| self.near_surface(r, caps)),
        ];
        if caps {
            // Of an open body, nearly every such ray would be a tie.
            families.push(aimed("rim", |random, drawn| drawn.rim(random), (1e-3, 1e6)));
        }
        families
    }

    /// A ray along the axis: exactly, where `b - a` is a number, or but for a
    /// small angle.
    fn axis_parallel(self, random: &mut Random, caps: bool, exact: bool) -> Case {
        let mut drawn = Drawn::new(random, self, PLAIN);
        let origin_s = random.one_of(&[-0.5, -4.0, -1e3, -1e6, 0.5, 1.5]);
        let part = random.between(0.0, 1.25);
        let mut direction = random.sign() * drawn.axis();
        if exact {
            // Of few digits, so that the difference of the ends is exact.
            (drawn.a, drawn.b) = (f32_point(drawn.a), f32_point(drawn.b));
            direction = drawn.axis() * random.sign() * random.one_of(&[1.0, 0.25, 64.0]);
        } else {
            direction +=
                random.across(direction) * direction.length() * random.decades(1e-17, 1e-2);
        }
        // The cone's radius is meant at the middle, and origins lie ahead or
        // behind of that.
        let side = drawn.at(random, 0.5, part) - 0.5 * drawn.axis();
        drawn.case(caps, (side + origin_s * drawn.axis(), direction))
    }

    /// A ray across the axis, which meets no end plane, or one of them very far
    /// away.
    fn across_axis(self, random: &mut Random, caps: bool, exact: bool) -> Case {
        let mut drawn = Drawn::new(random, self, PLAIN);
        let along = random.below(3);
        // Along an axis of space and of few digits, so that "across" is exact.
        drawn.a = f32_point(drawn.a);
        let length = f32_of(drawn.axis().length()) * random.sign();
        drawn.b = drawn.a;
        drawn.b[along] += length;
        let (s, part) = (random.between(-0.2, 1.2), random.between(0.0, 1.2));
        let target = drawn.at(random, s, part);
        let mut way = random.across(drawn.axis());
        way[along] = if exact { 0.0 } else { random.sign() * random.decades(1e-17, 1e-9) };
        let distance = drawn.radius * random.decades(2.0, 1e4);
        drawn.case(caps, towards(target, way, distance, random.decades(0.1, 10.0)))
    }

    /// A ray that passes the side closest at a point just in or outside it, at
    /// this angle in the tangent plane, where a quarter turn is along the side.
    fn grazing(self, random: &mut Random, caps: bool, angle: f64) -> Case {
        let drawn = Drawn::new(random, self, PLAIN);
        let length = drawn.axis().length();
        let (unit, s) = (drawn.axis() / length, random.between(-0.05, 1.05));
        let out = random.across(drawn.axis());
        let slope = (1.0 - drawn.narrowing) * drawn.radius / length;
        // As near as the rounding of the ray lets it be no tie, mostly.
        let radii = random.decades(1e-1, 1e6);
        let off = random.sign() * random.decades(4e-15 * (radii + 16.0), 1e-1);
        let radius = drawn.radius * (drawn.narrowing + (1.0 - drawn.narrowing) * s);
        let touch = drawn.a + s * drawn.axis() + out * (radius + drawn.radius * off);
        // In the tangent plane: across, and along the side's line.
        let line = (unit + slope * out).normalize();
        let way = libm::cos(angle) * unit.cross(out) + libm::sin(angle) * line;
        drawn.case(caps, towards(touch, way, drawn.radius * radii, random.decades(0.1, 10.0)))
    }

    /// A ray from just in or outside the surface.
    fn near_surface(self, random: &mut Random, caps: bool) -> Case {
        let drawn = Drawn::new(random, self, PLAIN);
        let off = random.sign() * random.decades(1e-12, 1e-1);
        // An end's disk, or the side.
        let (s, part) = if random.below(3) == 0 {
            (1.0 + off, random.between(0.0, 1.0))
        } else {
            (random.between(0.01, 1.0), 1.0 + off)
        };
        let origin = drawn.at(random, s, part);
        drawn.case(caps, (origin, random.direction() * random.decades(0.1, 10.0)))
    }

    fn family(
        self,
        caps: bool,
        name: &str,
        inputs: Inputs,
        generate: impl Fn(&mut Random) -> Case + Send + Sync + 'static,
    ) -> Family {
        let name = format!("{}{name}", if caps { "" } else { "open-" });
        let mut answers = vec![(Kernel::GOLDRAY, Self::none as fn(&Case) -> Option<f64>)];
        answers.extend(self.textbooks());
        let subject = Subject { primitive: self.primitive, truth: |_| Truth::MISS, answers };
        let textbooks = self.textbooks();
        let mut family = subject.family(name, inputs, VOLUME, generate);
        family.targets.push((Metric::WrongIdentity, Some(0.0)));
        family.judge = Box::new(move |case, tallies| {
            let FrustumTruth { truth, part } = (self.exact)(case).first_hit(&case.ray(RAY_AT));
            let contact = (self.contact)(case, 0.0);
            let expected = part.map(|part| if part == 2 { self.far_cap } else { part });
            let others = textbooks.iter().map(|(_, answer)| answer(case));
            let all = std::iter::once(contact.map(|(t, _)| t)).chain(others);
            for (answer, tally) in all.zip(tallies.iter_mut()) {
                closest::judge(&truth, answer, tally);
            }
            if let (Some((_, part)), Some(expected), [tally, ..]) = (contact, expected, tallies)
                && part != expected
            {
                tally.count(Metric::WrongIdentity);
            }
        });
        family
    }

    /// Stands in a list whose judge is replaced.
    fn none(_: &Case) -> Option<f64> {
        None
    }

    fn textbooks(self) -> [closest::Answer; 2] {
        let [double, single] =
            if self.is_cone() { textbook_frustum::CONE } else { textbook_frustum::CYLINDER };
        [(Kernel::textbook("quadratic-f64"), double), (Kernel::textbook("quadratic-f32"), single)]
    }

    /// From inside a closed body at its rim or its tip: out exactly once.
    fn leaks(self, at_tip: bool) -> Family {
        let target = if at_tip { self.tip } else { "rim" };
        Family {
            primitive: self.primitive,
            name: format!("leaks-{target}"),
            kernels: vec![Kernel::GOLDRAY],
            targets: [Metric::Leaks, Metric::DoubleHits, Metric::NotFinite]
                .map(|metric| (metric, Some(0.0)))
                .to_vec(),
            // Without an oracle.
            volume: Volume { quick: 200_000, full: 2_000_000 },
            generate: Box::new(move |random| {
                let sizes = random.one_of(&[PLAIN, UNEVEN, TINY_TO_HUGE]);
                let drawn = Drawn::new(random, self, sizes);
                let origin = drawn.inside(random);
                let target = if at_tip { drawn.a } else { drawn.rim(random) };
                let direction = (target - origin) * random.decades(1e-2, 1e2);
                drawn.case(true, (origin, direction))
            }),
            judge: Box::new(move |case, tallies| {
                for tally in tallies {
                    tally.case();
                    match (self.contact)(case, 0.0) {
                        None => tally.count(Metric::Leaks),
                        Some((t, _)) if !t.is_finite() => tally.count(Metric::NotFinite),
                        Some((t, _)) => {
                            if (self.contact)(case, t).is_some() {
                                tally.count(Metric::DoubleHits);
                            }
                        }
                    }
                }
            }),
        }
    }

    fn special(self) -> Family {
        let contact: fn(&Case) -> Option<f64> = if self.is_cone() {
            |case| super::cone::contact(case, 0.0).map(|(t, _)| t)
        } else {
            |case| super::cylinder::contact(case, 0.0).map(|(t, _)| t)
        };
        let mut answers = vec![(Kernel::GOLDRAY, contact)];
        answers.extend(self.textbooks());
        let volume = Volume { quick: 200_000, full: 2_000_000 };
        closest::special(self.primitive, answers, RAY_AT, volume, move |random| {
            let drawn = Drawn::new(random, self, PLAIN);
            let target = drawn.at(random, 0.5, 0.5);
            let ray = drawn.aimed(random, target, (0.1, 1e2));
            drawn.case(random.coin(), ray)
        })
    }
}
