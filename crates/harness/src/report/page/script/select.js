// Which fixtures are shown, in which order.

const byName = (a, b) => (a.name < b.name ? -1 : Number(a.name > b.name));

// Its place among the failures, 0 for the worst; matches have none.
function rankOf(fixture) {
  return fixture.rank ?? Number.MAX_SAFE_INTEGER;
}

// Each order with its words and its comparison; ties are broken by name.
const SORTS = {
  failures: {
    words: "failures first",
    compare: (a, b) => rankOf(a) - rankOf(b) || fartherFirst(a, b),
  },
  name: { words: "by name", compare: byName },
  distance: { words: "by distance, worst first", compare: fartherFirst },
  time: { words: "by time, slowest first", compare: (a, b) => timeOf(b) - timeOf(a) },
};

function isShown(fixture, { verdicts, area, text }) {
  return (
    (verdicts.length === 0 || verdicts.includes(fixture.verdict)) &&
    (area === null || fixture.area === area) &&
    fixture.name.toLowerCase().includes(text.trim().toLowerCase())
  );
}

function selectFixtures(filters) {
  const { compare } = SORTS[filters.sort];
  return fixtures
    .filter((fixture) => isShown(fixture, filters))
    .sort((a, b) => compare(a, b) || byName(a, b));
}

// The number that says most in this order.
function telling(fixture, sort) {
  const time = wasRendered(fixture) ? duration(timeOf(fixture)) : "";
  if (sort === "time") return fixture.cached ? "unchanged" : time;
  if (isDifferent(fixture)) {
    return sort === "distance"
      ? `FLIP ${metricValue(fixture.flip_mean)}`
      : `${percent(differingShare(fixture) ?? 0)} differ`;
  }
  if (hasFailed(fixture))
    return fixture.findings.length > 1
      ? plural(fixture.findings.length, "finding", "findings")
      : "";
  return fixture.cached ? "unchanged" : time;
}

// Every area with how many fixtures it has.
function areasOf(all) {
  const counts = new Map();
  for (const { area } of all) counts.set(area, (counts.get(area) ?? 0) + 1);
  return [...counts].sort(([a], [b]) => (a < b ? -1 : 1));
}
