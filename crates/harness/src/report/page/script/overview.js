// The overview: what came out, filters, and the contact sheet.

// What is shown, for the way from one fixture to the next and back.
const overview = { filters: NO_FILTERS, shown: [] };

function applyFilters(filters) {
  overview.filters = filters;
  overview.shown = selectFixtures(filters);
}

function makeOverview(filters) {
  const sheet = element("ul", { class: "sheet", "aria-label": "Fixtures" });
  const found = element("p", { class: "found", role: "status" });
  const empty = element("p", { class: "empty" });
  const batch = isReviewing ? batchBar() : null;
  const change = (part) => {
    applyFilters({ ...overview.filters, ...part });
    rewriteHash(overviewHash(overview.filters));
    update();
  };
  const controls = filterControls(filters, change);
  const update = () => {
    controls.update(overview.filters);
    fillSheet(sheet, empty, found);
    batch?.update();
  };
  const decided = () => {
    for (const fixture of overview.shown) markDecision(cardOf(fixture).decision, fixture.name);
    batch?.update();
  };
  applyFilters(filters);
  update();
  const forget = onDecisions(decided);
  const selected = () => batch?.update();
  document.addEventListener("selected", selected);
  const close = () => {
    forget();
    document.removeEventListener("selected", selected);
  };
  return {
    root: [headline(), controls.root, found, batch?.root, empty, sheet].filter(Boolean),
    close,
    batch,
  };
}

function fillSheet(sheet, empty, found) {
  const { shown, filters } = overview;
  for (const fixture of shown) {
    const card = cardOf(fixture);
    card.number.textContent = telling(fixture, filters.sort);
    markDecision(card.decision, fixture.name);
  }
  sheet.replaceChildren(...shown.map((fixture) => cardOf(fixture).root));
  sheet.hidden = shown.length === 0;
  found.textContent =
    shown.length === fixtures.length
      ? ""
      : `${plural(shown.length, "fixture", "fixtures")} of ${count(fixtures.length)} shown`;
  empty.hidden = shown.length > 0;
  const make = `${report.called} new area/name`;
  const suite = `There is no fixture: the suite is empty. A first one is made by ${make}.`;
  empty.textContent = fixtures.length === 0 ? suite : "No fixture is as these filters ask.";
}
