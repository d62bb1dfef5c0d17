// The page of one fixture: its pictures, what is said of it, and its source.

// The view that is wanted, kept from one fixture to the next.
let wantedView = null;

function makeFixturePage(fixture, view) {
  wantedView = view ?? wantedView;
  const evidence = evidenceOf(fixture);
  const pictures = element(
    "div",
    { class: "pictures" },
    element("p", { class: "empty" }, "Reading the pictures…"),
  );
  const hasSource = typeof evidence.source === "string";
  const findings = findingsSection(fixture, hasSource);
  const isWide = isReport(fixture);
  const side = element(
    "div",
    { class: "side" },
    isWide ? null : findings,
    blameSection(fixture),
    metricsSection(fixture),
    commandsSection(fixture),
  );
  const decisions =
    isReviewing && hasFailed(fixture) ? decisionButtons(() => [fixture.name]) : null;
  const decision = element("span", { class: "decision" });
  const page = {
    fixture,
    viewer: null,
    isClosed: false,
    decide: (action) => decide(action, [fixture.name]),
  };
  const decided = () => {
    markDecision(decision, fixture.name);
    decisions?.update();
    hideRemedy(side, fixture);
  };
  decided();
  const forget = onDecisions(decided);
  page.root = [
    fixtureHeader(fixture, decision, decisions?.root),
    isWide ? findings : null,
    element("div", { class: "columns" }, pictures, side, sourceSection(fixture, evidence.source)),
  ].filter(Boolean);
  page.close = () => {
    page.isClosed = true;
    page.viewer?.close();
    forget();
  };
  page.ready = openViewer(page, evidence, pictures);
  return page;
}

// A picture that cannot be decoded is said, and the rest of the page stays.
async function openViewer(page, evidence, holder) {
  const { fixture } = page;
  try {
    const pictures = await loadPictures(fixture, evidence);
    if (page.isClosed) return;
    const went = (id) => {
      wantedView = id;
      rewriteHash(fixtureHash(fixture.name, id));
    };
    page.viewer = new Viewer(fixture, pictures, { went, showLine });
    holder.replaceChildren(page.viewer.root);
    page.viewer.open(wantedView);
  } catch (error) {
    holder.replaceChildren(
      element("p", { class: "empty" }, `The pictures cannot be shown: ${error.message}`),
    );
  }
}

function fixtureHeader(fixture, decision, decisions) {
  const { shown } = overview;
  const at = shown.indexOf(fixture);
  const area = fixture.area ? element("span", { class: "area" }, `${fixture.area}/`) : null;
  const place =
    at < 0
      ? null
      : element("span", { class: "number" }, `${count(at + 1)} of ${count(shown.length)}`);
  return element(
    "header",
    { class: "fixture-header" },
    element(
      "nav",
      { "aria-label": "Fixtures" },
      element("a", { href: overviewHash(overview.filters), title: "Key Esc" }, "All fixtures"),
      step(-1, "Previous", "k"),
      step(1, "Next", "j"),
      place,
    ),
    element("h1", {}, area, element("wbr"), fixture.leaf),
    element(
      "div",
      { class: "line" },
      verdictBadge(fixture),
      decision,
      element("span", { class: "number" }, fixtureFacts(fixture)),
      decisions,
    ),
  );
}

function step(by, words, key) {
  return button(words, () => goBy(by), { title: `Key ${key}`, disabled: neighbor(by) === null });
}

// Size, share and time, as far as there are any.
function fixtureFacts(fixture) {
  const size = fixture.width ? sizeWords(fixture) : null;
  const differing = isDifferent(fixture)
    ? `${plural(fixture.differing_pixels, "pixel differs", "pixels differ")} (${percent(differingShare(fixture) ?? 0)})`
    : null;
  const time = fixture.cached
    ? "unchanged since its last match"
    : wasRendered(fixture)
      ? `rendered in ${duration(fixture.render_ms)}`
      : null;
  return [size, differing, time, fixture.audited ? "an audit" : null].filter(Boolean).join(" · ");
}

// Of a name that no fixture has.
function makeUnknownPage(name) {
  const words = element(
    "p",
    { class: "empty" },
    "This report has no fixture of the name ",
    element("code", {}, name),
    ". ",
    element("a", { href: "#/" }, "All fixtures"),
  );
  return { root: [element("h1", {}, "No such fixture"), words], close() {} };
}

// The fixture that many places on in what the overview shows; null past its
// ends.
function neighbor(by) {
  const at = overview.shown.findIndex(({ name }) => name === parseHash(location.hash).name);
  return at < 0 ? null : (overview.shown[at + by] ?? null);
}

function goBy(by) {
  const next = neighbor(by);
  if (next) location.hash = fixtureHash(next.name, wantedView);
}
