//! Lights of the course: points, whose falloff is the shading's.

use scene::format::Light;

use super::element::{Element, Fields};
use super::reader::Reader;

impl Reader<'_> {
    /// Adds a light. Without a type it is a point light; other kinds are lost,
    /// as none of them is a light of ours: areas, surroundings.
    pub(super) fn light(&mut self, node: Element<'_>) {
        if self.kind(node, Some("PointLight")).as_deref() != Some("pointlight") {
            self.notes.lost(node, "only point lights are known: this one is left out");
            return;
        }
        self.notes.only_attributes(node, &["type"]);
        let fields = Fields::of(node, &["position", "intensity"], &[], &mut self.notes);
        let light = Light::Point {
            position: fields.triple("position", &mut self.notes).unwrap_or_default(),
            intensity: fields.triple("intensity", &mut self.notes).unwrap_or([1.0; 3]),
            falloff: None,
        };
        let problems = self.sense.of(|file| file.lights = vec![light]);
        self.judge(node, problems);
        self.lights.push(light);
    }
}
