// What is said of a fixture beside its pictures: findings, blame, commands.

// More findings than these are behind a fold.
const FINDINGS_SHOWN = 12;

function section(id, title, ...children) {
  return element(
    "section",
    { class: id, "aria-labelledby": `${id}-title` },
    element("h2", { id: `${id}-title` }, title),
    children,
  );
}

function findingsSection(fixture, hasSource) {
  const { findings, breaks_expectations, breaks_relations, line } = fixture;
  if (findings.length === 0) return null;
  const list = (part) =>
    element(
      "ul",
      {},
      part.map((finding) => element("li", {}, findingText(finding))),
    );
  const rest = findings.slice(FINDINGS_SHOWN);
  const more =
    rest.length > 0
      ? element("details", {}, element("summary", {}, `${count(rest.length)} more`), list(rest))
      : null;
  const broken = breaks_expectations || breaks_relations;
  const word = broken
    ? element(
        "p",
        { class: "note" },
        "The picture breaks what its fixture says on paper, so it cannot be accepted.",
      )
    : null;
  return section(
    "findings",
    findings.length === 1 ? "Finding" : "Findings",
    list(findings.slice(0, FINDINGS_SHOWN)),
    more,
    hasSource && Number.isInteger(line) ? placeLink(fixture) : null,
    word,
  );
}

// What has lines points into a source by carets, so it keeps its columns.
function findingText(finding) {
  return finding.includes("\n") ? element("pre", {}, finding) : finding;
}

// Of what was never rendered, what is said is all there is to see, and wide.
function isReport({ findings, has_actual }) {
  return !has_actual && findings.some((finding) => finding.includes("\n"));
}

// To where in the source it is to be looked for.
function placeLink({ line, column }) {
  const words = `line ${line}${Number.isInteger(column) ? `, column ${column}` : ""}`;
  return element(
    "p",
    { class: "led" },
    "In the source: ",
    button(words, () => showLine(line), { class: "link" }),
  );
}

function blameSection({ blamed }) {
  if (blamed.length === 0) return null;
  const title = [
    "The difference lies on",
    element("span", { class: "of" }, " (share of the sum of all differences of codes)"),
  ];
  return section("blame", title, element("ul", {}, blamed.map(blameEntry)));
}

function blameEntry({ kind, line, pixels, share }) {
  const words = kind === null ? "the background" : line === null ? kind : `${kind}, line ${line}`;
  const name =
    line === null
      ? element("span", { class: "name" }, words)
      : button(words, () => showLine(line), { class: "link" });
  const bar = element("span", { class: "share", style: `--share: ${share}` });
  return element(
    "li",
    {},
    name,
    element("span", { class: "number" }, `${plural(pixels, "pixel", "pixels")}, ${percent(share)}`),
    bar,
  );
}

// What is typed to see it again, and to accept it.
function commandsSection(fixture) {
  const entries = [fixture.rerun ? ["Check it again", fixture.rerun] : null];
  if (fixture.command)
    entries.push([
      fixture.verdict === "orphan_golden" ? "If its fixture is gone for good" : "If it is meant",
      fixture.command,
    ]);
  const rows = entries.filter(Boolean).map(([words, command]) => commandRow(words, command));
  return rows.length > 0 ? section("commands", "Commands", rows) : null;
}

// Once it is decided here, nothing is left to be typed that decides it.
function hideRemedy(side, fixture) {
  const isDecided = Boolean(review.decisions[fixture.name]);
  for (const row of side.querySelectorAll(".command"))
    row.hidden = isDecided && row.querySelector("code").textContent === fixture.command;
}

function commandRow(words, command) {
  const text = element("code", { tabindex: "0" }, command);
  const copied = button(
    "Copy",
    async () => {
      copied.textContent = (await copyText(command, text)) ? "Copied" : "Select and copy";
      speak(copied.textContent);
    },
    { "aria-label": `Copy: ${command}` },
  );
  return element(
    "div",
    { class: "command" },
    element("span", { class: "words" }, words),
    text,
    copied,
  );
}

// Whether it was copied; a page that is no secure context must do without
// `navigator.clipboard`.
async function copyText(text, shown) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    getSelection().selectAllChildren(shown);
    return document.execCommand("copy");
  }
}
