//! `Document`: the JSON of a glTF file, as far as it is read.
//!
//! Source: "glTF 2.0 Specification", The Khronos Group, 2021, section
//! "JSON Schema Reference"; the extensions `KHR_lights_punctual` and
//! `KHR_materials_unlit`, `_transmission`, `_ior` and `_volume`. Names are theirs.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde::de::{IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

macro_rules! objects {
    ($($(#[$doc:meta])* $name:ident { $($(#[$attribute:meta])* $field:ident: $type:ty,)* })*) => {
        $(
            $(#[$doc])*
            #[derive(Debug, Default, Deserialize)]
            #[serde(rename_all = "camelCase", default)]
            pub(super) struct $name { $($(#[$attribute])* pub(super) $field: $type,)* }
        )*
    };
}

objects! {
    /// The whole.
    Document {
        asset: Asset,
        scene: Option<usize>,
        scenes: Vec<Scene>,
        nodes: Vec<Node>,
        meshes: Vec<Mesh>,
        accessors: Vec<Accessor>,
        buffer_views: Vec<BufferView>,
        buffers: Vec<Buffer>,
        materials: Vec<Material>,
        textures: Vec<Texture>,
        images: Vec<Image>,
        samplers: Vec<Sampler>,
        cameras: Vec<Camera>,
        animations: Vec<IgnoredAny>,
        extensions_used: Vec<String>,
        extensions_required: Vec<String>,
        extensions: Extensions,
    }
    /// What the file is.
    Asset {
        version: String,
        min_version: Option<String>,
    }
    /// Nodes without parents.
    Scene {
        nodes: Vec<usize>,
    }
    /// A space of its own, and what is in it.
    Node {
        children: Vec<usize>,
        mesh: Option<usize>,
        camera: Option<usize>,
        skin: Option<usize>,
        matrix: Option<[f64; 16]>,
        translation: Option<[f64; 3]>,
        rotation: Option<[f64; 4]>,
        scale: Option<[f64; 3]>,
        weights: Vec<f64>,
        extensions: Extensions,
    }
    /// A body of one or more parts.
    Mesh {
        primitives: Vec<Primitive>,
        weights: Vec<f64>,
    }
    /// A part of one material.
    Primitive {
        attributes: BTreeMap<String, usize>,
        indices: Option<usize>,
        material: Option<usize>,
        mode: Option<u32>,
        targets: Vec<IgnoredAny>,
        extensions: Extensions,
    }
    /// Numbers of one type.
    Accessor {
        buffer_view: Option<usize>,
        byte_offset: u64,
        component_type: u32,
        normalized: bool,
        count: u64,
        #[serde(rename = "type")]
        shape: String,
        sparse: Option<Sparse>,
    }
    /// Those of them that are others.
    Sparse {
        count: u64,
        indices: SparsePart,
        values: SparsePart,
    }
    /// Where they are.
    SparsePart {
        buffer_view: usize,
        byte_offset: u64,
        component_type: u32,
    }
    /// A stretch of a buffer.
    BufferView {
        buffer: usize,
        byte_offset: u64,
        byte_length: u64,
        byte_stride: Option<u64>,
    }
    /// Bytes.
    Buffer {
        uri: Option<String>,
        byte_length: u64,
    }
    /// What a surface is made of.
    Material {
        name: Option<String>,
        pbr_metallic_roughness: Metal,
        normal_texture: Option<IgnoredAny>,
        occlusion_texture: Option<IgnoredAny>,
        emissive_texture: Option<IgnoredAny>,
        emissive_factor: [f64; 3],
        alpha_mode: Option<String>,
        double_sided: bool,
        extensions: Extensions,
    }
    /// Its colors, and how much it is a metal and how rough.
    Metal {
        base_color_factor: Option<[f64; 4]>,
        base_color_texture: Option<TextureInfo>,
        metallic_factor: Option<f64>,
        roughness_factor: Option<f64>,
        metallic_roughness_texture: Option<IgnoredAny>,
    }
    /// A texture where a material names it.
    TextureInfo {
        index: usize,
        tex_coord: usize,
        extensions: Extensions,
    }
    /// A picture and how it is seen.
    Texture {
        sampler: Option<usize>,
        source: Option<usize>,
        extensions: Extensions,
    }
    /// A picture, at an address or in a view.
    Image {
        uri: Option<String>,
        mime_type: Option<String>,
        buffer_view: Option<usize>,
    }
    /// What is seen between its texels and beyond its borders.
    Sampler {
        mag_filter: Option<u32>,
        wrap_s: Option<u32>,
        wrap_t: Option<u32>,
    }
    /// How much goes through a surface.
    Transmission {
        transmission_factor: f64,
        transmission_texture: Option<IgnoredAny>,
    }
    /// The index of refraction.
    Ior {
        ior: Option<f64>,
    }
    /// What is behind a surface: nothing without a thickness.
    Volume {
        thickness_factor: f64,
        thickness_texture: Option<IgnoredAny>,
        attenuation_distance: Option<f64>,
    }
    /// A camera, of one kind or the other.
    Camera {
        perspective: Option<Perspective>,
        orthographic: Option<Orthographic>,
    }
    /// The angle from bottom to top in radians, and width over height.
    Perspective {
        yfov: f64,
        aspect_ratio: Option<f64>,
    }
    /// Half the width and half the height.
    Orthographic {
        xmag: f64,
        ymag: f64,
    }
    /// Extensions that are read, and the names of others.
    Extensions {
        #[serde(rename = "KHR_lights_punctual")]
        lights: Option<Lights>,
        #[serde(rename = "KHR_materials_unlit")]
        unlit: Option<IgnoredAny>,
        #[serde(rename = "KHR_materials_transmission")]
        transmission: Option<Transmission>,
        #[serde(rename = "KHR_materials_ior")]
        ior: Option<Ior>,
        #[serde(rename = "KHR_materials_volume")]
        volume: Option<Volume>,
        #[serde(flatten)]
        others: Names,
    }
    /// The lights of a document, or the light of a node.
    Lights {
        lights: Vec<Light>,
        light: Option<usize>,
    }
    /// A light.
    Light {
        #[serde(rename = "type")]
        kind: String,
        color: Option<[f64; 3]>,
        intensity: Option<f64>,
        range: Option<f64>,
    }
}

/// The names of a map, whatever they stand for.
#[derive(Debug, Default)]
pub(super) struct Names(pub(super) BTreeSet<String>);

impl<'de> Deserialize<'de> for Names {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OfMap;
        impl<'de> Visitor<'de> for OfMap {
            type Value = Names;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a map by names")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Names, A::Error> {
                let mut names = BTreeSet::new();
                while let Some((name, IgnoredAny)) = map.next_entry()? {
                    names.insert(name);
                }
                Ok(Names(names))
            }
        }
        deserializer.deserialize_map(OfMap)
    }
}
