//! `Word`: a word of a command, with holes for what differs from scene to scene.

use std::fmt;

/// What the holes of a command are filled with.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Filling {
    /// The scene file, relative to where the program is run.
    pub scene: String,
    /// The picture to be written, relative to there.
    pub output: String,
    /// The picture's width in pixels.
    pub width: u32,
    /// The picture's height in pixels.
    pub height: u32,
    /// Samples in each pixel.
    pub samples: u32,
    /// The convention of shading: `classic`, `attenuated` or `radiometric`.
    pub shading: &'static str,
    /// The adapter's own folder.
    pub folder: String,
    /// The suite's folder.
    pub root: String,
    /// This very program.
    pub program: String,
}

/// The holes by their names, and whether they are known before there is a scene.
const HOLES: [(&str, bool); 9] = [
    ("scene", false),
    ("output", false),
    ("width", false),
    ("height", false),
    ("samples", false),
    ("shading", false),
    ("folder", true),
    ("root", true),
    ("self", true),
];

/// A word with holes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word(Vec<Part>);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    Text(String),
    /// One of [`HOLES`].
    Hole(&'static str),
}

impl Word {
    /// Reads a word: a hole is a name in braces, a brace itself is written twice.
    ///
    /// # Errors
    /// What is wrong with it, and what helps.
    pub(super) fn read(text: &str) -> Result<Self, (String, Option<String>)> {
        let twice = || Some("a brace itself is written twice: {{ or }}".to_owned());
        let mut parts = Vec::new();
        let mut plain = String::new();
        let mut rest = text;
        if text.contains('\0') {
            let found = scene::visible(text);
            let found: String = found.chars().take(40).collect();
            let message = format!("expected a word without zero bytes, found \"{found}\"");
            let help = "no command can have one; take it out".to_owned();
            return Err((message, Some(help)));
        }
        while let Some(at) = rest.find(['{', '}']) {
            plain.push_str(&rest[..at]);
            rest = &rest[at..];
            if let Some(after) = rest.strip_prefix("{{").or(rest.strip_prefix("}}")) {
                plain.push_str(&rest[..1]);
                rest = after;
                continue;
            }
            let inside = rest.strip_prefix('{').and_then(|inside| inside.split_once('}'));
            let Some((name, after)) = inside else {
                return Err((format!("expected braces in pairs, found \"{text}\""), twice()));
            };
            let Some((hole, _)) = HOLES.iter().find(|(hole, _)| *hole == name) else {
                return Err((unknown(name), twice()));
            };
            if !plain.is_empty() {
                parts.push(Part::Text(std::mem::take(&mut plain)));
            }
            parts.push(Part::Hole(hole));
            rest = after;
        }
        plain.push_str(rest);
        if !plain.is_empty() {
            parts.push(Part::Text(plain));
        }
        Ok(Self(parts))
    }

    /// Whether it has a hole of this name.
    pub(super) fn names(&self, name: &str) -> bool {
        self.0.iter().any(|part| matches!(part, Part::Hole(hole) if *hole == name))
    }

    /// Its first hole that cannot be filled before there is a scene.
    pub(super) fn of_a_scene(&self) -> Option<&'static str> {
        let late = HOLES.iter().filter(|(_, is_early)| !is_early);
        late.map(|(name, _)| *name).find(|name| self.names(name))
    }

    /// The word as it is given to the program.
    pub fn filled(&self, with: &Filling) -> String {
        let part = |part: &Part| match part {
            Part::Text(text) => text.clone(),
            Part::Hole("scene") => with.scene.clone(),
            Part::Hole("output") => with.output.clone(),
            Part::Hole("width") => with.width.to_string(),
            Part::Hole("height") => with.height.to_string(),
            Part::Hole("samples") => with.samples.to_string(),
            Part::Hole("shading") => with.shading.to_owned(),
            Part::Hole("folder") => with.folder.clone(),
            Part::Hole("root") => with.root.clone(),
            Part::Hole(_) => with.program.clone(),
        };
        self.0.iter().map(part).collect()
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|part| match part {
            Part::Text(text) => f.write_str(&text.replace('{', "{{").replace('}', "}}")),
            Part::Hole(name) => write!(f, "{{{name}}}"),
        })
    }
}

fn unknown(name: &str) -> String {
    let names = HOLES.map(|(name, _)| name);
    let all: Vec<_> = names.iter().map(|name| format!("{{{name}}}")).collect();
    let meant = match scene::nearest(name, names) {
        Some(near) => format!("did you mean {{{near}}}?"),
        None => format!("expected one of {}", all.join(", ")),
    };
    format!("nothing is called {{{name}}}; {meant}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let filling = Filling {
            scene: "a b.ron".into(),
            output: "o.png".into(),
            width: 64,
            height: 48,
            samples: 4,
            shading: "radiometric",
            folder: "/f".into(),
            root: "/r".into(),
            program: "/self".into(),
        };
        let word = Word::read(text).unwrap();
        assert_eq!((word.filled(&filling), word.to_string()), (expected.into(), text.into()));
    }

    #[track_caller]
    fn refused(text: &str, expected: &str) {
        let (message, _) = Word::read(text).unwrap_err();
        assert!(message.contains(expected), "{message}");
    }

    #[test]
    fn holes_are_filled() {
        check("", "");
        check("plain", "plain");
        check("{scene}", "a b.ron");
        check("+I{scene}:{output}", "+Ia b.ron:o.png");
        check("{width}x{height}x{samples}", "64x48x4");
        check("--{shading}", "--radiometric");
        check("{folder}{root}{self}", "/f/r/self");
        check("{{scene}}", "{scene}");
        check("{{{scene}}}", "{a b.ron}");
        check("}}{{", "}{");
    }

    #[test]
    fn what_is_no_hole_is_said() {
        refused("{scen}", "nothing is called {scen}; did you mean {scene}?");
        refused("{zzzzzz}", "expected one of {scene}, {output}, {width}");
        refused("{}", "nothing is called {}");
        refused("{ scene }", "did you mean {scene}?");
        refused("{scene", "braces in pairs");
        refused("a}", "braces in pairs");
        refused("a\0", "expected a word without zero bytes, found \"a\\u{0}\"");
    }
}
