// The whole card: renderers, features, consensus, fixtures.

// What the way back is called.
const HOME = "Scorecard";

function overviewPage() {
  if (renderers.length === 0 || fixtures.length === 0) {
    return [element("h1", {}, "No renderer was asked for a picture"), element("p", { class: "soft" }, "A card is made of runs, by the verb conform.")];
  }
  const one = renderers.length === 1 ? renderers[0] : null;
  const title = one
    ? `${one.name} passes ${count(one.tally.outcomes.pass)} of ${plural(one.tally.total, "fixture", "fixtures")}`
    : `${count(renderers.length)} renderers, ${plural(fixtures.length, "fixture", "fixtures")}`;
  return [element("div", { class: "headline" }, element("h1", {}, title), selectionLine()), summarySection(), matrixSection(), consensusSection(), tableSection()];
}

// That only a part of the suite was asked for, and which; nothing where it was all.
function selectionLine() {
  return card.selection ? element("p", { class: "selection" }, `${card.selection.words}.`) : null;
}
