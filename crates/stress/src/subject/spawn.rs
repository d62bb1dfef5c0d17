//! Rays that leave a surface: they must not meet it again at once, must find
//! the far side of what they enter, and start close to where they should.
//!
//! Every object but the torus is flat or convex, so that a ray that leaves it
//! outward meets nothing; of a torus the number of crossings is even then.

use std::f64::consts::TAU;
use std::sync::{Arc, LazyLock};

use tracer::accel::Build;
use tracer::glam::DVec3;
use tracer::shape::{Mesh, Shape};
use tracer::{Group, Hit, Interval, Material, Member, Ray};

use self::object::{NUMBERS, Object};
use self::style::{STYLES, Style};
use super::chain::{Chain, Exact};
use super::closest::is_shown;
use crate::family::{Family, Kernel, Volume};
use crate::meshes::{Place, Solid};
use crate::number::{Dd, V3};
use crate::truth::UNIT_ROUNDOFF;
use crate::{Case, Metric, Random, Tally};

mod creases;
mod object;
mod slivers;
mod style;

/// Every family of spawned rays.
pub(super) fn families() -> Vec<Family> {
    // The way inside is badly conditioned where coordinates are of all sizes.
    let ties = |style: &Style| if style.any_coordinates { 5000.0 } else { 1000.0 };
    let mut families: Vec<_> =
        STYLES.iter().map(|style| family(*style).with_ties(ties(style))).collect();
    families.extend(creases::families());
    families.extend(slivers::families());
    families
}

/// 1e9 rays over all families.
const VOLUME: Volume = Volume { quick: 50_000, full: 1_000_000_000 / STYLES.len() as u64 + 1 };

/// Where a case has what follows its object: the ray that finds the surface,
/// the signed cosine and the azimuth of the ray that leaves it, whether that
/// one is aimed at a point, the seed of the transforms, and the object's size.
const RAY: usize = NUMBERS;
const COSINE: usize = RAY + 6;
const AZIMUTH: usize = COSINE + 1;
const TO_POINT: usize = COSINE + 2;
const SEED: usize = COSINE + 3;
const SIZE: usize = COSINE + 4;

/// How many times more than one rounding of its inputs may decide a tie.
const TIE: f64 = 8.0;
/// How wrong the way through an object may be.
const CHORD: f64 = 1e-2;

/// A ball of 80 triangles at its place, alone in a group.
struct Ball {
    solid: Solid,
    shape: Shape,
    group: Group,
}

type Balls = Arc<LazyLock<Vec<Ball>, Box<dyn FnOnce() -> Vec<Ball> + Send>>>;

fn ball(place: Place) -> Option<Ball> {
    let solid = Solid::icosphere(1).placed(place);
    let mesh = Mesh::new(solid.vertices.clone(), solid.faces.clone(), None, Build::Bvh).ok()?;
    let shape = Shape::Mesh(mesh);
    Some(Ball { solid, group: alone(shape.clone()), shape })
}

fn alone(shape: Shape) -> Group {
    Group::world(vec![Member::Object(tracer::Object::new(shape, Material::Normal))])
}

/// A mesh alone in a world; `None` if it is refused, which none is.
fn alone_mesh(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Option<Group> {
    let mesh = Mesh::new(vertices, faces, None, Build::Bvh).ok()?;
    Some(alone(mesh.into()))
}

/// Those who leave a hit for a point: a ray that knows what it leaves, and for
/// contrast one that only starts off it.
const LEAVERS: [Kernel; 2] = [Kernel::GOLDRAY, Kernel::textbook("goldray-offset-only")];

/// Puts the rays of [`LEAVERS`] to `judge`, each with its tally.
fn leave_for(hit: &Hit, to: DVec3, tallies: &mut [Tally], judge: impl Fn(&Ray, &mut Tally)) {
    let known = hit.leaving_to(to);
    let unknown = Ray { leaving: None, ..known };
    for (ray, tally) in [known, unknown].iter().zip(tallies) {
        tally.case();
        if ray.origin.is_finite() && ray.direction.is_finite() {
            judge(ray, tally);
        } else {
            tally.count(Metric::NotFinite);
        }
    }
}

fn family(style: Style) -> Family {
    let all = move || style.balls().into_iter().filter_map(ball).collect();
    let balls: Balls = Arc::new(LazyLock::new(Box::new(all)));
    Family {
        primitive: "spawn",
        name: style.name.to_owned(),
        kernels: vec![
            Kernel::GOLDRAY,
            Kernel::textbook("goldray-offset-only"),
            Kernel::textbook("tmin-1e-4"),
            Kernel::textbook("tmin-0"),
        ],
        targets: vec![
            (Metric::SelfHits, Some(0.0)),
            (Metric::WrongIdentity, Some(0.0)),
            (Metric::NotFinite, Some(0.0)),
            (Metric::OffsetOverSize, Some(1e-9)),
            (Metric::ErrorOverBound, Some(1.0)),
        ],
        volume: VOLUME,
        generate: Box::new(move |random| generate(style, random)),
        judge: Box::new(move |case, tallies| {
            let object = Object::of_case(case);
            let ball = match object {
                Object::Mesh { number } => balls.get(number),
                _ => None,
            };
            let chain = style.instances.map(|limits| Chain::of_seed(case.number(SEED), limits));
            let shape = || object.shape().or_else(|| Some(ball?.shape.clone()));
            let made;
            let world = if let (None, Some(ball)) = (&chain, ball) {
                &ball.group
            } else {
                let group = match &chain {
                    Some(chain) => shape().and_then(|shape| chain.group(shape)),
                    None => shape().map(alone),
                };
                let Some(group) = group else { return };
                made = group;
                &made
            };
            let exact = chain.as_ref().map_or_else(Exact::identity, Chain::exact);
            let solid = ball.map(|ball| &ball.solid);
            let chained = chain.is_some();
            Spawn { case, object, solid, world, exact, chained }.judge(tallies);
        }),
    }
}

fn generate(style: Style, random: &mut Random) -> Case {
    let (object, target, size) = style.object(random);
    let origin = target + random.direction() * (size * style.distance(random));
    let seed = super::chain::seed(random);
    let map = style.instances.map(|limits| Chain::of_seed(seed, limits).product());
    let [origin, target] = [origin, target].map(|p| map.map_or(p, |map| map.transform_point3(p)));
    let ray = Ray::new(origin, target - origin);
    let cosine = random.sign() * style.cosine(random);
    let to_point = f64::from(u8::from(random.coin()));
    object
        .case()
        .with_ray(&ray)
        .with(cosine)
        .with(random.unit())
        .with(to_point)
        .with(seed)
        .with(size)
}

/// A surface that a ray has found.
struct Spawn<'a> {
    case: &'a Case,
    object: Object,
    solid: Option<&'a Solid>,
    world: &'a Group,
    exact: Exact,
    /// Whether it stands in instances.
    chained: bool,
}

impl Spawn<'_> {
    fn judge(&self, tallies: &mut [Tally]) {
        let primary = self.case.ray(RAY);
        // Rounding may let a ray at a rim pass: that asks nothing of us.
        let Some(hit) = self.world.intersect(&primary, Interval::AHEAD) else { return };
        let direction = self.direction(&hit);
        let size = self.case.number(SIZE) * self.exact.stretch;
        let outward = self.case.number(COSINE) > 0.0;
        let to_point = self.case.number(TO_POINT) > 0.0;
        let known = if to_point {
            hit.leaving_to(hit.point + direction * size)
        } else {
            hit.leaving(direction)
        };
        let unknown = Ray { leaving: None, ..known };
        let plain = Ray::new(primary.at(hit.t), direction);
        let ahead = Interval::AHEAD;
        let after = Interval::new(TMIN, f64::INFINITY);
        let rays =
            [(known, ahead, 0.0), (unknown, ahead, 0.0), (plain, after, TMIN), (plain, ahead, 0.0)];
        let gap = self.gap(hit.part, hit.point).abs();
        // A point that is exactly on the surface needs no bound.
        let bound = if gap == 0.0 { 0.0 } else { gap / hit.point_error };
        let is_upright = self.is_upright(&hit);
        let asked = if is_shown(self.case) { tallies.len() } else { 1 };
        for ((ray, range, skipped), tally) in rays.into_iter().zip(tallies).take(asked) {
            if !(ray.origin.is_finite() && ray.direction.is_finite()) {
                tally.case();
                tally.count(Metric::NotFinite);
                continue;
            }
            let offset = self.gap(hit.part, ray.origin).abs() + skipped;
            tally.most(Metric::OffsetOverSize, offset / size);
            tally.most(Metric::ErrorOverBound, bound);
            if !is_upright {
                tally.count(Metric::WrongIdentity);
            }
            self.follow(&hit, &ray, range, outward, tally);
        }
    }

    /// The direction at the case's angles from the surface.
    fn direction(&self, hit: &Hit) -> DVec3 {
        let cosine = self.case.number(COSINE);
        let (sin, cos) = libm::sincos(TAU * self.case.number(AZIMUTH));
        let n = *hit.geometric_normal;
        let (u, v) = n.any_orthonormal_pair();
        let along = (1.0 - cosine * cosine).max(0.0).sqrt();
        n * cosine + (u * cos + v * sin) * along
    }

    /// Whether the hit's normal is the surface's, outward, to far within what
    /// the rounding of a point may turn it; of instances nothing is asked.
    fn is_upright(&self, hit: &Hit) -> bool {
        /// A degree's cosine from 1.
        const TURNED: f64 = 1e-4;
        if self.chained {
            return true;
        }
        let (_, normal) = self.object.gap(hit.part, &V3::of(hit.point), self.solid);
        let cosine = normal.dot(*hit.geometric_normal);
        // A triangle's front is where its corners say.
        cosine > 1.0 - TURNED
    }

    /// How far a point of the world is outside of the surface.
    fn gap(&self, part: u32, point: DVec3) -> f64 {
        let x = self.exact.object_point(&V3::of(point));
        let (gap, normal) = self.object.gap(part, &x, self.solid);
        gap / self.exact.gradient_length(normal)
    }

    /// How often the ray crosses the surface.
    fn crossings(&self, ray: &Ray, range: Interval) -> u32 {
        let mut after = range;
        let mut count = 0;
        while let Some(hit) = self.world.intersect(ray, after) {
            count += 1;
            after = Interval::new(hit.t, range.hi);
        }
        count
    }

    fn follow(&self, hit: &Hit, ray: &Ray, range: Interval, outward: bool, tally: &mut Tally) {
        let again = self.world.intersect(ray, range);
        let shadow = self.world.occludes(ray, range);
        if self.object.is_hollow() {
            // Out of it one may get in again, but then also out.
            tally.case();
            if self.crossings(ray, range) % 2 != u32::from(!outward) {
                tally.count(if outward { Metric::SelfHits } else { Metric::WrongIdentity });
            }
            return;
        }
        if outward || !self.object.is_closed() {
            tally.case();
            if again.is_some() || shadow {
                tally.count(Metric::SelfHits);
            }
            return;
        }
        let p = self.exact.object_point(&V3::<Dd>::of(hit.point));
        let d = self.exact.object_vector(&V3::of(ray.direction));
        let Some((t, doubt)) = self.object.chord(&p, &d) else {
            tally.case();
            if again.is_none() || !shadow {
                tally.count(Metric::WrongIdentity);
            }
            return;
        };
        let rounding = UNIT_ROUNDOFF * self.object.extent()
            + self.exact.rounding(hit.point, p.to_f64().length());
        // Rounding the point once may change the way through by that much.
        if !(TIE * rounding * doubt <= CHORD * t) {
            tally.tie();
            return;
        }
        tally.case();
        let is_right = |again: Hit| (again.t - t).abs() <= CHORD * t;
        if !(again.is_some_and(is_right) && shadow) {
            tally.count(Metric::WrongIdentity);
        }
    }
}

/// The distance that textbooks skip.
const TMIN: f64 = 1e-4;
