// Numbers with their names, and wide tables.

function fact(name, value) {
  return element("div", {}, element("dt", {}, name), element("dd", {}, value));
}

function worstFact({ worst }) {
  if (!worst) return "no picture was compared";
  if (worst.error === 0) return "0";
  return [errorWords(worst.error), " in ", fixtureLink(worst.fixture), ` ${placeWords(worst.at)}`];
}

function edgeFact({ edge_off, edge_pixels }) {
  const share = edge_pixels > 0 ? ` (${percent(edge_off / edge_pixels)})` : "";
  return `${count(edge_off)} of ${count(edge_pixels)}${share}`;
}

// What is wider than the window is scrolled alone, also by keys.
function scrolled(child, label) {
  return element("div", { class: "scrolled", role: "region", "aria-label": label, tabindex: "0" }, child);
}
