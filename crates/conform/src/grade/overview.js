// The whole grade: points for each part, what is taken, and what went wrong.

const grade = JSON.parse(byId("grade").textContent);

// What the way back is called.
const HOME = "Grade";

const graded = grade.renderer.id;

function overviewPage() {
  const { title, renderer, held_to, points, of, parts, unasked, shared } = grade;
  return [
    element(
      "div",
      { class: points === of ? "headline is-green" : "headline" },
      element("h1", {}, `${title}: ${pointWords(points)} of ${pointWords(of)} points`),
      element("p", {}, renderer.name, renderer.version ? ` (${renderer.version.split("\n")[0]})` : "", `, held to ${held_to}`),
    ),
    scrolled(marksTable(), "Points"),
    namesLine("No part asks for", unasked),
    namesLine("Several parts ask for", shared),
    parts.some(({ passed, fixtures: all }) => passed < all.length) ? differenceLegend() : null,
    parts.map(partSection),
  ].filter(Boolean);
}

// Two decimals at most.
function pointWords(points) {
  return points.toLocaleString("en-US", { maximumFractionDigits: 2 });
}

const HOW = { share: "as many as pass", all: "all or nothing" };

function marksTable() {
  const titles = ["Part", "Points", "Of", "Pass", "How"];
  const row = ({ name, points, of, passed, per, fixtures: all }) =>
    markRow(name, pointWords(points), pointWords(of), `${count(passed)} of ${count(all.length)}`, HOW[per]);
  const taken = ({ name, points, fixtures: found }) =>
    markRow(name, points > 0 ? `−${pointWords(points)}` : "0", "", `${count(found.length)} found`, "penalty");
  const all = element("tr", { class: "total" }, element("th", { scope: "row" }, "All"), element("td", { class: "is-number" }, pointWords(grade.points)), element("td", { class: "is-number" }, pointWords(grade.of)), element("td", {}), element("td", {}));
  return element(
    "table",
    { class: "plain marks" },
    element("thead", {}, element("tr", {}, titles.map((title) => element("th", { scope: "col" }, title)))),
    element("tbody", {}, grade.parts.map(row), grade.penalties.map(taken), all),
  );
}

function markRow(name, points, of, passed, how) {
  const number = (value) => element("td", { class: "is-number" }, value);
  return element("tr", {}, element("th", { scope: "row" }, name), number(points), number(of), element("td", {}, passed), element("td", { class: "soft" }, how));
}

function namesLine(words, names) {
  if (names.length === 0) return null;
  const told = names.map((name, i) => [i > 0 ? ", " : "", fixtureByName.has(name) ? fixtureLink(name) : name]);
  return element("p", { class: "soft" }, `${words}: `, told, ".");
}

// A part: what went wrong with its pictures, and the names of what passes.
function partSection({ name, points, of, fixtures: all }, index) {
  const passing = all.filter(({ outcome }) => outcome === "pass");
  const others = all.filter(({ outcome }) => outcome !== "pass");
  const heading = `part-${index}`;
  return element(
    "section",
    { class: "part", "aria-labelledby": heading },
    element("h2", { id: heading }, `${name}: ${pointWords(points)} of ${pointWords(of)}`),
    others.map(partResult),
    passing.length > 0
      ? element("p", { class: "soft" }, element("span", { class: "badge", "data-outcome": "pass" }, "pass"), " ", passing.map(({ name }, i) => [i > 0 ? ", " : "", fixtureLink(name)]))
      : null,
  );
}

// What failed is open, as it is the evidence; of what was not asked there is a reason, and no picture.
function partResult({ name, outcome }) {
  if (outcome === null) return element("p", {}, `${name} was not run.`);
  const fixture = fixtureByName.get(name);
  return foldedResult(fixture, graded, hasFailed(fixture.results[graded]));
}
