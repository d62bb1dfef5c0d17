// Features by renderers: what each run says of each feature, by family.

function matrixSection() {
  const families = [...new Set(card.features.map((row) => row.family))];
  const table = element(
    "table",
    { class: "matrix" },
    element("caption", { class: "unseen" }, "What each run says of each feature, and how many of the fixtures that ask for it pass"),
    element(
      "thead",
      {},
      element(
        "tr",
        {},
        element("td", {}),
        renderers.map(({ name }) => element("th", { scope: "col" }, name)),
      ),
    ),
    families.map(familyRows),
  );
  return element(
    "section",
    { "aria-labelledby": "features" },
    element("h2", { id: "features" }, "Features"),
    scrolled(table, "Features by renderers"),
    standingsLegend(),
    card.unasked.length > 0
      ? element("p", { class: "soft" }, `No fixture asks for: ${card.unasked.join(", ")}.`)
      : null,
  );
}

function familyRows(family) {
  const rows = card.features.filter((row) => row.family === family);
  return element(
    "tbody",
    {},
    element(
      "tr",
      { class: "family" },
      element("th", { scope: "rowgroup", colspan: renderers.length + 1 }, family),
    ),
    rows.map(featureRow),
  );
}

function featureRow({ feature, cells }) {
  return element(
    "tr",
    {},
    element("th", { scope: "row" }, featureName(feature)),
    renderers.map(({ id }) => element("td", {}, matrixCell(id, feature, cells[id]))),
  );
}

function matrixCell(id, feature, cell) {
  const { words } = standingById.get(cell.standing);
  const { total, outcomes } = cell.tally;
  if (total === 0) return element("span", { class: "cell", "data-standing": cell.standing }, words);
  return element(
    "a",
    { class: "cell", "data-standing": cell.standing, href: cellHash(id, feature) },
    words,
    " ",
    element("span", { class: "soft" }, `${count(outcomes.pass)}/${count(total)}`),
    unseen(` ${feature}, ${nameOf(id)}`),
  );
}

function standingsLegend() {
  const told = card.standings.map(({ id, words, meaning }) => [
    element("dt", {}, element("span", { class: "cell", "data-standing": id }, words)),
    element("dd", {}, meaning),
  ]);
  return element(
    "details",
    { class: "legend" },
    element("summary", {}, "What the words mean"),
    element("p", {}, "A picture is wrong as a whole. A feature that some passing fixture has is not blamed for one that fails."),
    element("dl", {}, told),
  );
}
