//! goldray's own scene format as JSON, by `docs/schemas/scene.schema.json`.

use std::collections::BTreeMap;

use scene::{Assets, SceneFile};

use super::{Imported, Source, Unreadable, Wishes};

/// Reads a scene of JSON; the files that it names stay where they are.
///
/// # Errors
/// The first place where it is no JSON, or no scene.
pub(super) fn read(
    source: Source<'_>,
    wishes: &Wishes,
    _: &dyn Assets,
) -> Result<Imported, Vec<Unreadable>> {
    let mut scene: SceneFile = serde_json::from_slice(source.bytes).map_err(|error| {
        // It ends in the place, which is told by itself.
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or_default().to_owned();
        let place = (error.line() > 0).then(|| (error.line(), error.column().max(1)));
        let help = "the format is described by docs/schemas/scene.schema.json".to_owned();
        vec![Unreadable { place, message, help: Some(help) }]
    })?;
    let mut chosen = Vec::new();
    if let Some(camera) = wishes.camera {
        scene.camera = camera;
        chosen.push("the camera that was asked for".to_owned());
    }
    if let Some(image) = wishes.image {
        scene.image = image;
        chosen.push(format!("{} x {} pixels, as was asked", image.0, image.1));
    }
    Ok(Imported { scene, files: BTreeMap::new(), lost: Vec::new(), chosen })
}

#[cfg(test)]
mod tests {
    use scene::NoAssets;

    use super::*;

    const CAMERA: &str =
        r#""camera": {"LookAt": {"eye": [0, 0, 5], "at": [0, 0, 0], "fov_deg": 40}}"#;

    fn asked(text: &str) -> Result<Imported, Vec<Unreadable>> {
        let source = Source { name: "a.json", bytes: text.as_bytes() };
        super::super::import(source, &Wishes::default(), &NoAssets)
    }

    #[track_caller]
    fn check(text: &str, place: (usize, usize), message: &str) {
        let problems = asked(text).unwrap_err();
        assert_eq!(problems.len(), 1);
        assert_eq!(problems[0].place, Some(place), "{problems:?}");
        assert!(problems[0].message.contains(message), "{problems:?}");
    }

    #[test]
    fn what_is_no_scene_is_told_by_its_place() {
        check("", (1, 1), "EOF");
        check("(version: 1)", (1, 1), "expected value");
        check("[]", (1, 2), "");
        check(
            "{\"version\": 1, \"image\": [1, 1],\n \"kamera\": 3}",
            (2, 9),
            "unknown field `kamera`",
        );
        check(&format!("{{\"version\": 1, {CAMERA}}}"), (1, 88), "missing field `image`");
        let twice = r#""materials": {"a": "Normal", "a": "Normal"}"#;
        let text = format!("{{\"version\": 1, \"image\": [1, 1], {CAMERA},\n{twice}}}");
        check(&text, (2, 32), "\"a\" is given twice");
        let huge = text.replace(twice, "\"exposure\": 1e999");
        check(&huge, (2, 17), "number out of range");
        let deep = format!("{}{}", "{\"Group\":{\"objects\":[".repeat(1_000), "]}}".repeat(1_000));
        let deep = text.replace(twice, &format!("\"objects\":[{deep}]"));
        let problems = asked(&deep).unwrap_err();
        assert!(problems[0].message.contains("recursion limit"), "{problems:?}");
        let not_text = Source { name: "a.json", bytes: &[b'{', 0xff, 0xfe] };
        assert!(super::super::import(not_text, &Wishes::default(), &NoAssets).is_err());
    }

    #[test]
    fn wishes_come_before_the_file() {
        let text = format!("{{\"version\": 1, \"image\": [1, 1], {CAMERA}}}");
        let wishes = Wishes { image: Some((7, 5)), ..Wishes::default() };
        let source = Source { name: "A.JSON", bytes: text.as_bytes() };
        let imported = super::super::import(source, &wishes, &NoAssets).unwrap();
        assert_eq!(imported.scene.image, (7, 5));
        assert_eq!(imported.chosen.len(), 1);
    }
}
