//! `json`: a scorecard for machines, by `docs/schemas/scorecard.schema.json`.

use serde_json::{Map, Value, json};

use super::{
    Answered, Card, Cell, Column, Entry, Row, Selection, Standing, Suspicion, Tally, Worst,
};
use crate::consensus::{Opinion, Overall, Pixels, Region, Share, Told, Voters};
use crate::objects::Seen;
use crate::outcome;

/// The card as a document: what `scorecard.json` holds.
pub fn json(card: &Card) -> Value {
    let meaning = |standing: Standing| json!({ "id": standing.id(), "words": standing.words(), "meaning": standing.meaning() });
    json!({
        "schema": 1,
        "selection": card.selection.as_ref().map(selection),
        "renderers": card.renderers.iter().map(column).collect::<Vec<_>>(),
        "standings": Standing::ALL.map(meaning),
        "features": card.rows.iter().map(|r| row(card, r)).collect::<Vec<_>>(),
        "unasked": card.unasked.iter().map(|feature| feature.name()).collect::<Vec<_>>(),
        "fixtures": card.fixtures.iter().map(|(n, f)| fixture(card, n, f)).collect::<Vec<_>>(),
        "consensus": overall(&card.consensus),
    })
}

/// In `words` as people read it.
fn selection(selection: &Selection) -> Value {
    json!({
        "filters": selection.filters,
        "fixtures": selection.fixtures,
        "of": selection.of,
        "words": selection.words(),
    })
}

/// A value for each renderer that has one, by its id.
fn by_id<T>(card: &Card, values: &[T], value: impl Fn(&T) -> Option<Value>) -> Value {
    let pairs = card.ids().zip(values);
    pairs.filter_map(|(id, one)| Some((id.to_owned(), value(one)?))).collect::<Map<_, _>>().into()
}

fn column(column: &Column) -> Value {
    json!({
        "id": column.info.id,
        "name": column.info.name,
        "version": column.info.version,
        "tolerance": column.tolerance,
        "edge_reach": column.edge_reach,
        "tally": tally(&column.tally),
    })
}

fn row(card: &Card, row: &Row) -> Value {
    let cell =
        |cell: &Cell| Some(json!({ "standing": cell.standing.id(), "tally": tally(&cell.tally) }));
    json!({
        "feature": row.feature.name(),
        "family": row.feature.family(),
        "cells": by_id(card, &row.cells, cell),
    })
}

/// `worst` is null where no picture was compared; its `error` where that is no finite
/// number.
fn tally(tally: &Tally) -> Value {
    let count = |o| (outcome::id(o).to_owned(), json!(tally.count(o)));
    let worst =
        |worst: &Worst| json!({ "error": worst.error, "fixture": worst.fixture, "at": worst.at });
    json!({
        "total": tally.total(),
        "outcomes": outcome::ALL.into_iter().map(count).collect::<Map<_, _>>(),
        "worst": tally.worst.as_ref().map(worst),
        "pixels": tally.pixels,
        "interior_off": tally.interior_off,
        "edge_pixels": tally.edge_pixels,
        "edge_off": tally.edge_off,
    })
}

fn fixture(card: &Card, name: &str, entry: &Entry) -> Value {
    json!({
        "name": name,
        "features": entry.features.iter().map(|feature| feature.name()).collect::<Vec<_>>(),
        "results": by_id(card, &entry.results, |one| one.as_ref().map(answered)),
        "consensus": entry.told.as_ref().map(|one| told(card, one)),
    })
}

fn answered(answered: &Answered) -> Value {
    let result = &answered.result;
    let numbers = result.numbers.map(|n| {
        json!({
            "pixels": n.pixels,
            "edge_pixels": n.edge_pixels,
            "edge_off": n.edge_off,
            "interior_off": n.interior_off,
            "worst_interior": n.worst_interior,
            "worst_at": n.worst_at,
            "worst_on": answered.worst_on.as_ref().map(seen),
        })
    });
    json!({
        "outcome": outcome::id(result.outcome),
        "findings": result.findings,
        "numbers": numbers,
        "suspects": answered.suspicion.as_ref().map(suspicion),
        "elapsed_ms": result.elapsed_ms,
    })
}

fn suspicion(suspicion: &Suspicion) -> Value {
    json!({
        "features": suspicion.features.iter().map(|feature| feature.name()).collect::<Vec<_>>(),
        "pairs": suspicion.pairs.iter().map(|(a, b)| [a.name(), b.name()]).collect::<Vec<_>>(),
    })
}

/// An object by its place in the fixture's file; the background is called so, and has
/// no place.
fn seen(seen: &Seen) -> Value {
    match &seen.object {
        Some(place) => {
            json!({ "kind": place.kind, "line": place.line, "column": place.column })
        }
        None => json!({ "kind": "background", "line": null, "column": null }),
    }
}

/// Who stands where: `voters` are ids; `against` those against the majority, `sides`
/// two halves. In `words` they have their `names`.
fn opinion(voters: &[String], names: &[&str], opinion: Opinion) -> Map<String, Value> {
    let ids = |set: Voters| {
        set.numbers().filter_map(|i| voters.get(i)).map(String::as_str).collect::<Vec<_>>()
    };
    let sides = match opinion {
        Opinion::Halves(a, b) => json!([ids(a), ids(b)]),
        _ => Value::Null,
    };
    let against = ids(opinion.dissenters());
    let words = opinion.words(names);
    let fields = [
        ("opinion", json!(opinion.id())),
        ("words", json!(words)),
        ("against", json!(against)),
        ("sides", sides),
    ];
    fields.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

fn told(card: &Card, told: &Told) -> Value {
    let names = card.names(told);
    let counted = |(one, pixels): (&Opinion, &Pixels)| {
        let mut fields = opinion(&told.voters, &names, *one);
        fields.insert("interior".to_owned(), json!(pixels.interior));
        fields.insert("edge".to_owned(), json!(pixels.edge));
        fields
    };
    let region = |region: &Region| {
        let mut fields = opinion(&told.voters, &names, region.opinion);
        fields.insert("pixels".to_owned(), json!(region.pixels));
        fields.insert("from".to_owned(), json!(region.from));
        fields.insert("to".to_owned(), json!(region.to));
        let on = region.on.as_ref().map(|(object, pixels)| {
            let mut on = seen(object);
            on["pixels"] = json!(pixels);
            on
        });
        fields.insert("on".to_owned(), json!(on));
        fields
    };
    json!({
        "voters": told.voters,
        "unheard": told.unheard,
        "opinions": told.opinions.iter().map(counted).collect::<Vec<_>>(),
        "regions": told.regions.iter().map(region).collect::<Vec<_>>(),
        "regions_untold": { "regions": told.untold.0, "pixels": told.untold.1 },
    })
}

fn overall(overall: &Overall) -> Value {
    let pixels = |p: Pixels| json!({ "interior": p.interior, "edge": p.edge });
    let share = |(id, share): (&String, &Share)| {
        let alone_in = share.alone_in.iter();
        json!({
            "id": id,
            "heard": share.heard,
            "alone": pixels(share.alone),
            "with_others": pixels(share.with_others),
            "alone_in": alone_in
                .map(|(fixture, pixels)| json!({ "fixture": fixture, "pixels": pixels }))
                .collect::<Vec<_>>(),
        })
    };
    json!({
        "fixtures": overall.fixtures,
        "agreed": overall.agreed,
        "undecided": overall.undecided,
        "voters": overall.voters.iter().map(share).collect::<Vec<_>>(),
    })
}
