//! Whole pictures: the same bits on any number of threads, with either
//! accelerator, and, for a fixed set of scenes, on every target.

use std::sync::OnceLock;

use rayon::{ThreadPool, ThreadPoolBuilder};
use tracer::accel::Build;
use tracer::{LinearImage, Plan, Scene, Skipping, render, render_counted};

use crate::family::{Family, Kernel, Volume};
use crate::{Case, Metric, Tally};

mod random_scene;

use random_scene::{random_scene, sparse_scene};

/// Threads that render each random scene, with the number of the first.
const THREADS: [usize; 3] = [1, 2, 7];

/// What the bits of scenes 0, 1, 2... are, by [`digest`]. Other random numbers
/// of `fastrand` make other scenes and so other digests: the test below then
/// prints the table, to be taken over once `threads-and-accelerators` and
/// `.ci/digests` have passed.
const DIGESTS: [u64; 24] = [
    0xca0d_be8d_3436_c03d,
    0x68b4_a1d0_2b88_26d0,
    0x2f36_404b_1e97_43f1,
    0x2d2c_43ff_373b_2aa6,
    0xb067_193b_72cc_599c,
    0xf935_60ed_4e7e_8376,
    0xd1ff_de83_5344_38f7,
    0x436a_3e8a_b103_2d70,
    0x5f70_20bb_16cf_0d0c,
    0xb3a5_ca0f_88e4_308c,
    0xc5c0_a197_3f0a_2fbe,
    0xd552_b567_4fe3_427f,
    0x6918_84ca_180a_9f2f,
    0x679d_dbf6_7c3f_14c6,
    0xb32f_9dde_049c_353b,
    0x258c_90fc_3174_8e5a,
    0xb1df_d413_8766_3691,
    0xb0a7_5cc2_23ad_5384,
    0x9f85_8c49_02ef_b9ab,
    0x7317_3fe0_36e5_d721,
    0x09f3_ed62_385c_c49d,
    0x41e1_198f_fcc7_a4fe,
    0xca15_6ff1_86ae_ae80,
    0xf81d_4049_6d7b_83a0,
];

/// Numbers of random scenes: all exact in an `f64`, the fixed ones left out.
const NUMBERS: std::ops::Range<f64> = 1e6..9e15;

/// Every family of pictures.
pub(super) fn families() -> Vec<Family> {
    vec![threads_and_accelerators(), skipping(), fixed_scenes()]
}

/// A case is the number of a scene.
fn threads_and_accelerators() -> Family {
    let pools = OnceLock::new();
    family(
        "threads-and-accelerators",
        Volume { quick: 12, full: 2_000 },
        |random| Case::EMPTY.with(random.between(NUMBERS.start, NUMBERS.end).floor()),
        move |case, tally| {
            let number = case.number(0) as u64;
            let pools = pools.get_or_init(|| THREADS.map(pool));
            let on = |pool: &Option<ThreadPool>, build| {
                let scene = random_scene(number, build).ok()?;
                pool.as_ref().map(|pool| digest(&pool.install(|| render(&scene))))
            };
            let first = on(&pools[0], Build::Bvh);
            let others = pools.iter().skip(1).map(|pool| on(pool, Build::Bvh));
            // What cannot be rendered has no bits, and so not the same.
            let all = [on(&pools[1], Build::List)].into_iter().chain(others);
            for _ in all.filter(|other| other.is_none() || *other != first) {
                tally.count(Metric::OtherBits);
            }
        },
    )
}

/// A case is the number of a sparse scene, rendered with and without skipping
/// what cannot change its picture.
fn skipping() -> Family {
    family(
        "skipping",
        Volume { quick: 60, full: 2_000 },
        |random| Case::EMPTY.with(random.between(NUMBERS.start, NUMBERS.end).floor()),
        |case, tally| {
            let scene = sparse_scene(case.number(0) as u64).ok();
            let on = |skipping| {
                let scene = scene.as_ref()?;
                Some(digest(&render_counted(scene, &Plan::new(scene, skipping)).0))
            };
            let plain = scene.as_ref().map(|scene| digest(&render(scene)));
            for skipping in [Skipping::On, Skipping::Off].map(on) {
                if skipping.is_none() || skipping != plain {
                    tally.count(Metric::OtherBits);
                }
            }
        },
    )
}

/// The one case is how many scenes there are, from number 0.
fn fixed_scenes() -> Family {
    family(
        "fixed-scenes",
        Volume { quick: 1, full: 1 },
        |_| Case::EMPTY.with(DIGESTS.len() as f64),
        |case, tally| {
            for number in 0..case.number(0) as usize {
                if DIGESTS.get(number) != digest_of_fixed(number).as_ref() {
                    tally.count(Metric::OtherBits);
                }
            }
        },
    )
}

fn family(
    name: &str,
    volume: Volume,
    generate: impl Fn(&mut crate::Random) -> Case + Send + Sync + 'static,
    judge: impl Fn(&Case, &mut Tally) + Send + Sync + 'static,
) -> Family {
    Family {
        primitive: "image",
        name: name.to_owned(),
        kernels: vec![Kernel::GOLDRAY],
        targets: vec![(Metric::OtherBits, Some(0.0))],
        volume,
        generate: Box::new(generate),
        judge: Box::new(move |case, tallies| {
            for tally in tallies {
                tally.case();
                judge(case, tally);
            }
        }),
    }
}

/// Threads to render with; none where the system has none to give.
fn pool(threads: usize) -> Option<ThreadPool> {
    ThreadPoolBuilder::new().num_threads(threads).build().ok()
}

/// The digest of a fixed scene; `None` if it is refused, which none is.
fn digest_of_fixed(number: usize) -> Option<u64> {
    let scene: Scene = random_scene(number as u64, Build::default()).ok()?;
    Some(digest(&render(&scene)))
}

/// FNV-1a of width, height and every channel's bits, little-endian.
///
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, the 64-bit hash.
fn digest(picture: &LinearImage) -> u64 {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0100_0000_01b3;
    let size = [picture.size().width, picture.size().height].map(u64::from);
    let channels = picture.pixels().iter().flat_map(|pixel| pixel.channels()).map(f64::to_bits);
    let bytes = size.into_iter().chain(channels).flat_map(u64::to_le_bytes);
    bytes.fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fixed_scenes_have_the_bits_of_the_table() {
        let today: Vec<_> = (0..DIGESTS.len()).map(|n| digest_of_fixed(n).unwrap()).collect();
        let parts = |d: &u64| [48, 32, 16, 0].map(|shift| format!("{:04x}", d >> shift & 0xffff));
        let line = |d: &u64| format!("    0x{},\n", parts(d).join("_"));
        let table: String = today.iter().map(line).collect();
        assert!(today == DIGESTS, "the bits of today are:\n{table}");
    }

    #[test]
    fn every_picture_shows_something_and_no_two_are_the_same() {
        let mut digests = std::collections::BTreeSet::new();
        for number in 0..200 {
            let scene = random_scene(number, Build::Bvh).unwrap();
            let picture = render(&scene);
            let background = picture.pixels().iter().filter(|p| **p == random_scene::BACKGROUND);
            let share = background.count() as f64 / picture.pixels().len() as f64;
            assert!(share < 0.97, "{number}: {share} is background");
            assert!(picture.pixels().iter().all(|p| p.is_finite()), "{number}");
            assert!(digests.insert(digest(&picture)), "{number}");
        }
    }

    #[test]
    fn the_last_bit_of_the_last_channel_is_seen() {
        let scene = random_scene(3, Build::Bvh).unwrap();
        let picture = render(&scene);
        let mut pixels = picture.pixels().to_vec();
        let last = pixels.last_mut().unwrap();
        last.b = last.b.next_up();
        let other = LinearImage::from_pixels(picture.size(), pixels).unwrap();
        assert_ne!(digest(&picture), digest(&other));
    }
}
