//! Spheres, cones and cylinders.

use scene::format::Object;

use super::reader::Reader;
use super::words::Word;

/// The format's way to ask for the inside of a surface alone.
const INSIDE: &str =
    "a negative radius asks for the inside alone, which is not known: it is left out";

impl Reader<'_> {
    /// A center and a radius.
    pub(super) fn sphere(&mut self, word: Word<'_>) -> Option<()> {
        let [x, y, z, radius] = self.numbers(word)?;
        if radius < 0.0 {
            self.lost(word, INSIDE);
            return Some(());
        }
        let material = self.material();
        self.add(word, Object::Sphere { center: [x, y, z], radius, material });
        Some(())
    }

    /// Two points with a radius each. Neither cylinders nor cones have caps.
    pub(super) fn cone(&mut self, word: Word<'_>) -> Option<()> {
        let [bx, by, bz, base_radius, ax, ay, az, apex_radius] = self.numbers(word)?;
        let (base, apex) = ([bx, by, bz], [ax, ay, az]);
        if base_radius < 0.0 || apex_radius < 0.0 {
            self.lost(word, INSIDE);
            return Some(());
        }
        let material = self.material();
        let object = if base_radius == apex_radius {
            Object::Cylinder { a: base, b: apex, radius: base_radius, open: true, material }
        } else if apex_radius == 0.0 {
            Object::Cone { apex, base, radius: base_radius, open: true, material }
        } else if base_radius == 0.0 {
            Object::Cone { apex: base, base: apex, radius: apex_radius, open: true, material }
        } else {
            self.lost(word, "a cone that is cut off at the top is not known: it is left out");
            return Some(());
        };
        self.add(word, object);
        Some(())
    }

    /// Keeps an object that makes sense.
    fn add(&mut self, word: Word<'_>, object: Object) {
        let problems = self.sense.of_object(&object);
        if self.judge(word, problems) {
            self.objects.push(object);
        }
    }
}
