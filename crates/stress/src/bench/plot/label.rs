//! Places the labels of points so that none covers another or a point.

/// A place on a panel, in pixels, y downwards.
pub(super) type Point = (f64, f64);

/// A rectangle with sides along the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rect {
    fn around((x, y): Point, width: f64, height: f64) -> Self {
        let (w, h) = (width / 2.0, height / 2.0);
        Self { left: x - w, top: y - h, right: x + w, bottom: y + h }
    }

    fn meets(&self, other: &Self) -> bool {
        let beside = self.right <= other.left || other.right <= self.left;
        let above = self.bottom <= other.top || other.bottom <= self.top;
        !(beside || above)
    }

    fn is_inside(&self, other: &Self) -> bool {
        let x = self.left >= other.left && self.right <= other.right;
        x && self.top >= other.top && self.bottom <= other.bottom
    }

    fn holds(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// Its point next to this one.
    fn nearest(&self, (x, y): Point) -> Point {
        (x.clamp(self.left, self.right), y.clamp(self.top, self.bottom))
    }

    /// Whether it meets the line between these, looked at every pixel or so.
    fn meets_line(&self, a: Point, b: Point) -> bool {
        let steps = (b.0 - a.0).abs().max((b.1 - a.1).abs()).ceil().max(1.0) as u32;
        (0..=steps).any(|step| {
            let share = f64::from(step) / f64::from(steps);
            self.holds((a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1)))
        })
    }
}

/// Where a label is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Label {
    /// What its text covers.
    pub(super) text: Rect,
}

/// From this distance on a line leads from the point to its label.
const APART: f64 = 13.0;

impl Label {
    /// The end of the line from its point, if it is so far away that it needs
    /// one.
    pub(super) fn leader(&self, point: Point) -> Option<Point> {
        let end = self.text.nearest(point);
        let (x, y) = (end.0 - point.0, end.1 - point.1);
        (x * x + y * y > APART * APART).then_some(end)
    }
}

/// The height of a label, and of the room that a point takes.
const HEIGHT: f64 = 14.0;
const POINT: f64 = 13.0;
/// How far labels are tried from their point: from the first, by each step,
/// this often; and in how many directions.
const FIRST: f64 = 7.0;
const STEP: f64 = 6.0;
const RINGS: u32 = 60;
const WAYS: u32 = 24;
/// What covering the frontier costs, in pixels further away.
const ON_LINE: f64 = 40.0;

/// What labels must keep clear of, besides each other.
pub(super) struct Surroundings<'a> {
    /// The panel, which they do not leave.
    pub(super) inside: Rect,
    /// Texts that are already there.
    pub(super) texts: &'a [Rect],
    /// The corners of a line, which they cover only if all else is far away.
    pub(super) line: &'a [Point],
}

/// A label for each point, in their order: the first has the first choice. A
/// label that finds no free place within reach stays at its point.
pub(super) fn place(points: &[Point], widths: &[f64], around: &Surroundings<'_>) -> Vec<Label> {
    let &Surroundings { inside, texts, line } = around;
    let taken: Vec<_> = points.iter().map(|&p| Rect::around(p, POINT, POINT)).collect();
    let mut labels: Vec<Label> = Vec::new();
    for (k, (&point, &width)) in points.iter().zip(widths).enumerate() {
        let others = || points.iter().zip(&labels);
        let text_is_free = |label: &Label| {
            label.text.is_inside(&inside)
                && !taken.iter().chain(texts).any(|other| other.meets(&label.text))
                && !others().any(|(_, other)| other.text.meets(&label.text))
        };
        // No leader crosses a text, nor another point unless it begins there.
        let leaders_are_free = |label: &Label| {
            let covers_leader = others().any(|(&from, other)| {
                other.leader(from).is_some_and(|to| label.text.meets_line(from, to))
            });
            !covers_leader
                && label.leader(point).is_none_or(|end| {
                    let crosses = |rect: &Rect| rect.meets_line(point, end);
                    let far = || taken.iter().filter(|other| !other.meets(&taken[k]));
                    !others().any(|(_, other)| crosses(&other.text)) && !far().any(crosses)
                })
        };
        let cost = |label: &Label, ring: u32| {
            let covers = line.windows(2).any(|ends| label.text.meets_line(ends[0], ends[1]));
            f64::from(ring) * STEP + if covers { ON_LINE } else { 0.0 }
        };
        let free = || candidates(point, width).filter(|(_, label)| text_is_free(label));
        let cheaper =
            |(r, a): &(u32, Label), (s, b): &(u32, Label)| cost(a, *r).total_cmp(&cost(b, *s));
        let best = free().filter(|(_, label)| leaders_are_free(label)).min_by(cheaper);
        // A crossed leader is better than a covered text.
        let best = best.or_else(|| free().min_by(cheaper));
        let at_point = Label { text: Rect::around(point, width, HEIGHT) };
        labels.push(best.map_or(at_point, |(_, label)| label));
    }
    labels
}

/// Places around a point with their rings, nearest first; right of it, then
/// left, then the others.
fn candidates(point: Point, width: f64) -> impl Iterator<Item = (u32, Label)> {
    (0..RINGS).flat_map(move |ring| {
        let apart = FIRST + STEP * f64::from(ring);
        (0..WAYS).map(move |way| {
            // Half turns first, then quarters, and so on round the clock.
            let turn = f64::from(way / 2) / f64::from(WAYS) + f64::from(way % 2) / 2.0;
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * turn);
            // The text's edge, not its middle, is this far away.
            let x = point.0 + cos * apart + (width / 2.0) * cos.clamp(-0.5, 0.5) * 2.0;
            let y = point.1 + sin * (apart + HEIGHT / 2.0);
            (ring, Label { text: Rect::around((x, y), width, HEIGHT) })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const INSIDE: Rect = Rect { left: 0.0, top: 0.0, right: 600.0, bottom: 350.0 };

    #[test]
    fn labels_of_a_crowd_cover_nothing() {
        let mut random = crate::Random::of_chunk(0, "bench/label", 0);
        for spread in [0.0, 3.0, 20.0, 300.0] {
            for _ in 0..20 {
                let corner = (random.between(0.0, 300.0), random.between(0.0, 50.0));
                let mut any = |from: f64| from + random.between(0.0, spread);
                let points: Vec<_> = (0..11).map(|_| (any(corner.0), any(corner.1))).collect();
                let widths: Vec<_> = (0..11).map(|k| f64::from(80 + 10 * k)).collect();
                let texts = [Rect { left: 100.0, top: 20.0, right: 260.0, bottom: 34.0 }];
                let line = &points[..3];
                let around = Surroundings { inside: INSIDE, texts: &texts, line };
                let labels = place(&points, &widths, &around);
                for (k, label) in labels.iter().enumerate() {
                    assert!(label.text.is_inside(&INSIDE), "{label:?}");
                    assert!(!labels[..k].iter().any(|other| other.text.meets(&label.text)));
                    assert!(!label.text.meets(&texts[0]), "{label:?}");
                    let covers = |&p: &Point| label.text.holds(p);
                    assert!(!points.iter().any(covers), "{label:?} {points:?}");
                }
            }
        }
    }

    #[test]
    fn a_lone_label_is_right_of_its_point_without_a_line() {
        let around = Surroundings { inside: INSIDE, texts: &[], line: &[] };
        let labels = place(&[(100.0, 100.0)], &[50.0], &around);
        assert_eq!(labels[0].text, Rect { left: 107.0, top: 93.0, right: 157.0, bottom: 107.0 });
        assert_eq!(labels[0].leader((100.0, 100.0)), None);
    }
}
