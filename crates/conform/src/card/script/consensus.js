// Who is the odd one out: over all scenes, and in one.

function consensusSection() {
  const { fixtures: scenes, agreed, undecided, voters } = card.consensus;
  const heading = element("h2", { id: "consensus" }, "Consensus");
  if (scenes === 0) {
    return element(
      "section",
      { "aria-labelledby": "consensus" },
      heading,
      element("p", { class: "soft" }, "No scene has pictures of three renderers or more, goldray's own included: nobody can be the odd one out."),
    );
  }
  const said = `Of ${plural(scenes, "scene", "scenes")} with pictures of three renderers or more, goldray included, all agree in every interior pixel of ${agreed === 0 ? "none" : count(agreed)}.`;
  const none = undecided > 0 ? ` In ${plural(undecided, "interior pixel", "interior pixels")} there is no majority.` : "";
  return element(
    "section",
    { "aria-labelledby": "consensus" },
    heading,
    element("p", {}, said, none),
    scrolled(votersTable(voters), "Who stands alone"),
  );
}

function votersTable(voters) {
  const order = ["goldray", ...renderers.map(({ id }) => id)];
  const sorted = voters.toSorted((a, b) => order.indexOf(a.id) - order.indexOf(b.id));
  const titles = ["Renderer", "Scenes", "Alone, interior pixels", "Alone, edge pixels", "With others", "Most of it in"];
  return element(
    "table",
    { class: "plain" },
    element("thead", {}, element("tr", {}, titles.map((title) => element("th", { scope: "col" }, title)))),
    element("tbody", {}, sorted.map(voterRow)),
  );
}

function voterRow({ id, heard, alone, with_others, alone_in }) {
  const most = alone_in.slice(0, 3).map(({ fixture, pixels }, i) => [i > 0 ? ", " : "", fixtureLink(fixture), ` ${count(pixels)}`]);
  const more = alone_in.length > 3 ? ` and ${count(alone_in.length - 3)} more` : "";
  return element(
    "tr",
    {},
    element("th", { scope: "row" }, nameOf(id)),
    [heard, alone.interior, alone.edge, with_others.interior].map((value) => element("td", { class: "is-number" }, count(value))),
    element("td", { class: "is-wide" }, most, more),
  );
}

// The consensus of a scene: a picture, and its regions.
function fixtureConsensus(fixture) {
  const told = fixture.consensus;
  if (!told) return null;
  const heard = `Heard: ${told.voters.map(nameOf).join(", ")}.`;
  const not = told.unheard.length > 0 ? ` Without a picture that says anything: ${told.unheard.map(nameOf).join(", ")}.` : "";
  const { consensus: picture, size } = picturesOf(fixture);
  const apart = told.opinions.filter(({ opinion }) => opinion !== "agree");
  return element(
    "section",
    { class: "sheet-of-one", "aria-labelledby": "told" },
    element("h2", { id: "told" }, "Consensus"),
    element("p", { class: "soft" }, heard, not),
    apart.length === 0 ? element("p", {}, "All agree in every pixel.") : null,
    element(
      "div",
      { class: "pictures" },
      picture ? figure(picture, size, "Who stands alone") : null,
      apart.length > 0 ? opinionsList(told, apart) : null,
    ),
    told.regions.length > 0 ? scrolled(regionsTable(fixture, told), "Regions") : null,
  );
}

// The color of pixels of this opinion.
function opinionColor(told, { opinion, against }) {
  if (opinion !== "against") return card.colors.undecided;
  return against.length === 1 ? card.colors.voters[told.voters.indexOf(against[0])] : card.colors.several;
}

function opinionsList(told, opinions) {
  const line = (one) =>
    element("li", {}, swatch(opinionColor(told, one)), `${one.words}: ${count(one.interior)} interior, ${count(one.edge)} edge pixels`);
  return element(
    "div",
    {},
    element("ul", { class: "opinions" }, opinions.map(line)),
    element("p", { class: "soft" }, "Edge pixels are darker."),
  );
}

function regionsTable(fixture, told) {
  const { regions, pixels } = told.regions_untold;
  const titles = ["Pixels", "From", "To", "Who", "Mostly on"];
  const row = (region) =>
    element(
      "tr",
      {},
      element("td", { class: "is-number" }, count(region.pixels)),
      element("td", {}, placeWords(region.from)),
      element("td", {}, placeWords(region.to)),
      element("td", {}, swatch(opinionColor(told, region)), region.words),
      element("td", {}, region.on ? objectWords(fixture, region.on) : "not known"),
    );
  return element(
    "table",
    { class: "plain" },
    element("caption", {}, "Interior pixels of one opinion that lie together, the largest regions first"),
    element("thead", {}, element("tr", {}, titles.map((title) => element("th", { scope: "col" }, title)))),
    element("tbody", {}, told.regions.map(row)),
    regions > 0
      ? element("tfoot", {}, element("tr", {}, element("td", { colspan: titles.length }, `${count(regions)} smaller ones of ${count(pixels)} pixels are not listed`)))
      : null,
  );
}
