// What the page carries: the report, read at once, and each fixture's evidence, read when needed.

const report = JSON.parse(byId("report").textContent);

// Every fixture with its place in the report and its area: what its name has
// before the last slash.
const fixtures = report.fixtures.map((fixture, index) => {
  const slash = fixture.name.lastIndexOf("/");
  return {
    ...fixture,
    limits: fixture.limits ?? [],
    index,
    area: fixture.name.slice(0, Math.max(slash, 0)),
    leaf: fixture.name.slice(slash + 1),
  };
});

const fixtureByName = new Map(fixtures.map((fixture) => [fixture.name, fixture]));

const wordsOfVerdict = new Map(report.verdicts.map((verdict) => [verdict.id, verdict.words]));

function verdictWords(fixture) {
  return wordsOfVerdict.get(fixture.verdict) ?? fixture.verdict;
}

function hasFailed(fixture) {
  return fixture.verdict !== "match";
}

// The evidence of a fixture: source, pictures and maps as they are in the
// page. It is large, so only what it is made into is kept.
function evidenceOf(fixture) {
  const holder = byId(`fixture-${fixture.index}`);
  return holder ? JSON.parse(holder.textContent) : {};
}

// Whether today's picture is the golden, and so is not in the page a second
// time.
function isLeftOut(fixture, evidence) {
  return !evidence.actual && !hasFailed(fixture) && !fixture.cached;
}
