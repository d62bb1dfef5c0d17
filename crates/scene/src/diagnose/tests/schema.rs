//! Types that look like those of a scene file.

use std::collections::BTreeMap;

use serde::Deserialize;

type Triple = (f64, f64, f64);

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Scene {
    pub(super) version: u32,
    pub(super) image: (u32, u32),
    pub(super) camera: Camera,
    #[serde(default)]
    pub(super) materials: BTreeMap<String, Material>,
    pub(super) objects: Vec<Object>,
    #[serde(default)]
    pub(super) lights: Vec<Light>,
    pub(super) sky: Option<Triple>,
    pub(super) gain: Option<Gain>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) enum Camera {
    Flat,
    Perspective {
        look_from: Triple,
        look_at: Triple,
        #[serde(default)]
        fov_deg: Option<f64>,
    },
    Thin(Lens),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Lens {
    pub(super) radius: f32,
    pub(super) focus: Option<Color>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Color(pub(super) f64, pub(super) f64, pub(super) f64);

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) enum Material {
    Black,
    Lambert { albedo: Triple },
    Metal { albedo: Triple, fuzz: f64 },
    Dielectric(f64),
    Named(String),
    Mix(String, String, f64),
    Tint(Color),
    Paint { name: String, layers: Vec<u8> },
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) enum Object {
    Sphere {
        center: Triple,
        radius: f64,
        material: String,
    },
    Box {
        min: Triple,
        max: Triple,
        material: String,
    },
    Group {
        #[serde(default)]
        name: Option<String>,
        objects: Vec<Object>,
    },
    Moved(std::boxed::Box<Object>, Triple),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Light {
    pub(super) position: Triple,
    pub(super) power: f64,
    #[serde(default)]
    pub(super) kind: Option<char>,
    #[serde(default)]
    pub(super) on: bool,
}

/// A number that refuses some values.
#[derive(Debug, Deserialize)]
#[serde(try_from = "f64")]
pub(super) struct Gain(pub(super) f64);

impl TryFrom<f64> for Gain {
    type Error = String;

    fn try_from(gain: f64) -> Result<Self, String> {
        if gain > 0.0 { Ok(Self(gain)) } else { Err(format!("a gain is above 0, not {gain}")) }
    }
}
