// The overview: what came out, filters, and the contact sheet.

/// What is shown, for the way from one fixture to the next and back.
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
    for (const { index, name } of overview.shown) markDecision(cardOf(fixtures[index]).decision, name);
    batch?.update();
  };
  applyFilters(filters);
  update();
  decided();
  const forget = onDecisions(decided);
  const selected = () => batch?.update();
  document.addEventListener("selected", selected);
  const close = () => {
    forget();
    document.removeEventListener("selected", selected);
  };
  return { root: [headline(), controls.root, found, batch?.root, empty, sheet].filter(Boolean), close, batch };
}

/// What came out, in one sentence.
function headline() {
  const { total, green, elapsed_ms, unchanged, audited, belied } = report.summary;
  const failed = fixtures.filter(hasFailed).length;
  const words = total === 0 ? "Nothing was judged" : green ? `${total === 1 ? "The fixture matches" : `All ${count(total)} fixtures match`}` : `${count(failed)} of ${plural(total, "fixture fails", "fixtures fail")}`;
  const parts = [`judged in ${duration(elapsed_ms)}`];
  if (unchanged > 0) parts.push(`${count(unchanged)} unchanged since their last match, ${count(audited)} of them rendered again as an audit`);
  if (belied > 0) parts.push(`${plural(belied, "record of a match is", "records of matches are")} wrong`);
  return element("header", { class: `headline ${green ? "is-green" : "is-red"}` }, element("h1", {}, words), element("p", {}, parts.join(" · ")));
}

function filterControls(filters, change) {
  const chips = report.verdicts.filter(({ id }) => report.summary[id] > 0).map((verdict) => verdictChip(verdict, change));
  const text = element("input", { type: "search", id: "filter-text", placeholder: "name", value: filters.text, input: () => change({ text: text.value }) });
  const areas = areasOf(fixtures).map(([area, size]) => element("option", { value: `/${area}` }, `${area || "(top)"} (${count(size)})`));
  const area = element("select", { id: "filter-area", change: () => change({ area: area.value === "" ? null : area.value.slice(1) }) }, element("option", { value: "" }, "every area"), areas);
  const orders = Object.entries(SORTS).map(([id, { words }]) => element("option", { value: id }, words));
  const distance = "Distance: the visible error of the whole picture (mean FLIP), then how many pixels differ, then by how much.";
  const sort = element("select", { id: "sort", title: distance, change: () => change({ sort: sort.value }) }, orders);
  const field = (id, words, input) => element("span", { class: "field" }, element("label", { for: id }, words), input);
  const root = element(
    "section",
    { class: "filters", "aria-label": "Filters" },
    element("div", { class: "chips", role: "group", "aria-label": "Verdicts" }, chips.map(({ root: chip }) => chip)),
    element("div", { class: "fields" }, field("filter-text", "Find", text), field("filter-area", "Area", area), field("sort", "Order", sort)),
  );
  const update = (now) => {
    for (const chip of chips) chip.update(now);
    area.value = now.area === null ? "" : `/${now.area}`;
    sort.value = now.sort;
    if (text.value !== now.text) text.value = now.text;
  };
  return { root, update };
}

function verdictChip({ id, words }, change) {
  const toggle = () => {
    const { verdicts } = overview.filters;
    change({ verdicts: verdicts.includes(id) ? verdicts.filter((other) => other !== id) : [...verdicts, id] });
  };
  const root = button([element("b", {}, count(report.summary[id])), ` ${words}`], toggle, { class: "chip", "data-verdict": id });
  return { root, update: ({ verdicts }) => root.setAttribute("aria-pressed", String(verdicts.includes(id))) };
}

function fillSheet(sheet, empty, found) {
  const { shown, filters } = overview;
  for (const fixture of shown) cardOf(fixture).number.textContent = telling(fixture, filters.sort);
  sheet.replaceChildren(...shown.map((fixture) => cardOf(fixture).root));
  sheet.hidden = shown.length === 0;
  found.textContent = shown.length === fixtures.length ? "" : `${plural(shown.length, "fixture", "fixtures")} of ${count(fixtures.length)} shown`;
  empty.hidden = shown.length > 0;
  const suite = "There is no fixture: the suite is empty. A first one is made by cargo xtask new area/name.";
  empty.textContent = fixtures.length === 0 ? suite : "No fixture is as these filters ask.";
}

/// What is selected, and what may be done with it.
function batchBar() {
  const words = element("span", { class: "words" });
  const names = () => selectedNames(overview.shown);
  const decisions = decisionButtons(names);
  const setAll = (isOn) => {
    for (const { index } of overview.shown) {
      const box = cards.get(index)?.box;
      if (box) box.checked = isOn;
    }
    update();
  };
  const update = () => {
    words.textContent = `${count(names().length)} selected`;
    decisions.update();
  };
  const root = element(
    "section",
    { class: "batch", "aria-label": "Selection" },
    words,
    button("Select all shown", () => setAll(true)),
    button("Select none", () => setAll(false)),
    decisions.root,
  );
  return { root, update, names };
}
