//! `Winners`: the numbers of hits that are sure, found out for four rays at a
//! time.

use super::super::triangle::{Line, Shear};
use super::blocks::{Block, Number};
use super::visit::Known;
use super::{Contact, Interval, Ray};
use crate::simd::{Four, Simd, Work};

/// How many rays wait for each other.
const LANES: usize = 4;
/// A bit for each.
const ALL: u32 = (1 << LANES) - 1;

/// Up to four rays and the triangle that each hits first, for sure. Their `t` and
/// weights come from [`Shear`]'s own formulas, with its bits.
pub(super) struct Winners<'a, S> {
    simd: S,
    range: Interval,
    rays: &'a [Ray],
    contacts: &'a mut [Option<Contact>],
    count: usize,
    lanes: Lanes,
}

/// What waits, lane by lane.
struct Lanes {
    /// Which ray, and which triangle.
    ray: [usize; LANES],
    part: [u32; LANES],
    origin: [[f64; LANES]; 3],
    direction: [[f64; LANES]; 3],
    scale: [f64; LANES],
    corners: [[[f64; LANES]; 3]; 3],
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
        let lanes = Lanes {
            ray: [0; LANES],
            part: [0; LANES],
            origin: [[0.0; LANES]; 3],
            direction: [[0.0; LANES]; 3],
            scale: [0.0; LANES],
            corners: [[[0.0; LANES]; 3]; 3],
        };
        Self { simd, range, rays, contacts, count: 0, lanes }
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
                let (here, lanes) = (self.count % LANES, &mut self.lanes);
                lanes.ray[here] = ray;
                lanes.part[here] = block.numbers[lane % LANES];
                lanes.scale[here] = scale;
                for axis in 0..3 {
                    lanes.origin[axis][here] = line.origin[axis];
                    lanes.direction[axis][here] = line.d[axis];
                    lanes.corners[0][axis][here] = a[axis];
                    lanes.corners[1][axis][here] = b[axis];
                    lanes.corners[2][axis][here] = c[axis];
                }
                self.count += 1;
                if self.count == LANES {
                    self.simd.apart(FindOut(self));
                }
            }
        }
    }

    /// The numbers of those that still wait.
    #[inline(always)]
    pub(super) fn finish(mut self) {
        if self.count > 0 {
            self.simd.apart(FindOut(&mut self));
        }
    }

    #[inline(always)]
    fn find_out(&mut self) {
        let (simd, lanes) = (self.simd, &self.lanes);
        let scale = simd.load_four_long(&lanes.scale);
        let line = Line { origin: load(simd, &lanes.origin), d: load(simd, &lanes.direction) };
        let [a, b, c] = &lanes.corners;
        let corners = [load(simd, a), load(simd, b), load(simd, c)];
        let edges = line.edges(corners);
        let mean = line.mean(&edges);
        let zero = simd.four_long(0.0);
        let lowest = edges.u.min(edges.v).min(edges.w);
        let highest = edges.u.max(edges.v).max(edges.w);
        let sure = !(lowest.is_at_most(zero) & zero.is_at_most(highest));
        let is_drawn = !mean.drawn[0].is_at_most(mean.drawn[1]);
        let mut t = (mean.t * scale).to_array();
        let mut weights = mean.barycentric.map(Four::to_array);
        if is_drawn & ALL != 0 {
            let mean = line.long_mean(corners, &edges);
            let long_t = (mean.t * scale).to_array();
            let long_weights = mean.barycentric.map(Four::to_array);
            for lane in (0..LANES).filter(|lane| is_drawn >> lane & 1 == 1) {
                if long_t[lane].is_finite() {
                    t[lane] = long_t[lane];
                    weights[0][lane] = long_weights[0][lane];
                    weights[1][lane] = long_weights[1][lane];
                }
            }
        }
        let [beta, gamma] = weights;
        for lane in 0..self.count.min(LANES) {
            let (ray, part) = (self.lanes.ray[lane], self.lanes.part[lane]);
            let contact = Contact { t: t[lane], part, barycentric: [beta[lane], gamma[lane]] };
            let is_good = sure >> lane & 1 == 1 && self.range.contains(contact.t);
            self.contacts[ray] = if is_good { Some(contact) } else { self.alone(lane) };
        }
        self.count = 0;
    }

    /// The contact of one for which that was not enough.
    #[cold]
    fn alone(&self, lane: usize) -> Option<Contact> {
        let ray = &self.rays[self.lanes.ray[lane]];
        let shear = Shear::new(ray);
        let corners = self.lanes.corners.map(|corner| shear.turned_back(corner.map(|x| x[lane])));
        let contact = shear.decide(corners, self.range)?;
        Some(Contact { part: self.lanes.part[lane], ..contact })
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

#[inline(always)]
fn load<S: Simd>(simd: S, [x, y, z]: &[[f64; LANES]; 3]) -> [S::D4; 3] {
    [simd.load_four_long(x), simd.load_four_long(y), simd.load_four_long(z)]
}
