//! `Random`: seeded random numbers of the kinds that stress arithmetic, the
//! same on every system.

use tracer::glam::DVec3;

/// A generator of numbers, points and directions.
#[derive(Debug, Clone)]
pub struct Random(fastrand::Rng);

impl Random {
    /// The generator of one chunk of a family: its own stream for each.
    pub fn of_chunk(seed: u64, family: &str, chunk: u64) -> Self {
        // FNV-1a over the name, then the chunk and the seed stirred in.
        const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
        const PRIME: u64 = 0x0100_0000_01b3;
        /// The golden ratio in 64 bits, the step of a Weyl sequence.
        const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
        let stir = |h: u64, byte: u8| (h ^ u64::from(byte)).wrapping_mul(PRIME);
        let name = family.bytes().fold(OFFSET, stir);
        let bytes = [seed.to_le_bytes(), chunk.wrapping_mul(STEP).to_le_bytes()];
        Self(fastrand::Rng::with_seed(bytes.into_iter().flatten().fold(name, stir)))
    }

    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0.f64()
    }

    /// Between these.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.0.f64()
    }

    /// Between these, each decade as likely as another; both above zero.
    pub fn decades(&mut self, lo: f64, hi: f64) -> f64 {
        libm::exp2(self.between(libm::log2(lo), libm::log2(hi)))
    }

    /// A whole number below `n`; 0 if `n` is 0.
    pub fn below(&mut self, n: usize) -> usize {
        self.0.usize(0..n.max(1))
    }

    /// One of these; they must not be none.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// True or false.
    pub fn coin(&mut self) -> bool {
        self.0.bool()
    }

    /// 1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    /// In the cube from -1 to 1.
    pub fn point(&mut self) -> DVec3 {
        DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    /// Of length 1 but for rounding, all ways as likely.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let p = self.point();
            let square = p.length_squared();
            // Not so short that its direction is coarse.
            if (1e-4..=1.0).contains(&square) {
                return p / square.sqrt();
            }
        }
    }

    /// A unit vector across `axis`, which need not be one.
    pub fn across(&mut self, axis: DVec3) -> DVec3 {
        loop {
            let side = axis.cross(self.direction());
            if side.length_squared() > 1e-4 * axis.length_squared() {
                return side.normalize();
            }
        }
    }
}

/// The nearest `f32`, as an `f64`.
pub fn f32_of(x: f64) -> f64 {
    f64::from(x as f32)
}

/// The nearest point with `f32` coordinates.
pub fn f32_point(p: DVec3) -> DVec3 {
    DVec3::new(f32_of(p.x), f32_of(p.y), f32_of(p.z))
}
