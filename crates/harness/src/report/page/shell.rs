//! What the pages of the project share: how one is put together, how it looks, and
//! the scripts that any may use.
//!
//! A page is one HTML file that needs nothing else. Its data is JSON in script
//! elements, which no browser runs; its script puts what comes from others into it
//! as text only.

use std::fmt::Write as _;

use serde_json::Value;

use super::assets;

/// How every page looks: colors, buttons, the bar at the top, an overview of cards.
pub const STYLE: &str = assets::BASE_STYLE;

/// Scripts that any page may begin with: elements, what is kept over a reload, light
/// and dark (for which the page has a button `theme`), numbers as people read them.
pub const SCRIPTS: [&str; 4] = [assets::ELEMENT, assets::STORED, assets::THEME, assets::NUMBERS];

/// Adds a script element with this id that no browser runs.
pub fn put(data: &mut String, id: &str, value: &Value) {
    // In JSON a `<` can only be in a string, where it may be written so; a
    // browser would take `</script>` for the end, and `<!--` for a comment.
    let json = value.to_string().replace('<', "\\u003c");
    // Writing to a String cannot fail.
    let _ = writeln!(data, "<script type=\"application/json\" id=\"{id}\">{json}</script>");
}

/// The page with everything in its place: `<!--TITLE-->`, `/*STYLE*/`, `<!--DATA-->`
/// and `/*SCRIPT*/`, in this order. The places are sought in `page` alone, whatever is
/// put into them. `title` is HTML; the scripts become parts of one function.
pub fn fill(page: &str, title: &str, styles: &[&str], data: &str, scripts: &[&str]) -> String {
    let script = format!("(() => {{\n\"use strict\";\n{}}})();\n", scripts.join("\n"));
    let style = styles.concat();
    let parts = [
        ("<!--TITLE-->", title),
        ("/*STYLE*/", style.as_str()),
        ("<!--DATA-->", data),
        ("/*SCRIPT*/", script.as_str()),
    ];
    let mut filled = String::with_capacity(page.len() + data.len() + style.len() + script.len());
    let mut rest = page;
    for (place, text) in parts {
        let (before, after) = rest.split_once(place).unwrap_or((rest, ""));
        filled.push_str(before);
        filled.push_str(text);
        rest = after;
    }
    filled + rest
}
