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
}

impl Fill {
    /// The part of it that is lit: Lambert of `Kd` times the color, and a white
    /// highlight of `Ks` about the half vector, with the exponent `Shine`.
    fn lit(&self) -> Material {
        let diffuse = Some(self.color.map(|c| c * self.kd));
        if self.ks > 0.0 && self.shine > 0.0 {
            Material::BlinnPhong { diffuse, specular: [self.ks; 3], exponent: self.shine }
        } else {
            Material::Lambert { diffuse }
        }
    }
}

impl Reader<'_> {
    /// What is everything made of that follows. Equal fills are one material.
    pub(super) fn fill(&mut self, word: Word<'_>) -> Option<()> {
        let [red, green, blue, kd, ks, shine, t, _ior] = self.numbers(word)?;
        let fill = Fill { color: [red, green, blue], kd, ks, shine, t };
        let shares = [("Kd", kd), ("Ks", ks), ("T", t)];
        for (name, share) in shares {
            if share < 0.0 {
                let message = format!("f: expected {name} of 0 or more, found {share:?}");
                self.unreadable(word.at, message);
            }
        }
        if fill.ks > 0.0 {
            self.lost(word, format!("its mirror, Ks = {ks:?}, is left out: its highlight stays"));
            if fill.shine <= 0.0 {
                self.lost(word, format!("a highlight of the exponent {shine:?} is left out"));
            }
            self.report.chose(
                "highlights are white, of the strength Ks, about the half vector (Blinn-Phong)",
            );
        }
        if fill.t > 0.0 {
            self.lost(word, format!("what shines through, T = {t:?}, is left out"));
        }
        let material = fill.lit();
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
