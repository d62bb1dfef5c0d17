// The headline of the overview: what came out, how long it took, and how much of it is known from before.

function headline() {
  const { green } = report.summary;
  return element(
    "header",
    { class: `headline ${green ? "is-green" : "is-red"}` },
    element("h1", {}, outcomeWords(report.summary)),
    element("p", {}, runWords(report.summary)),
  );
}

function outcomeWords({ total, green }) {
  if (total === 0) return "Nothing was judged";
  if (green) return total === 1 ? "The fixture matches" : `All ${count(total)} fixtures match`;
  const failed = fixtures.filter(hasFailed).length;
  return `${count(failed)} of ${plural(total, "fixture fails", "fixtures fail")}`;
}

function runWords({ elapsed_ms, unchanged, audited, belied }) {
  const known = `${count(unchanged)} unchanged since their last match`;
  const parts = [
    `judged in ${duration(elapsed_ms)}`,
    unchanged > 0 ? `${known}, ${count(audited)} of them rendered again as an audit` : null,
    belied > 0 ? `${plural(belied, "record of a match is", "records of matches are")} wrong` : null,
  ];
  return parts.filter(Boolean).join(" · ");
}
