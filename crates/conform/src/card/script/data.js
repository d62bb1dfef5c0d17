// What the page carries: the card, read at once, and each fixture's pictures, read when they are looked at.

const card = JSON.parse(byId("card").textContent);

const renderers = card.renderers;

const rendererById = new Map(renderers.map((renderer) => [renderer.id, renderer]));

const fixtures = card.fixtures.map((fixture, index) => ({ ...fixture, index }));

const fixtureByName = new Map(fixtures.map((fixture) => [fixture.name, fixture]));

const rowByFeature = new Map(card.features.map((row) => [row.feature, row]));

const standingById = new Map(card.standings.map((standing) => [standing.id, standing]));

// The pictures of a fixture, as they are in the page.
function picturesOf(fixture) {
  return JSON.parse(byId(`fixture-${fixture.index}`)?.textContent ?? "{}");
}

// A result that is no pass, and was asked for.
function hasFailed(result) {
  return result !== undefined && !["pass", "unsupported"].includes(result.outcome);
}

// The name of a voter: goldray itself may not be among the renderers.
function nameOf(id) {
  return rendererById.get(id)?.name ?? id;
}
