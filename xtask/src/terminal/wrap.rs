//! `wrap`: words in lines of a width.

/// Lines of at most so many letters, cut between words where that is possible;
/// one that fits is as it was. What would move a terminal's cursor is shown as a
/// question mark.
pub(super) fn wrap(text: &str, columns: usize) -> Vec<String> {
    let columns = columns.max(1);
    let plain = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    if text.chars().count() <= columns {
        return vec![text.chars().map(plain).collect()];
    }
    let mut lines = vec![String::new()];
    let mut width = 0;
    for word in text.split(' ') {
        let letters: Vec<_> = word.chars().map(plain).collect();
        // One for the space before it.
        let fits = width == 0 || width + 1 + letters.len() <= columns;
        if !fits {
            lines.push(String::new());
            width = 0;
        }
        for (i, piece) in letters.chunks(columns).enumerate() {
            if i > 0 {
                lines.push(String::new());
                width = 0;
            }
            if let Some(line) = lines.last_mut() {
                if width > 0 {
                    line.push(' ');
                    width += 1;
                }
                line.extend(piece);
                width += piece.len();
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, columns: usize, expected: &[&str]) {
        assert_eq!(wrap(text, columns), expected, "{text:?}");
    }

    #[test]
    fn lines_are_no_wider_and_no_word_is_lost() {
        check("", 5, &[""]);
        check("ab cd ef", 5, &["ab cd", "ef"]);
        check("abcdefgh ij", 5, &["abcde", "fgh", "ij"]);
        check("abc", 0, &["a", "b", "c"]);
        check("\u{1b}[2J", 9, &["\u{fffd}[2J"]);
        check("ääää öö", 5, &["ääää", "öö"]);
        check("   |  ^^", 8, &["   |  ^^"]);
    }
}
