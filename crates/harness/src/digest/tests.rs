//! Digests of small pictures, and what a table must not pass over.

use tracer::Rgb;

use super::*;
use crate::encode::{Transfer, encode};

fn rendered(width: u32, height: u32, pixel: impl Fn(u32, u32) -> Rgb) -> Rendered {
    let linear = LinearImage::from_fn(Size { width, height }, pixel);
    let encoded = encode(&linear, Transfer::Gamma22).unwrap();
    Rendered { linear, encoded }
}

fn digest(letter: char) -> Digest {
    let linear = letter.to_string().repeat(LETTERS);
    Digest { encoded: "0".repeat(LETTERS), linear }
}

fn table(lines: &[(&str, char)]) -> Table {
    lines.iter().map(|&(name, letter)| (name.to_owned(), digest(letter))).collect()
}

#[test]
fn a_digest_is_blake3_of_size_and_bits() {
    let picture = rendered(1, 1, |_, _| Rgb::new(1.0, -0.0, 0.5));
    let mut bytes = vec![1, 0, 0, 0, 1, 0, 0, 0];
    bytes.extend([0, 0, 0, 0, 0, 0, 0xf0, 0x3f]);
    bytes.extend([0, 0, 0, 0, 0, 0, 0, 0x80]);
    bytes.extend([0, 0, 0, 0, 0, 0, 0xe0, 0x3f]);
    let expected = blake3::hash(&bytes).to_hex();
    assert_eq!(Digest::of(&picture).linear, expected[..LETTERS]);
    let expected = blake3::hash(&[1, 0, 0, 0, 1, 0, 0, 0, 255, 0, 186]).to_hex();
    assert_eq!(Digest::of(&picture).encoded, expected[..LETTERS]);
}

#[test]
fn the_last_bit_the_sign_of_zero_the_place_and_the_size_count() {
    let gray = |x: f64| Rgb::new(x, x, x);
    let original = Digest::of(&rendered(4, 2, |x, _| gray(f64::from(x))));
    let last_bit = Digest::of(&rendered(4, 2, |x, _| gray(f64::from(x).next_up())));
    assert_ne!(last_bit.linear, original.linear);
    let signed = |zero: f64| Digest::of(&rendered(1, 1, |_, _| gray(zero)));
    assert_ne!(signed(-0.0).linear, signed(0.0).linear);
    assert_eq!(signed(-0.0).encoded, signed(0.0).encoded);
    let black = |width, height| Digest::of(&rendered(width, height, |_, _| Rgb::BLACK));
    assert_ne!(black(4, 2).linear, black(2, 4).linear);
    assert_ne!(black(4, 2).encoded, black(2, 4).encoded);
    let mirrored = Digest::of(&rendered(4, 2, |x, _| gray(f64::from(3 - x))));
    assert_ne!(mirrored, original);
}

#[test]
fn a_table_comes_back_and_is_sorted() {
    let table = table(&[("b", 'a'), ("a/with space", 'f')]);
    let text = to_text(&table);
    assert_eq!(parse(&text), Ok(table));
    assert!(text.find("a/with").unwrap() < text.find("\nb ").unwrap());
}

#[test]
fn what_is_no_table_is_refused_with_its_line() {
    let good = line("a", &digest('a'));
    let refused = |text: &str| parse(text).unwrap_err();
    assert!(refused(&format!("# head\n{good}\n{good}\n")).contains("line 3: expected each name"));
    for bad in ["a", "a b c", good.trim_end_matches('0'), &good.replace("aaa", "AAA"), &good[2..]] {
        assert!(refused(bad).contains("line 1: expected a name and two digests"), "{bad}");
    }
}

#[test]
fn missing_surplus_and_changed_lines_are_all_found() {
    let fixtures = ["a", "b", "c"].map(str::to_owned);
    let whole = table(&[("a", '1'), ("b", '2'), ("c", '3')]);
    assert_eq!(differences(&whole, &fixtures, &whole), []);
    let found = |old: &[(&str, char)], today: &[(&str, char)]| {
        let all = differences(&table(old), &fixtures, &table(today));
        all.iter().map(Difference::to_string).collect::<Vec<_>>()
    };
    let all = [("a", '1'), ("b", '2'), ("c", '3')];
    let missing = "b: expected a line in golden/digests.txt, found none";
    assert_eq!(found(&[("a", '1'), ("c", '3')], &all), [missing]);
    let gone = found(&[("a", '1'), ("b", '2'), ("c", '3'), ("d", '4')], &all);
    assert!(gone.len() == 1 && gone[0].starts_with("d: expected a fixture"), "{gone:?}");
    let changed = found(&all, &[("b", '5')]);
    let expected = format!(
        "b: expected the linear picture {}, found {}",
        digest('2').linear,
        digest('5').linear
    );
    assert_eq!(changed, [expected], "only a part of the suite was asked for");
}
