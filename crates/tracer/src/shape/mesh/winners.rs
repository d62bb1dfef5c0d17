//! `Winners`: the numbers of hits that are sure, found out for four rays at a
//! time.

use glam::DVec3;

use super::super::triangle::{Line, Shear};
use super::blocks::{Block, Number};
use super::visit::Known;
use super::{Contact, Interval, Ray};
use crate::simd::{Four, Simd, Work};

/// How many rays wait for each other.
const LANES: usize = 4;

/// Rays and the triangle that each hits first, for sure, until there are four.
/// Their `t` and weights come from [`Shear`]'s own formulas, with its bits.
pub(super) struct Winners<'a, S> {
    simd: S,
    range: Interval,
    rays: &'a [Ray],
    contacts: &'a mut [Option<Contact>],
    waiting: Waiting,
    /// Those whose numbers are to be found again with twice the digits.
    drawn: Waiting,
}

/// Up to four that wait, lane by lane.
struct Waiting {
    count: usize,
    /// Which ray, and which triangle.
    ray: [usize; LANES],
    part: [u32; LANES],
    origin: [[f64; LANES]; 3],
    direction: [[f64; LANES]; 3],
    scale: [f64; LANES],
    corners: [[[f64; LANES]; 3]; 3],
    /// What was found already.
    t: [f64; LANES],
    barycentric: [[f64; LANES]; 2],
}

impl Waiting {
    #[inline(always)]
    fn nobody() -> Self {
        Self {
            count: 0,
            ray: [0; LANES],
            part: [0; LANES],
            origin: [[0.0; LANES]; 3],
            direction: [[0.0; LANES]; 3],
            scale: [0.0; LANES],
            corners: [[[0.0; LANES]; 3]; 3],
            t: [0.0; LANES],
            barycentric: [[0.0; LANES]; 2],
        }
    }

    #[inline(always)]
    fn line<S: Simd>(&self, simd: S) -> Line<S::D4> {
        Line { origin: load(simd, &self.origin), d: load(simd, &self.direction) }
    }

    #[inline(always)]
    fn corners<S: Simd>(&self, simd: S) -> [[S::D4; 3]; 3] {
        let [a, b, c] = &self.corners;
        [load(simd, a), load(simd, b), load(simd, c)]
    }

    /// Takes over what waits in a lane, to wait for more.
    #[inline(always)]
    fn take(&mut self, from: &Self, lane: usize) {
        let (to, lane) = (self.count % LANES, lane % LANES);
        self.ray[to] = from.ray[lane];
        self.part[to] = from.part[lane];
        self.scale[to] = from.scale[lane];
        self.t[to] = from.t[lane];
        for k in 0..2 {
            self.barycentric[k][to] = from.barycentric[k][lane];
        }
        for axis in 0..3 {
            self.origin[axis][to] = from.origin[axis][lane];
            self.direction[axis][to] = from.direction[axis][lane];
            for corner in 0..3 {
                self.corners[corner][axis][to] = from.corners[corner][axis][lane];
            }
        }
        self.count += 1;
    }

    /// The triangle of a lane, turned back.
    #[cold]
    fn triangle(&self, ray: &Ray, lane: usize) -> [DVec3; 3] {
        let shear = Shear::new(ray);
        self.corners.map(|corner| shear.turned_back(corner.map(|x| x[lane % LANES])))
    }

    #[inline(always)]
    fn contact(&self, lane: usize) -> Contact {
        let [beta, gamma] = &self.barycentric;
        Contact { t: self.t[lane], part: self.part[lane], barycentric: [beta[lane], gamma[lane]] }
    }
}

impl<'a, S: Simd> Winners<'a, S> {
    /// None yet, of these rays, whose contacts go to the same places.
    #[inline(always)]
    pub(super) fn new(
        simd: S,
        range: Interval,
        rays: &'a [Ray],
        contacts: &'a mut [Option<Contact>],
    ) -> Self {
        let (waiting, drawn) = (Waiting::nobody(), Waiting::nobody());
        Self { simd, range, rays, contacts, waiting, drawn }
    }

    /// What is known of the first hit of a ray.
    #[inline(always)]
    pub(super) fn add<T: Number>(&mut self, ray: usize, known: Known, blocks: &[Block<T>]) {
        match known {
            Known::Nothing => self.contacts[ray] = None,
            Known::Contact(contact) => self.contacts[ray] = Some(contact),
            Known::Sure { block, lane } => {
                let block = &blocks[block];
                let shear = Shear::new(&self.rays[ray]);
                let (line, scale) = shear.line();
                let [a, b, c] = shear.turned(block.triangle(lane));
                let waiting = &mut self.waiting;
                let here = waiting.count % LANES;
                waiting.ray[here] = ray;
                waiting.part[here] = block.numbers[lane % LANES];
                waiting.scale[here] = scale;
                for axis in 0..3 {
                    waiting.origin[axis][here] = line.origin[axis];
                    waiting.direction[axis][here] = line.d[axis];
                    waiting.corners[0][axis][here] = a[axis];
                    waiting.corners[1][axis][here] = b[axis];
                    waiting.corners[2][axis][here] = c[axis];
                }
                waiting.count += 1;
                if waiting.count == LANES {
                    self.simd.apart(FindOut(self));
                }
            }
        }
    }

    /// The numbers of those that still wait.
    #[inline(always)]
    pub(super) fn finish(mut self) {
        self.simd.apart(FindOut(&mut self));
        self.simd.apart(FindOutDrawn(&mut self));
    }

    #[inline(always)]
    fn find_out(&mut self) {
        let (simd, waiting) = (self.simd, &mut self.waiting);
        let line = waiting.line(simd);
        let edges = line.edges(waiting.corners(simd));
        let mean = line.mean(&edges);
        let zero = simd.four_long(0.0);
        let lowest = edges.u.min(edges.v).min(edges.w);
        let highest = edges.u.max(edges.v).max(edges.w);
        let sure = !(lowest.is_at_most(zero) & zero.is_at_most(highest));
        let is_drawn = !mean.drawn[0].is_at_most(mean.drawn[1]);
        let t = mean.t * simd.load_four_long(&waiting.scale);
        waiting.t = t.to_array();
        let [beta, gamma] = mean.barycentric;
        waiting.barycentric = [beta.to_array(), gamma.to_array()];
        let (lo, hi) = (simd.four_long(self.range.lo), simd.four_long(self.range.hi));
        let inside = !t.is_at_most(lo) & lo.is_at_most(t) & t.is_at_most(hi) & !hi.is_at_most(t);
        let count = waiting.count.min(LANES);
        for lane in 0..count {
            self.contacts[waiting.ray[lane]] = Some(waiting.contact(lane));
        }
        // The few for which that was not all, without a branch for each other one.
        let mut rest = !(sure & inside & !is_drawn) & ((1 << count) - 1);
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % LANES;
            rest &= rest - 1;
            let waiting = &self.waiting;
            if (sure & is_drawn) >> lane & 1 == 1 {
                self.drawn.take(waiting, lane);
                if self.drawn.count == LANES {
                    self.simd.apart(FindOutDrawn(self));
                }
            } else {
                self.contacts[waiting.ray[lane]] = self.alone(waiting, lane);
            }
        }
        self.waiting.count = 0;
    }

    #[inline(always)]
    fn find_out_drawn(&mut self) {
        let (simd, drawn) = (self.simd, &mut self.drawn);
        let (line, corners) = (drawn.line(simd), drawn.corners(simd));
        let mean = line.long_mean(corners, &line.edges(corners));
        let t = (mean.t * simd.load_four_long(&drawn.scale)).to_array();
        let [beta, gamma] = mean.barycentric;
        let (beta, gamma) = (beta.to_array(), gamma.to_array());
        for lane in 0..drawn.count.min(LANES) {
            if t[lane].is_finite() {
                drawn.t[lane] = t[lane];
                drawn.barycentric[0][lane] = beta[lane];
                drawn.barycentric[1][lane] = gamma[lane];
            }
        }
        for lane in 0..drawn.count.min(LANES) {
            let drawn = &self.drawn;
            self.contacts[drawn.ray[lane]] = self.settled(drawn, lane);
        }
        self.drawn.count = 0;
    }

    /// The contact that was found, if it is in range.
    #[inline(always)]
    fn settled(&self, waiting: &Waiting, lane: usize) -> Option<Contact> {
        let contact = waiting.contact(lane);
        if self.range.contains(contact.t) { Some(contact) } else { self.alone(waiting, lane) }
    }

    /// The contact of one for which that was not enough.
    #[inline(always)]
    fn alone(&self, waiting: &Waiting, lane: usize) -> Option<Contact> {
        let ray = &self.rays[waiting.ray[lane]];
        let contact = super::decided(ray, waiting.triangle(ray, lane), self.range)?;
        Some(Contact { part: waiting.part[lane], ..contact })
    }
}

/// Those that wait, found out: long, and asked wherever a ray is added.
struct FindOut<'a, 'b, S>(&'a mut Winners<'b, S>);

impl<S: Simd> Work for FindOut<'_, '_, S> {
    type Output = ();
    #[inline(always)]
    fn run<T: Simd>(self, _: T) {
        self.0.find_out();
    }
}

/// Those whose numbers are found again.
struct FindOutDrawn<'a, 'b, S>(&'a mut Winners<'b, S>);

impl<S: Simd> Work for FindOutDrawn<'_, '_, S> {
    type Output = ();
    #[inline(always)]
    fn run<T: Simd>(self, _: T) {
        self.0.find_out_drawn();
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, [x, y, z]: &[[f64; LANES]; 3]) -> [S::D4; 3] {
    [simd.load_four_long(x), simd.load_four_long(y), simd.load_four_long(z)]
}
