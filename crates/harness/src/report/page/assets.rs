//! The page's text, style and script, as they are in their files.

/// The page, with a place for the title, the style, the data and the script.
pub(super) const PAGE: &str = include_str!("page.html");

/// How every page of the project looks.
pub(super) const BASE_STYLE: &str = include_str!("style.css");

/// How it looks; a later one overrides.
pub(super) const STYLES: &[&str] =
    &[BASE_STYLE, include_str!("fixture.css"), include_str!("narrow.css")];

/// Elements of a page.
pub(super) const ELEMENT: &str = include_str!("script/element.js");
/// What is kept over a reload.
pub(super) const STORED: &str = include_str!("script/stored.js");
/// Light and dark.
pub(super) const THEME: &str = include_str!("script/theme.js");
/// Numbers as people read them.
pub(super) const NUMBERS: &str = include_str!("script/numbers.js");

/// What it does: parts of one function, in this order.
pub(super) const SCRIPTS: &[&str] = &[
    ELEMENT,
    include_str!("script/data.js"),
    STORED,
    include_str!("script/memory.js"),
    THEME,
    include_str!("script/decode.js"),
    NUMBERS,
    include_str!("script/transfer.js"),
    include_str!("script/distance.js"),
    include_str!("script/select.js"),
    include_str!("script/route.js"),
    include_str!("script/viewport.js"),
    include_str!("script/layer.js"),
    include_str!("script/pane.js"),
    include_str!("script/pointers.js"),
    include_str!("script/gestures.js"),
    include_str!("script/slider.js"),
    include_str!("script/readout.js"),
    include_str!("script/view/lacks.js"),
    include_str!("script/view/sides.js"),
    include_str!("script/view/blink.js"),
    include_str!("script/view/swipe.js"),
    include_str!("script/view/difference.js"),
    include_str!("script/view/heat.js"),
    include_str!("script/view/threshold.js"),
    include_str!("script/view/objects.js"),
    include_str!("script/view/single.js"),
    include_str!("script/viewer.js"),
    include_str!("script/source.js"),
    include_str!("script/facts.js"),
    include_str!("script/metrics.js"),
    include_str!("script/told.js"),
    include_str!("script/confirm.js"),
    include_str!("script/review.js"),
    include_str!("script/card.js"),
    include_str!("script/headline.js"),
    include_str!("script/filters.js"),
    include_str!("script/batch.js"),
    include_str!("script/overview.js"),
    include_str!("script/place.js"),
    include_str!("script/fixture.js"),
    include_str!("script/keys.js"),
    include_str!("script/main.js"),
];
