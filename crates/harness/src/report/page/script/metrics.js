// The table of a fixture's metrics, held against its limits.

function metricsSection(fixture) {
  const isTold = report.metrics.some((metric) => typeof fixture[metric.name] === "number");
  if (!isTold && fixture.limits.length === 0) return null;
  const heads = ["metric", "value", fixture.limits.length > 0 ? "limit" : ""].map((words) =>
    words ? element("th", { scope: "col" }, words) : element("td"),
  );
  const rows = report.metrics.map((metric) => metricRow(metric, fixture));
  const word =
    fixture.limits.length === 0
      ? "It has no limits: every byte must be the same."
      : "What the fixture states must hold; the rest is reported.";
  return section(
    "metrics",
    "Metrics",
    element("p", { class: "note" }, word),
    element(
      "table",
      {},
      element("thead", {}, element("tr", {}, heads)),
      element("tbody", {}, rows),
    ),
  );
}

function metricRow(metric, fixture) {
  const limits = fixture.limits.filter((limit) => limit.metric === metric.name);
  const isBroken = limits.some((limit) => limit.broken);
  const value = fixture[metric.name] ?? null;
  const hasUnit = value !== null && metric.unit !== "1";
  const unit = hasUnit ? element("span", { class: "unit" }, ` ${metric.unit}`) : null;
  return element(
    "tr",
    { class: isBroken ? "is-broken" : null, "data-metric": metric.name },
    element("th", { scope: "row" }, metricName(metric)),
    element("td", {}, metricValue(value), unit),
    element("td", {}, limits.map(limitWords)),
  );
}

// Its name, with what it sees and does not see behind it.
function metricName(metric) {
  const arrow = isHigherBetter(metric) ? "↑" : "↓";
  const better = isHigherBetter(metric) ? "higher is closer" : "lower is closer";
  return element(
    "details",
    {},
    element(
      "summary",
      { title: `Blind to: ${metric.blind_spot}` },
      metric.name,
      element("span", { class: "arrow", "aria-hidden": "true" }, ` ${arrow}`),
      unseen(`, ${better}`),
    ),
    element("p", {}, sentence(`Measures ${metric.measures}`)),
    element("p", {}, sentence(`Range: ${metric.range}; ${better}`)),
    element("p", {}, sentence(`Blind to: ${metric.blind_spot}`)),
  );
}

// With a period, of which there is never a second.
function sentence(words) {
  return `${words.replace(/\.$/, "")}.`;
}

function isHigherBetter(metric) {
  return /higher/i.test(metric.direction);
}

// What is accepted, and whether it holds, where there was something to compare.
function limitWords({ limit, at_least, accepted, found, broken }) {
  const bound = `${at_least ? "≥" : "≤"} ${metricValue(accepted)}`;
  const word = broken ? "broken" : "held";
  if (found === null && !broken) return element("div", { class: "limit", title: limit }, bound);
  return element(
    "div",
    { class: `limit ${word}`, title: `${limit}: ${word}` },
    `${bound} `,
    element("span", { "aria-hidden": "true" }, broken ? "✗" : "✓"),
    unseen(`, the limit ${limit} is ${word}`),
  );
}
