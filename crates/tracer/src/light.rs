//! `Light`: where light comes from.

use glam::DVec3;

use crate::fault::{Fault, seeded};
use crate::refused::{color, direction, point};
use crate::{Refused, Rgb, UnitVec};

/// How a point light's contribution depends on its distance `r`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Falloff {
    /// Not at all: the 2011 assignment.
    Constant,
    /// As `1 / r^2`: the physical law.
    InverseSquare,
}

/// A light. Intensities are linear, of any size, never negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light(pub(crate) Kind);

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Point { position: DVec3, intensity: Rgb, falloff: Falloff },
    Directional { to_light: UnitVec, intensity: Rgb },
    Ambient { intensity: Rgb },
}

impl Light {
    /// How much light it gives, wherever it is seen from.
    pub(crate) fn intensity(&self) -> Rgb {
        match self.0 {
            Kind::Point { intensity, .. }
            | Kind::Directional { intensity, .. }
            | Kind::Ambient { intensity } => intensity,
        }
    }

    /// Whether something may be in its way.
    pub(crate) fn casts_shadows(&self) -> bool {
        !matches!(self.0, Kind::Ambient { .. })
    }

    /// A light at a point, with hard shadows.
    ///
    /// # Errors
    /// Refuses numbers that are not finite and a negative intensity.
    pub fn point(position: DVec3, intensity: Rgb, falloff: Falloff) -> Result<Self, Refused> {
        Refused::unless([point("position", position), color("intensity", intensity)])?;
        Ok(Self(Kind::Point { position, intensity, falloff }))
    }

    /// A light infinitely far away whose light travels along `travel`, of any
    /// length, with hard shadows.
    ///
    /// # Errors
    /// Refuses (as `direction`) a direction of no length, and a negative
    /// intensity.
    pub fn directional(travel: DVec3, intensity: Rgb) -> Result<Self, Refused> {
        Refused::unless([direction("direction", travel), color("intensity", intensity)])?;
        let travel = if seeded(Fault::DirectionReversed) { -travel } else { travel };
        let to_light = UnitVec::new(-travel).unwrap_or(UnitVec::Z);
        Ok(Self(Kind::Directional { to_light, intensity }))
    }

    /// Light from everywhere, without shadows: adds the surface's diffuse
    /// color times `intensity`, in every shading convention.
    ///
    /// # Errors
    /// Refuses a negative intensity.
    pub fn ambient(intensity: Rgb) -> Result<Self, Refused> {
        Refused::unless([color("intensity", intensity)])?;
        Ok(Self(Kind::Ambient { intensity }))
    }
}
