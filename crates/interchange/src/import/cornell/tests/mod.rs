//! The course's files: ugly ones, what they mean, the files that they name.

mod files;
mod meaning;
mod specular;
mod ugly;

use scene::NoAssets;

use crate::import::{Imported, Lost, Source, Unreadable, Wishes, import};

const BALL: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<scene>
  <camera><viewPoint>0 0 5</viewPoint></camera>
  <image>4 3</image>
  <surface type="Sphere"/>
</scene>
"#;

fn read(text: impl AsRef<[u8]>) -> Result<Imported, Vec<Unreadable>> {
    let source = Source { name: "a.xml", bytes: text.as_ref() };
    import(source, &Wishes::default(), &NoAssets)
}

/// A scene with this beside the camera, the image and a ball.
fn with(more: &str) -> Result<Imported, Vec<Unreadable>> {
    read(BALL.replace("</scene>", &format!("{more}</scene>")))
}

/// The problems of a text, each beginning with its place.
#[track_caller]
fn refuses(text: impl AsRef<[u8]>, expected: &[&str]) {
    let problems = read(text).unwrap_err();
    let line = |p: &Unreadable| match p.place {
        Some((line, column)) => format!("{line}:{column}: {}", p.message),
        None => p.message.clone(),
    };
    let found: Vec<_> = problems.iter().map(line).collect();
    let fit = found.iter().zip(expected).all(|(found, expected)| found.contains(expected));
    assert!(fit && found.len() == expected.len(), "{found:#?}");
}

/// What is lost of a text, as `line:column: element: what`.
#[track_caller]
fn loses(more: &str, expected: &[&str]) -> Imported {
    let imported = with(more).unwrap();
    let line = |lost: &Lost| {
        let (line, column) = lost.place.unwrap_or_default();
        format!("{line}:{column}: {}: {}", lost.element, lost.what)
    };
    let found: Vec<_> = imported.lost.iter().map(line).collect();
    let fit = found.iter().zip(expected).all(|(found, expected)| found.contains(expected));
    assert!(fit && found.len() == expected.len(), "{found:#?}");
    imported.text("a.xml").unwrap();
    imported
}
