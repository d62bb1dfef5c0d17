// Each renderer in short: how many of its fixtures pass, what became of the rest, how far it is off.

// Then no feature is told from the others.
const NOTHING_PASSES =
  "No picture is right: what is wrong may be common to all, such as the transfer curve, the order of rows or where samples are taken.";

function summarySection() {
  return element(
    "section",
    { "aria-labelledby": "renderers" },
    element("h2", { id: "renderers" }, "Renderers"),
    element("ul", { class: "renderers" }, renderers.map(summaryCard)),
  );
}

// What counts as an edge unless an adapter allows more, in pixels.
const USUAL_REACH = 1 / 64;

function summaryCard({ id, name, version, tolerance, edge_reach, tally }) {
  const first = version.split("\n")[0];
  return element(
    "li",
    { class: "renderer", "data-id": id },
    element("h3", {}, name),
    element("p", { class: "soft version", title: version }, first || "version not asked"),
    element(
      "p",
      { class: "score" },
      element("strong", {}, count(tally.outcomes.pass)),
      ` of ${plural(tally.total, "fixture passes", "fixtures pass")}`,
    ),
    bar(tally),
    element("ul", { class: "counts" }, restCounts(tally)),
    tally.outcomes.pass === 0 && tally.outcomes.fail > 0 ? element("p", { class: "hint" }, NOTHING_PASSES) : null,
    element(
      "dl",
      { class: "facts" },
      fact("Worst interior error", worstFact(tally)),
      fact("Interior pixels off", `${count(tally.interior_off)} of ${count(tally.pixels - tally.edge_pixels)}`),
      fact("Edge pixels that differ", edgeFact(tally)),
      fact("Tolerance", errorWords(tolerance)),
      edge_reach > USUAL_REACH ? fact("Edges reach, in pixels", count(edge_reach)) : null,
    ),
  );
}

// The outcomes as lengths; the counts beside it say the same in words.
function bar({ total, outcomes }) {
  const parts = Object.entries(outcomes).filter(([, some]) => some > 0);
  const part = ([outcome, some]) => {
    const made = element("span", { "data-outcome": outcome });
    made.style.flexGrow = some;
    return made;
  };
  return element("div", { class: "bar-of-outcomes", "aria-hidden": "true" }, total > 0 ? parts.map(part) : null);
}

function restCounts({ outcomes }) {
  return Object.entries(outcomes)
    .filter(([outcome, some]) => some > 0 && outcome !== "pass")
    .map(([outcome, some]) =>
      element("li", { class: "badge", "data-outcome": outcome }, `${count(some)} ${outcomeWords(outcome)}`),
    );
}
