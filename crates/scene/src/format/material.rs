//! Materials as a file has them: by name or in place.

use serde::{Deserialize, Serialize};

use super::Triple;

/// What a surface is made of; see [`tracer::Material`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Material {
    /// One of the file's `materials`.
    Named(String),
    /// This color, unlit.
    Constant {
        /// The color.
        color: Triple,
    },
    /// The normal as a color, unlit.
    Normal,
    /// Uniform scattering.
    Lambert {
        /// Share of light scattered; the shading's default if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
    },
    /// Uniform scattering with a highlight.
    BlinnPhong {
        /// Share of light scattered; the shading's default if not said.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        diffuse: Option<Triple>,
        /// Strength of the highlight.
        specular: Triple,
        /// Sharpness of the highlight.
        exponent: f64,
    },
}

/// A map of materials that refuses a name given twice.
pub(super) mod by_name {
    use std::collections::BTreeMap;
    use std::fmt;

    use serde::de::{Error, MapAccess, Visitor};
    use serde::{Deserializer, Serialize, Serializer};

    use super::Material;

    type Materials = BTreeMap<String, Material>;

    pub(in crate::format) fn serialize<S: Serializer>(
        materials: &Materials,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        materials.serialize(serializer)
    }

    pub(in crate::format) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Materials, D::Error> {
        deserializer.deserialize_map(Unique)
    }

    struct Unique;

    impl<'de> Visitor<'de> for Unique {
        type Value = Materials;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a map of materials by name")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Materials, A::Error> {
            let mut materials = Materials::new();
            while let Some(name) = map.next_key::<String>()? {
                let material = map.next_value()?;
                if materials.insert(name.clone(), material).is_some() {
                    return Err(A::Error::custom(format_args!(
                        "the material \"{name}\" is defined twice"
                    )));
                }
            }
            Ok(materials)
        }
    }
}
