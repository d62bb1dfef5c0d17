//! `BUILTIN`: adapters that need no file of the suite's own.
//!
//! To add one: write its folder in `adapters/`, and add its line here.

/// An adapter that comes with this program.
#[derive(Debug, Clone, Copy)]
pub struct Builtin {
    /// The name that it is asked for by.
    pub name: &'static str,
    /// Its adapter file.
    pub text: &'static str,
    /// Programs that it needs in its folder, by name.
    pub programs: &'static [(&'static str, &'static [u8])],
}

/// All of them.
pub const BUILTIN: &[Builtin] = &[
    Builtin {
        name: "embree",
        text: include_str!("../../../../adapters/embree/adapter.ron"),
        programs: &[("render.py", include_bytes!("../../../../adapters/embree/render.py"))],
    },
    Builtin {
        name: "goldray",
        text: include_str!("../../../../adapters/goldray/adapter.ron"),
        programs: &[],
    },
    Builtin {
        name: "mitsuba",
        text: include_str!("../../../../adapters/mitsuba/adapter.ron"),
        programs: &[("render.py", include_bytes!("../../../../adapters/mitsuba/render.py"))],
    },
    Builtin {
        name: "povray",
        text: include_str!("../../../../adapters/povray/adapter.ron"),
        programs: &[],
    },
];
