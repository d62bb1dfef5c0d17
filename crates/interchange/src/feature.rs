//! `Feature`: what a scene asks of a renderer, in words that a scorecard has
//! rows for.

use std::collections::BTreeSet;
use std::fmt;

use scene::SceneFile;
use scene::format::{
    Camera, Falloff, Filter, Light, Material, Object, Sampler, Shading, Show, Texture,
};
use serde::{Deserialize, Serialize};

/// Makes the enum of all features from one list, by family.
macro_rules! features {
    ($($family:literal: { $($(#[$doc:meta])* $name:ident,)* })*) => {
        /// What a scene asks of a renderer.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Feature {
            $($($(#[$doc])* $name,)*)*
        }

        impl Feature {
            /// All of them, by family.
            pub const ALL: &[Self] = &[$($(Self::$name,)*)*];

            /// Its name, as in adapters and scorecards.
            pub fn name(self) -> &'static str {
                match self { $($(Self::$name => stringify!($name),)*)* }
            }

            /// What kind of feature it is.
            pub fn family(self) -> &'static str {
                match self { $($(Self::$name)|* => $family,)* }
            }
        }
    };
}

features! {
    "cameras": {
        /// Rays from a point.
        Perspective,
        /// Rays side by side.
        Parallel,
        /// A window that is not across the view.
        Oblique,
        /// Pixels that are not square.
        StretchedPixels,
    }
    "shapes": {
        /// A sphere.
        Sphere,
        /// A triangle.
        Triangle,
        /// A box along the axes.
        Box,
        /// A plane without end.
        Plane,
        /// A disk.
        Disk,
        /// A cylinder with caps.
        Cylinder,
        /// One without.
        OpenCylinder,
        /// A cone with its base.
        Cone,
        /// One without.
        OpenCone,
        /// A torus.
        Torus,
        /// A mesh.
        Mesh,
        /// Shapes in a space of their own.
        Group,
        /// A round shape, or a mesh with normals, under a transform that does not
        /// keep angles.
        StretchedRound,
    }
    "materials": {
        /// A color without light.
        Constant,
        /// The normal as a color.
        NormalMaterial,
        /// Lambert's cosine law.
        Lambert,
        /// Blinn and Phong's highlight.
        BlinnPhong,
        /// One that is not gray.
        ColoredHighlight,
    }
    "mirrors and glass": {
        /// A mirror.
        Mirror,
        /// Refraction, Fresnel's reflection and total internal reflection.
        Dielectric,
        /// Whitted's sum of light, reflection and transmission.
        Whitted,
        /// A clear coat by Fresnel's equations.
        Glazed,
        /// Schlick's law for what is reflected.
        Schlick,
        /// Glass or a glaze that is met within other glass. Only where the picture
        /// shows it.
        NestedGlass,
        /// Glass that is met from behind by a ray that has not entered it, unless the
        /// eye is in it and in nothing else. Only where the picture shows it.
        GlassFromBehind,
        /// Total reflection by Whitted's sum. Only where the picture shows it.
        TotalReflection,
    }
    "textures": {
        /// Two colors by turns.
        CheckerTexture,
        /// A picture.
        ImageTexture,
    }
    "lights": {
        /// A light at a point, as bright at any distance.
        ConstantPointLight,
        /// A light at a point, by the inverse square of the distance.
        InverseSquarePointLight,
        /// A light without end, from one direction.
        DirectionalLight,
        /// Light from everywhere.
        AmbientLight,
        /// More than one at a point or from a direction.
        SeveralLights,
        /// Shadows.
        Shadows,
        /// Lights without shadows.
        NoShadows,
        /// Surfaces that are too near to each other for a shadow, by the gap that
        /// the convention leaves. Only where the picture shows it.
        ShadowGap,
    }
    "shading": {
        /// The lecture's: `kd max(n.l, 0)`.
        Classic,
        /// The same by the inverse square.
        Attenuated,
        /// `kd / pi`, the highlight times the cosine.
        Radiometric,
        /// Surfaces that show their backs, by a normal that is not turned. Only where
        /// the picture shows it.
        BackSides,
        /// A highlight of a light that is behind the surface, or on a back side. Only
        /// where the picture shows it.
        HighlightFromBehind,
    }
    "pictures": {
        /// White where something is.
        Silhouette,
        /// Colors without light.
        SurfaceColor,
        /// Normals.
        Normals,
        /// Distances.
        Depth,
        /// A color for each object.
        ObjectIds,
        /// A background that is not black.
        Background,
        /// An exposure other than 1.
        Exposure,
    }
    "samples": {
        /// Several in each pixel, on a grid.
        GridSamples,
        /// Scattered ones.
        ScatteredSamples,
        /// Samples that count for the pixels around.
        PixelFilter,
        /// Samples where the error is.
        AdaptiveSamples,
    }
}

impl Feature {
    /// Whether a file alone does not say that it is asked for: objects must be in their
    /// places, lights that shine known, the picture looked at. [`features`] is without
    /// these, [`asks`](crate::export::asks) has them.
    pub fn is_seen(self) -> bool {
        matches!(
            self,
            Self::StretchedRound
                | Self::ColoredHighlight
                | Self::SeveralLights
                | Self::ShadowGap
                | Self::BackSides
                | Self::HighlightFromBehind
                | Self::NestedGlass
                | Self::GlassFromBehind
                | Self::TotalReflection
        )
    }
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Everything that a scene asks for as its file says it, but for what must be looked for
/// ([`Feature::is_seen`]). What a picture does not need is not asked: a silhouette asks
/// for no light and no material.
pub fn features<C>(file: &SceneFile<C>) -> BTreeSet<Feature> {
    let mut found = BTreeSet::new();
    of_camera(file, &mut found);
    found.extend(match file.show {
        Show::Shaded => None,
        Show::Silhouette => Some(Feature::Silhouette),
        Show::SurfaceColor => Some(Feature::SurfaceColor),
        Show::Normals => Some(Feature::Normals),
        Show::Depth { .. } => Some(Feature::Depth),
        Show::ObjectIds => Some(Feature::ObjectIds),
    });
    let needs_materials = matches!(file.show, Show::Shaded | Show::SurfaceColor);
    let mut materials = BTreeSet::new();
    of_objects(file, &file.objects, None, &mut found, &mut materials);
    if needs_materials {
        found.extend(&materials);
    }
    if file.background != [0.0; 3] {
        found.insert(Feature::Background);
    }
    if file.show == Show::Shaded {
        if file.exposure != 1.0 {
            found.insert(Feature::Exposure);
        }
        let lit = [Feature::Lambert, Feature::BlinnPhong, Feature::Whitted, Feature::Glazed];
        let is_lit = lit.iter().any(|material| materials.contains(material));
        if is_lit {
            of_lights(file, &mut found);
        }
    }
    of_samples(file, &mut found);
    found
}

fn of_camera<C>(file: &SceneFile<C>, found: &mut BTreeSet<Feature>) {
    /// How far two directions may be apart that count as one.
    const NEAR: f64 = 1e-12;
    let (kind, window, dir, normal) = match &file.camera {
        Camera::Perspective { view_dir, proj_normal, view_width, view_height, .. } => {
            (Feature::Perspective, Some((*view_width, *view_height)), *view_dir, *proj_normal)
        }
        Camera::Parallel { view_dir, proj_normal, view_width, view_height, .. } => {
            (Feature::Parallel, Some((*view_width, *view_height)), *view_dir, *proj_normal)
        }
        Camera::LookAt { .. } => (Feature::Perspective, None, [0.0; 3], None),
    };
    found.insert(kind);
    let (nx, ny) = (f64::from(file.image.0), f64::from(file.image.1));
    if window.is_some_and(|(w, h)| (w * ny - h * nx).abs() > NEAR * (w * ny).abs()) {
        found.insert(Feature::StretchedPixels);
    }
    let unit = |v: [f64; 3]| tracer::glam::DVec3::from(v).normalize_or_zero();
    if normal.is_some_and(|normal| (unit(normal) + unit(dir)).length() > NEAR) {
        found.insert(Feature::Oblique);
    }
}

fn of_objects<C>(
    file: &SceneFile<C>,
    objects: &[Object],
    inherited: Option<&Material>,
    found: &mut BTreeSet<Feature>,
    materials: &mut BTreeSet<Feature>,
) {
    for object in objects {
        let material = object.material().or(inherited);
        let shape = match object {
            Object::Group { objects, .. } => {
                found.insert(Feature::Group);
                of_objects(file, objects, material, found, materials);
                continue;
            }
            Object::Sphere { .. } => Feature::Sphere,
            Object::Triangle { .. } => Feature::Triangle,
            Object::Box { .. } => Feature::Box,
            Object::Plane { .. } => Feature::Plane,
            Object::Disk { .. } => Feature::Disk,
            Object::Torus { .. } => Feature::Torus,
            Object::Cylinder { open: true, .. } => Feature::OpenCylinder,
            Object::Cylinder { .. } => Feature::Cylinder,
            Object::Cone { open: true, .. } => Feature::OpenCone,
            Object::Cone { .. } => Feature::Cone,
            Object::Mesh { .. } => Feature::Mesh,
        };
        found.insert(shape);
        let named = material.and_then(|material| file.resolved(material));
        materials.extend(named.and_then(Material::texture).map(|texture| match texture {
            Texture::Checker { .. } => Feature::CheckerTexture,
            Texture::Image { .. } => Feature::ImageTexture,
        }));
        materials.insert(match named {
            // A name that nothing has is a problem of the scene, not a feature.
            None | Some(Material::Lambert { .. } | Material::Named(_)) => Feature::Lambert,
            Some(Material::Constant { .. }) => Feature::Constant,
            Some(Material::Normal) => Feature::NormalMaterial,
            Some(Material::BlinnPhong { .. }) => Feature::BlinnPhong,
            Some(Material::Mirror { .. }) => Feature::Mirror,
            Some(Material::Dielectric { .. }) => Feature::Dielectric,
            Some(Material::Whitted { .. }) => Feature::Whitted,
            Some(Material::Glazed { .. }) => Feature::Glazed,
        });
        if let Some(
            Material::Mirror { schlick: true, .. }
            | Material::Dielectric { schlick: true, .. }
            | Material::Whitted { schlick: true, .. }
            | Material::Glazed { schlick: true, .. },
        ) = named
        {
            materials.insert(Feature::Schlick);
        }
    }
}

fn of_lights<C>(file: &SceneFile<C>, found: &mut BTreeSet<Feature>) {
    let default = match file.shading {
        Shading::Classic => Falloff::Constant,
        Shading::Attenuated | Shading::Radiometric => Falloff::InverseSquare,
    };
    found.insert(match file.shading {
        Shading::Classic => Feature::Classic,
        Shading::Attenuated => Feature::Attenuated,
        Shading::Radiometric => Feature::Radiometric,
    });
    let mut casts = false;
    for light in &file.lights {
        found.insert(match light {
            Light::Point { falloff, .. } => match falloff.unwrap_or(default) {
                Falloff::Constant => Feature::ConstantPointLight,
                Falloff::InverseSquare => Feature::InverseSquarePointLight,
            },
            Light::Directional { .. } => Feature::DirectionalLight,
            Light::Ambient { .. } => Feature::AmbientLight,
        });
        casts |= !matches!(light, Light::Ambient { .. });
    }
    if casts {
        found.insert(if file.shadows { Feature::Shadows } else { Feature::NoShadows });
    }
}

fn of_samples<C>(file: &SceneFile<C>, found: &mut BTreeSet<Feature>) {
    if !matches!(file.sampler, Sampler::Grid) {
        found.insert(Feature::ScatteredSamples);
    } else if file.samples_per_pixel > 1 {
        found.insert(Feature::GridSamples);
    }
    if !matches!(file.filter, Filter::Box) {
        found.insert(Feature::PixelFilter);
    }
    if file.error.is_some() {
        found.insert(Feature::AdaptiveSamples);
    }
}

#[cfg(test)]
mod tests;
