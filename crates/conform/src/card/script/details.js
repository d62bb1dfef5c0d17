// What is behind a cell, and behind a fixture: each result with its reasons, numbers and pictures.

function back() {
  return element("p", {}, element("a", { href: "#/" }, HOME));
}

// The fixtures that ask a renderer for a feature.
function cellPage(id, feature) {
  const renderer = rendererById.get(id);
  const cell = rowByFeature.get(feature)?.cells[id];
  if (!renderer || !cell) return lostPage();
  const having = fixtures.filter(({ features, results }) => features.includes(feature) && results[id]);
  const rank = ({ results }) => [hasFailed(results[id]) ? 0 : 1, results[id].outcome === "unsupported" ? 1 : 0];
  const sorted = having.toSorted((a, b) => compare(rank(a), rank(b)));
  const { words, meaning } = standingById.get(cell.standing);
  const { tally } = cell;
  return [
    back(),
    element("h1", {}, `${feature} with ${renderer.name}`),
    element("p", {}, element("span", { class: "cell", "data-standing": cell.standing }, words), " ", meaning),
    element("dl", { class: "facts is-wide" }, fact("Pass", `${count(tally.outcomes.pass)} of ${count(tally.total)}`), fact("Worst interior error", worstFact(tally)), fact("Edge pixels that differ", edgeFact(tally))),
    differenceLegend(),
    sorted.map((fixture, i) => foldedResult(fixture, id, i === 0)),
  ];
}

function compare(a, b) {
  for (const [i, value] of a.entries()) if (value !== b[i]) return value - b[i];
  return 0;
}

// A result that is opened on demand; its pictures are decoded only then.
function foldedResult(fixture, id, isOpen) {
  const body = element("div", { class: "body" });
  const result = fixture.results[id];
  const fill = () => {
    if (body.childElementCount === 0) body.append(...resultParts(fixture, id), element("p", {}, renderers.length > 1 ? "With every renderer: " : "More: ", fixtureLink(fixture.name)));
  };
  if (isOpen) fill();
  const numbers = result.numbers && hasFailed(result) ? ` ${plural(result.numbers.interior_off, "pixel", "pixels")} off` : "";
  return element(
    "details",
    { class: "result", open: isOpen, toggle: fill },
    element("summary", {}, outcomeBadge(result.outcome), " ", element("span", { class: "name" }, fixtureName(fixture.name)), element("span", { class: "soft" }, numbers)),
    body,
  );
}

// Reasons, numbers and pictures of a result.
function resultParts(fixture, id) {
  const { findings, numbers, suspects } = fixture.results[id];
  return [
    findings.length > 0 ? element("ul", { class: "findings" }, findings.map((finding) => element("li", {}, finding))) : null,
    suspects ? element("p", { class: "suspects" }, suspectWords(suspects)) : null,
    numbers ? numbersList(fixture, numbers) : null,
    resultPictures(fixture, id),
  ].filter(Boolean);
}

function numbersList(fixture, numbers) {
  const { pixels, edge_pixels, edge_off, interior_off, worst_interior, worst_at, worst_on } = numbers;
  const on = worst_on ? `, on ${objectWords(fixture, worst_on)}` : "";
  const at = worst_at && worst_interior !== 0 ? ` at ${placeWords(worst_at)}${on}` : "";
  return element(
    "dl",
    { class: "facts is-wide" },
    fact("Worst interior error", `${errorWords(worst_interior)}${at}`),
    fact("Interior pixels off", `${count(interior_off)} of ${count(pixels - edge_pixels)}`),
    fact("Edge pixels that differ", edgeFact({ edge_off, edge_pixels })),
  );
}

// A fixture with every renderer.
function fixturePage(name) {
  const fixture = fixtureByName.get(name);
  if (!fixture) return lostPage();
  const results = renderers.filter(({ id }) => fixture.results[id]);
  const missing = renderers.filter(({ id }) => !fixture.results[id]);
  const asked = renderers.length > 0 ? renderers[0].id : "";
  return [
    back(),
    element("h1", {}, fixtureName(name)),
    element("p", { class: "soft" }, "It asks for: ", fixture.features.map((feature, i) => [i > 0 ? ", " : "", element("a", { href: cellHash(asked, feature) }, feature)])),
    differenceLegend(),
    results.map(({ id }) => resultSection(fixture, id)),
    missing.length > 0 ? element("p", { class: "soft" }, `Not in the run of: ${missing.map(({ name }) => name).join(", ")}.`) : null,
    fixtureConsensus(fixture),
  ].filter(Boolean);
}

function resultSection(fixture, id) {
  const heading = `with-${id}`;
  return element(
    "section",
    { class: "sheet-of-one", "aria-labelledby": heading },
    element("h2", { id: heading }, nameOf(id), " ", outcomeBadge(fixture.results[id].outcome)),
    resultParts(fixture, id),
  );
}

function lostPage() {
  return [back(), element("h1", {}, "There is nothing here"), element("p", {}, "This card has no such fixture or feature.")];
}
