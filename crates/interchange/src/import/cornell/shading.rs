//! Which of the three shading conventions a file means.
//!
//! It is not in the file, so it is guessed from what each year's files look
//! like, and what was guessed is said:
//!
//! | found in the file | taken for |
//! |---|---|
//! | elements of "Ray 2", 2017: `Group`, `Glass`, `Glazed`, `CookTorrance` | attenuated |
//! | else a camera with a type, an exposure or a background, as of 2018 and 2019 | radiometric |
//! | none of these, as of 2011 to 2013 | classic |
//!
//! Files of "Ray 1" of 2015 and 2017 look like those of 2018 and are attenuated:
//! whoever has them says so.

use scene::format::Shading;

use super::element::{Element, attribute, name_of};

/// The convention that a scene seems to mean, and why.
pub(super) fn guess(scene: Element<'_>) -> (Shading, String) {
    const RAY_2: [&str; 4] = ["group", "glass", "glazed", "cooktorrance"];
    let elements = || scene.descendants().filter(Element::is_element);
    let kind = |node: Element<'_>| -> String {
        attribute(node, "type").unwrap_or_default().to_ascii_lowercase()
    };
    let of_ray_2 = elements().find(|node| RAY_2.contains(&kind(*node).as_str()));
    let is_later = |node: &Element<'_>| match name_of(*node).as_str() {
        "exposure" | "backcolor" | "background" => true,
        "camera" => matches!(kind(*node).as_str(), "perspectivecamera" | "orthographiccamera"),
        _ => false,
    };
    match (of_ray_2, elements().find(is_later)) {
        (Some(node), _) => {
            let why = format!("it has the type {}", kind(node));
            (Shading::Attenuated, why)
        }
        (None, Some(node)) => {
            let why = match name_of(node).as_str() {
                "camera" => "its camera has a type".to_owned(),
                name => format!("it has the element {name}"),
            };
            (Shading::Radiometric, why)
        }
        (None, None) => {
            let why = "its camera has no type, and it has neither exposure nor background";
            (Shading::Classic, why.to_owned())
        }
    }
}
