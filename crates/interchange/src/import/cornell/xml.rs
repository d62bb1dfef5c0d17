//! XML text to a tree, or why it is none.
//!
//! No text is too deep, and none grows: documents with a DTD, the only place
//! where entities are declared, are refused, and so are more bytes or nodes than
//! any scene has.

use roxmltree::{Document, Error, ParsingOptions};

use crate::import::Unreadable;
use crate::import::text::Text;

/// The largest file that is read: no scene of the course has a thousandth of it.
const MAX_BYTES: usize = 16 << 20;

/// The most elements, texts and comments together.
const MAX_NODES: u32 = 2_000_000;

/// The most attributes of an element: the parser holds each against all others.
const MAX_ATTRIBUTES: usize = 64;

/// The tree of a text.
///
/// # Errors
/// Where it is no XML, or more than is read.
pub(super) fn parse<'a>(text: &Text<'a>) -> Result<Document<'a>, Unreadable> {
    if text.text.len() > MAX_BYTES {
        return Err(problem(
            None,
            format!("expected XML of at most {MAX_BYTES} bytes, found {}", text.text.len()),
            "put large meshes into files of their own",
        ));
    }
    if let Some(byte) = crowded(text.text) {
        return Err(problem(
            Some(text.place(byte)),
            format!("expected an element of at most {MAX_ATTRIBUTES} attributes, found more"),
            "put data into elements",
        ));
    }
    let options =
        ParsingOptions { allow_dtd: false, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text.text, options).map_err(|error| explain(text, &error))
}

/// Where the first element with too many attributes starts, if one has.
fn crowded(text: &str) -> Option<usize> {
    let mut from = 0;
    while let Some(start) = text[from..].find('<').map(|at| from + at) {
        let rest = &text[start..];
        let passed_over = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        if let Some((open, close)) = passed_over.iter().find(|(open, _)| rest.starts_with(open)) {
            let end = rest[open.len()..].find(close)?;
            from = start + open.len() + end + close.len();
            continue;
        }
        let (mut count, mut quote) = (0, None);
        let mut end = rest.len();
        for (at, byte) in rest.bytes().enumerate() {
            match (byte, quote) {
                (_, Some(open)) => quote = (byte != open).then_some(open),
                (b'"' | b'\'', None) => quote = Some(byte),
                (b'=', None) => count += 1,
                (b'>', None) => {
                    end = at + 1;
                    break;
                }
                _ => {}
            }
        }
        if count > MAX_ATTRIBUTES {
            return Some(start);
        }
        from = start + end;
    }
    None
}

fn explain(text: &Text<'_>, error: &Error) -> Unreadable {
    let end = || Some(text.place(text.text.len()));
    match error {
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => problem(
            end(),
            "expected the file's elements to be closed, found its end".to_owned(),
            "the file may have been cut off",
        ),
        Error::NoRootNode => {
            problem(end(), "expected the element scene, found no element".to_owned(), START)
        }
        Error::DtdDetected => problem(
            text.text.find("<!DOCTYPE").map(|byte| text.place(byte)),
            "expected no document type declaration, found one".to_owned(),
            "remove it, and write what its entities stand for",
        ),
        Error::NodesLimitReached => problem(
            None,
            format!("expected at most {MAX_NODES} elements and texts, found more"),
            "put large meshes into files of their own",
        ),
        other => {
            let place = other.pos();
            let place = (place.row as usize, place.col as usize);
            // The parser's sentence ends with the place, which is given apart.
            let said = other.to_string();
            let ending = format!(" at {}:{}", place.0, place.1);
            let said = said.replace(&ending, "");
            problem(Some(place), format!("expected XML, found a mistake in it: {said}"), START)
        }
    }
}

const START: &str = "a scene of the course begins with <scene>";

fn problem(place: Option<(usize, usize)>, message: String, help: &str) -> Unreadable {
    Unreadable { place, message, help: Some(help.to_owned()) }
}
