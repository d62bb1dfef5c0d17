//! Surfaces of the course, groups among them.

use roxmltree::Node;
use scene::format::{Material, Object, Transform};

use super::element::{Element, Fields, name_of};
use super::reader::Reader;

/// The most groups in each other: what a scene file can hold.
pub(super) const MOST_GROUPS: usize = 20;

impl Reader<'_> {
    /// A surface inside `depth` groups; `None` with a problem or loss.
    pub(super) fn surface(&mut self, node: Element<'_>, depth: usize) -> Option<Object> {
        self.notes.only_attributes(node, &["type", "name"]);
        let kind = self.kind(node, None)?;
        if kind == "group" {
            return self.group(node, depth);
        }
        let known: &[&'static str] = match &*kind {
            "sphere" => &["shader", "center", "radius"],
            "box" => &["shader", "minpt", "maxpt"],
            "triangle" => &["shader", "a", "b", "c", "v0", "v1", "v2"],
            "plane" => &["shader", "point", "normal"],
            "disk" => &["shader", "center", "normal", "radius"],
            "cylinder" => &["shader", "center", "radius", "height"],
            "mesh" => &["shader", "data"],
            _ => {
                self.notes.lost(node, format!("the type {kind} is not known and is left out"));
                return None;
            }
        };
        let fields = Fields::of(node, known, &[], &mut self.notes);
        let material = fields.get("shader").and_then(|shader| self.material(shader));
        if kind == "mesh" {
            return self.mesh(node, fields.get("data"), material);
        }
        let object = self.simple(&kind, node, &fields, material)?;
        let problems = self.sense.of_object(&object);
        self.judge(node, problems).then_some(object)
    }

    /// A surface of its own numbers alone. Spheres, boxes and cylinders have the
    /// course's defaults; the others have none.
    fn simple(
        &mut self,
        kind: &str,
        node: Element<'_>,
        fields: &Fields<'_>,
        material: Option<Material>,
    ) -> Option<Object> {
        let notes = &mut self.notes;
        let center = fields.triple("center", notes);
        let radius = fields.number("radius", notes);
        Some(match kind {
            "sphere" => Object::Sphere {
                center: center.unwrap_or_default(),
                radius: radius.unwrap_or(1.0),
                material,
            },
            "box" => Object::Box {
                min: fields.triple("minpt", notes).unwrap_or_default(),
                max: fields.triple("maxpt", notes).unwrap_or_default(),
                material,
            },
            "cylinder" => {
                let [x, y, z] = center.unwrap_or_default();
                let half = 0.5 * fields.number("height", notes).unwrap_or(1.0);
                notes.report.chose(
                    "cylinders stand along z around their center, with caps, as the course's \
                     solution of 2017 has them",
                );
                let (a, b) = ([x, y, z - half], [x, y, z + half]);
                Object::Cylinder { a, b, radius: radius.unwrap_or(1.0), open: false, material }
            }
            "plane" => {
                let [point, normal] = self.required(node, fields, [&["point"], &["normal"]])?;
                Object::Plane { point, normal, material }
            }
            "disk" => {
                let [center, normal] = self.required(node, fields, [&["center"], &["normal"]])?;
                Object::Disk { center, normal, radius: radius.unwrap_or(1.0), material }
            }
            _ => {
                let names = [&["a", "v0"], &["b", "v1"], &["c", "v2"]].map(<[&str; 2]>::as_slice);
                let [a, b, c] = self.required(node, fields, names)?;
                Object::Triangle { a, b, c, material }
            }
        })
    }

    /// Fields that have no default, each by any of its names.
    fn required<const N: usize>(
        &mut self,
        node: Element<'_>,
        fields: &Fields<'_>,
        names: [&[&str]; N],
    ) -> Option<[[f64; 3]; N]> {
        let mut found = [[0.0; 3]; N];
        let mut all = true;
        for (slot, names) in found.iter_mut().zip(names) {
            let Some(name) = names.iter().find(|name| fields.get(name).is_some()) else {
                let what = format!("expected an element {}, found none", names.join(" or "));
                self.notes.unreadable(node, &what, None);
                all = false;
                continue;
            };
            match fields.triple(name, &mut self.notes) {
                Some(triple) => *slot = triple,
                None => all = false,
            }
        }
        all.then_some(found)
    }

    /// Surfaces in a space of their own. Translations, rotations (about x, then
    /// y, then z, in degrees) and scales are applied in the file's order, the
    /// group around it after them.
    fn group(&mut self, node: Element<'_>, depth: usize) -> Option<Object> {
        const STEPS: [&str; 3] = ["translate", "rotate", "scale"];
        if depth == MOST_GROUPS {
            let what = format!("expected at most {MOST_GROUPS} groups in each other, found more");
            self.notes.unreadable(node, &what, None);
            return None;
        }
        let elsewhere = ["surface", STEPS[0], STEPS[1], STEPS[2]];
        let fields = Fields::of(node, &["shader"], &elsewhere, &mut self.notes);
        let material = fields.get("shader").and_then(|shader| self.material(shader));
        let (mut transform, mut objects) = (Vec::new(), Vec::new());
        for child in node.children().filter(Node::is_element) {
            let make: fn(f64, f64, f64) -> Transform = match name_of(child).as_str() {
                "surface" => {
                    objects.extend(self.surface(child, depth + 1));
                    continue;
                }
                "translate" => Transform::Translate,
                "rotate" => Transform::RotateDeg,
                "scale" => Transform::Scale,
                _ => continue,
            };
            let Some([x, y, z]) = self.notes.numbers(child) else { continue };
            let step = make(x, y, z);
            let alone =
                Object::Group { transform: vec![step], objects: Vec::new(), material: None };
            let problems = self.sense.of_object(&alone);
            if self.judge(child, problems) {
                transform.push(step);
            }
        }
        Some(Object::Group { transform, objects, material })
    }
}
