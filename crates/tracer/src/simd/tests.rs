//! Every level against plain numbers.

use super::*;

/// Numbers that arithmetic treats in ways of their own, and others.
const UGLY: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -2.5,
    1e-40,
    3e38,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    0.1,
    -7.25,
    1.0 / 3.0,
];

/// Calls `check` with every level and several numbers for each lane.
fn on_all_levels(check: impl Fn(Level, [[f64; 4]; 3])) {
    let at = |k: usize| UGLY[k % UGLY.len()];
    for level in Level::all() {
        for k in 0..UGLY.len() * UGLY.len() {
            let four = |first: usize| [0, 1, 2, 3].map(|lane| at(first + 5 * lane));
            check(level, [four(k), four(k / UGLY.len() + k), four(7 * k + 3)]);
        }
    }
}

#[track_caller]
fn same(level: Level, got: [f64; 4], expected: [f64; 4]) {
    let is_same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    assert!((0..4).all(|k| is_same(got[k], expected[k])), "{level:?}: {got:?}, {expected:?}");
}

/// What is asked of four numbers: the arithmetic of `R`, which rounds to it.
struct Arithmetic([[f64; 4]; 3]);

/// Results by lanes, and masks.
type Results = (Vec<[f64; 4]>, Vec<u32>);

fn arithmetic<V: Four>(a: V, b: V, c: V) -> Results {
    let lanes = vec![
        a + b,
        a - b,
        a * b,
        a / b,
        -a,
        a.magnitude(),
        a.fused(b, c),
        a.where_positive(b),
        a.min(b),
        a.max(b),
        a.like(0.1),
    ];
    (lanes.into_iter().map(Four::to_array).collect(), vec![a.is_at_most(b)])
}

impl Work for Arithmetic {
    type Output = [Results; 2];

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [Results; 2] {
        let [a, b, c] = self.0.map(|x| simd.load_four_long(&x));
        let [d, e, f] = self.0.map(|x| simd.narrow_four(&x));
        [arithmetic(a, b, c), arithmetic(d, e, f)]
    }
}

#[test]
fn four_numbers_are_reckoned_with_like_one() {
    on_all_levels(|level, numbers| {
        let [long, short] = level.run(Arithmetic(numbers));
        let [a, b, c] = numbers;
        let each = |f: &dyn Fn(f64, f64, f64) -> f64| {
            [0, 1, 2, 3].map(|lane| f(a[lane], b[lane], c[lane]))
        };
        let single = |f: &dyn Fn(f32, f32, f32) -> f32| {
            each(&|a, b, c| f64::from(f(a as f32, b as f32, c as f32)))
        };
        // As on x86: the second where one is a NaN.
        macro_rules! expected {
            ($each:expr, $tenth:expr) => {
                [
                    $each(&|a, b, _| a + b),
                    $each(&|a, b, _| a - b),
                    $each(&|a, b, _| a * b),
                    $each(&|a, b, _| a / b),
                    $each(&|a, _, _| -a),
                    $each(&|a, _, _| a.abs()),
                    $each(&|a, b, c| a.mul_add(b, c)),
                    $each(&|a, b, _| if b > 0.0 { a } else { 0.0 }),
                    $each(&|a, b, _| if a < b { a } else { b }),
                    $each(&|a, b, _| if a > b { a } else { b }),
                    $each(&|_, _, _| $tenth),
                ]
            };
        }
        for (got, expected) in long.0.iter().zip(expected!(each, 0.1)) {
            same(level, *got, expected);
        }
        for (got, expected) in short.0.iter().zip(expected!(single, 0.1_f32)) {
            same(level, *got, expected);
        }
        let bits = |at_most: &dyn Fn(usize) -> bool| {
            (0..4).fold(0, |bits, lane| bits | u32::from(at_most(lane)) << lane)
        };
        assert_eq!(long.1, [bits(&|lane| a[lane] <= b[lane])], "{level:?}");
        assert_eq!(short.1, [bits(&|lane| a[lane] as f32 <= b[lane] as f32)], "{level:?}");
    });
}

struct Eights([[f32; 8]; 3]);

impl Work for Eights {
    type Output = ([[f32; 8]; 3], u32);

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> ([[f32; 8]; 3], u32) {
        let [a, b, c] = self.0.map(|x| simd.load_eight(&x));
        let lanes = [a.times_plus(b, c), a.min(b), a.max(b)];
        (lanes.map(Eight::to_array), a.is_at_most(b))
    }
}

#[test]
fn eight_numbers_are_reckoned_with_like_one() {
    on_all_levels(|level, [a, b, c]| {
        let eight = |low: [f64; 4], high: [f64; 4]| {
            std::array::from_fn(|k| if k < 4 { low[k] as f32 } else { high[k - 4] as f32 })
        };
        let [a, b, c]: [[f32; 8]; 3] = [eight(a, b), eight(b, c), eight(c, a)];
        let ([times, min, max], bits) = level.run(Eights([a, b, c]));
        for k in 0..8 {
            let is = |got: f32, expected: f32| got == expected || got.is_nan() && expected.is_nan();
            let once = a[k].mul_add(b[k], c[k]);
            assert!(is(times[k], once) || is(times[k], a[k] * b[k] + c[k]), "{level:?}");
            assert!(is(min[k], if a[k] < b[k] { a[k] } else { b[k] }), "{level:?}");
            assert!(is(max[k], if a[k] > b[k] { a[k] } else { b[k] }), "{level:?}");
            assert_eq!(bits >> k & 1 == 1, a[k] <= b[k], "{level:?}");
        }
    });
}

struct Ways([f64; 4]);

impl Work for Ways {
    type Output = [[f64; 4]; 5];

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [[f64; 4]; 5] {
        let singles = self.0.map(|x| x as f32);
        simd.prefetch(std::ptr::from_ref(&singles).cast());
        [
            simd.load_four(&singles).to_array(),
            simd.widen_four(&singles).to_array(),
            simd.load_four_long(&self.0).to_singles().map(f64::from),
            simd.four(self.0[1] as f32).to_array(),
            simd.four_long(self.0[2]).to_array(),
        ]
    }
}

#[test]
fn numbers_come_in_and_go_out_as_they_are() {
    on_all_levels(|level, [a, ..]| {
        let [loaded, widened, narrowed, all, all_long] = level.run(Ways(a));
        let rounded = a.map(|x| f64::from(x as f32));
        same(level, loaded, rounded);
        same(level, widened, rounded);
        same(level, narrowed, rounded);
        same(level, all, [rounded[1]; 4]);
        same(level, all_long, [a[2]; 4]);
    });
}

#[test]
fn a_stack_gives_back_what_it_was_given() {
    let mut room = Room::<u64, 4>::new();
    let mut stack = room.stack();
    assert_eq!((stack.pop(), stack.len()), (None, 0));
    for entry in [3, 1, 2] {
        stack.push(entry);
    }
    stack.from(1).sort_unstable();
    assert_eq!(
        [stack.pop(), stack.pop(), stack.pop(), stack.pop()],
        [Some(2), Some(1), Some(3), None]
    );
    let overflow = std::panic::catch_unwind(|| {
        let mut room = Room::<u64, 1>::new();
        let mut stack = room.stack();
        stack.push(1);
        stack.push(2);
    });
    assert!(overflow.is_err());
}
