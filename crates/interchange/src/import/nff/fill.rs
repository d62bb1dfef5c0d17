//! Fills: a color with its shares of scattered, mirrored and refracted light.

use scene::format::Material;

use super::reader::Reader;
use super::words::Word;

/// The numbers of a fill.
struct Fill {
    color: [f64; 3],
    kd: f64,
    ks: f64,
    shine: f64,
    t: f64,
    ior: f64,
}

impl Fill {
    /// Lambert of `Kd` times the color, a white highlight of `Ks` about the half
    /// vector with the exponent `Shine`, `Ks` of what is mirrored and `T` of what
    /// shines through.
    fn material(&self) -> Material {
        let diffuse = Some(self.color.map(|c| c * self.kd));
        if self.ks <= 0.0 && self.t <= 0.0 {
            return Material::Lambert { diffuse, texture: None };
        }
        let has_highlight = self.ks > 0.0 && self.shine > 0.0;
        let (specular, exponent) = if has_highlight { (self.ks, self.shine) } else { (0.0, 1.0) };
        Material::Whitted {
            diffuse,
            specular: [specular; 3],
            exponent,
            reflect: [self.ks; 3],
            transmit: [self.t; 3],
            // Of what nothing goes through it has no bearing, and is often 0.
            ior: if self.t > 0.0 { self.ior } else { 1.0 },
            schlick: false,
            texture: None,
        }
    }
}

impl Reader<'_> {
    /// What is everything made of that follows. Equal fills are one material.
    pub(super) fn fill(&mut self, word: Word<'_>) -> Option<()> {
        let [red, green, blue, kd, ks, shine, t, ior] = self.numbers(word)?;
        let fill = Fill { color: [red, green, blue], kd, ks, shine, t, ior };
        let shares = [("Kd", kd), ("Ks", ks), ("T", t)];
        for (name, share) in shares {
            if share < 0.0 {
                let message = format!("f: expected {name} of 0 or more, found {share:?}");
                self.unreadable(word.at, message);
            }
        }
        if ks > 0.0 {
            if shine <= 0.0 {
                self.lost(word, format!("a highlight of the exponent {shine:?} is left out"));
            }
            self.report.chose(
                "highlights are white, of the strength Ks, about the half vector (Blinn-Phong)",
            );
        }
        if ks > 0.0 || t > 0.0 {
            let bounces = self.sense.blank().bounces;
            self.report.chose(format!(
                "Ks and T are the shares of what the mirrored and the refracted ray see, at every \
                 angle, as in Whitted's paper; rays are followed over {bounces} surfaces, as the \
                 format says no depth"
            ));
        }
        let material = fill.material();
        let problems = self.sense.of_material(&material);
        if !self.judge(word, problems) {
            return Some(());
        }
        let known = self.materials.iter().find(|(_, known)| **known == material);
        let name = if let Some((name, _)) = known {
            name.clone()
        } else {
            let name = format!("f{}", self.materials.len() + 1);
            self.materials.insert(name.clone(), material);
            name
        };
        self.fill = Some(name);
        Some(())
    }

    /// The material of an object that stands here.
    pub(super) fn material(&mut self) -> Option<Material> {
        if self.fill.is_none() {
            self.report.chose("what stands before the first fill is white");
        }
        self.fill.clone().map(Material::Named)
    }
}
