// Every fixture beside every renderer, with filters.

function tableSection() {
  const body = element("tbody");
  const found = element("p", { class: "found", role: "status" });
  const filters = { text: "", outcome: "" };
  const update = () => {
    const shown = fixtures.filter((fixture) => isWanted(fixture, filters));
    body.replaceChildren(...shown.map(fixtureRow));
    found.textContent = shown.length === fixtures.length ? "" : `${plural(shown.length, "fixture", "fixtures")} of ${count(fixtures.length)} shown`;
  };
  update();
  const table = element(
    "table",
    { class: "matrix fixtures" },
    element("caption", { class: "unseen" }, "What came of each fixture with each renderer"),
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "Fixture"), renderers.map(({ name }) => element("th", { scope: "col" }, name)))),
    body,
  );
  return element(
    "section",
    { "aria-labelledby": "fixtures" },
    element("h2", { id: "fixtures" }, "Fixtures"),
    tableFilters(filters, update),
    found,
    scrolled(table, "Fixtures by renderers"),
  );
}

function isWanted({ name, results }, { text, outcome }) {
  const all = Object.values(results);
  const has = { "": true, failed: all.some(hasFailed), unequal: new Set(all.map((result) => result.outcome)).size > 1 };
  return name.toLowerCase().includes(text) && (has[outcome] ?? all.some((result) => result.outcome === outcome));
}

function tableFilters(filters, update) {
  const outcomes = Object.keys(renderers[0]?.tally.outcomes ?? {});
  const choices = [["", "all"], ["failed", "failed"], ["unequal", "not the same everywhere"], ...outcomes.map((id) => [id, outcomeWords(id)])];
  const text = element("input", { type: "search", id: "wanted", input: ({ target }) => { filters.text = target.value.toLowerCase(); update(); } });
  const outcome = element(
    "select",
    { id: "outcome", change: ({ target }) => { filters.outcome = target.value; update(); } },
    choices.map(([value, words]) => element("option", { value }, words)),
  );
  return element(
    "div",
    { class: "fields" },
    element("span", { class: "field" }, element("label", { for: "wanted" }, "Name"), text),
    element("span", { class: "field" }, element("label", { for: "outcome" }, "Outcome"), outcome),
  );
}

function fixtureRow(fixture) {
  const cell = ({ id }) => {
    const result = fixture.results[id];
    return element("td", {}, result ? outcomeBadge(result.outcome) : element("span", { class: "soft" }, "not in this run"));
  };
  return element("tr", { "data-name": fixture.name }, element("th", { scope: "row" }, fixtureLink(fixture.name)), renderers.map(cell));
}
