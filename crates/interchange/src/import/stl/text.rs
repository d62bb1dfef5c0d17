//! STL as text: `solid`, facets, `endsolid`.

use tracer::glam::DVec3;

use super::facets::Facets;
use crate::import::Unreadable;
use crate::import::mesh::stage::Stage;
use crate::import::mesh::unreadable;
use crate::import::mesh::words::{Word, Words};

/// Whether a file starts like text.
pub(super) fn starts(bytes: &[u8]) -> bool {
    Words::plain(bytes).next_word().is_some_and(|word| is(&word, "solid"))
}

/// Reads the facets of all solids.
///
/// # Errors
/// The first word that is another than expected, and numbers that are none.
pub(super) fn read(bytes: &[u8], facets: &mut Facets, stage: &mut Stage) -> Result<(), Unreadable> {
    let mut words = Words::plain(bytes);
    let mut solids = 0_usize;
    while let Some(word) = words.next_word() {
        if !is(&word, "solid") {
            return Err(unexpected(&word, "`solid`"));
        }
        // Its name is the rest of the line, whatever words it has.
        words.skip_line();
        solids += 1;
        solid(&mut words, facets)?;
    }
    if solids > 1 {
        stage.chosen.push(format!("the file's {solids} solids are one mesh"));
    }
    Ok(())
}

fn solid(words: &mut Words<'_>, facets: &mut Facets) -> Result<(), Unreadable> {
    loop {
        let word = next(words, "`facet` or `endsolid`")?;
        if is(&word, "endsolid") {
            words.skip_line();
            return Ok(());
        }
        if !is(&word, "facet") {
            return Err(unexpected(&word, "`facet` or `endsolid`"));
        }
        keyword(words, "normal")?;
        let normal = point(words)?;
        keyword(words, "outer")?;
        keyword(words, "loop")?;
        let mut corners = [DVec3::ZERO; 3];
        for corner in &mut corners {
            keyword(words, "vertex")?;
            *corner = point(words)?;
        }
        keyword(words, "endloop")?;
        keyword(words, "endfacet")?;
        facets.add(normal, corners).map_err(|why| unreadable(word.place, why))?;
    }
}

fn point(words: &mut Words<'_>) -> Result<DVec3, Unreadable> {
    let mut number = || {
        let word = next(words, "a number")?;
        word.number().map_err(|why| unreadable(word.place, why))
    };
    Ok(DVec3::new(number()?, number()?, number()?))
}

fn keyword(words: &mut Words<'_>, expected: &str) -> Result<(), Unreadable> {
    let quoted = format!("`{expected}`");
    let word = next(words, &quoted)?;
    if is(&word, expected) { Ok(()) } else { Err(unexpected(&word, &quoted)) }
}

fn next<'a>(words: &mut Words<'a>, expected: &str) -> Result<Word<'a>, Unreadable> {
    let end = || unreadable(words.place(), format!("expected {expected}, found the file's end"));
    let mut ahead = words.clone();
    let word = ahead.next_word().ok_or_else(end)?;
    *words = ahead;
    Ok(word)
}

fn is(word: &Word<'_>, expected: &str) -> bool {
    word.text.eq_ignore_ascii_case(expected.as_bytes())
}

fn unexpected(word: &Word<'_>, expected: &str) -> Unreadable {
    unreadable(word.place, format!("expected {expected}, found \"{}\"", word.shown()))
}
