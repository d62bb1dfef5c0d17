//! `text`: text of others inside of HTML and SVG.

/// The text with every sign that means something in XML written as a reference.
pub(crate) fn text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML has no word for most of them.
            c if c.is_control() => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_sign_means_anything() {
        assert_eq!(super::text("a<b>&'\"\u{0}\u{7}"), "a&lt;b&gt;&amp;&#39;&quot;\u{fffd}\u{fffd}");
        assert_eq!(super::text("µ: fünf"), "µ: fünf");
    }
}
