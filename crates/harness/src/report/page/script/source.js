// The fixture's text, with line numbers, a little color, and the lines marked that are to be looked at.

// Comments, strings, numbers, names of fields, names of things, in this order.
const RON_TOKEN =
  /(\/\/[^\n]*|\/\*[\s\S]*?\*\/)|("(?:\\.|[^"\\])*")|(-?\b\d[\d._]*(?:[eE][+-]?\d+)?)|(\b[A-Za-z_]\w*(?=\s*:))|(\b[A-Z]\w*|\btrue\b|\bfalse\b)/g;
const TOKEN_CLASSES = ["comment", "string", "number", "field", "thing"];

// `[{text, kind}]`, kind null for what is plain.
function ronTokens(text) {
  const tokens = [];
  let end = 0;
  for (const match of text.matchAll(RON_TOKEN)) {
    if (match.index > end) tokens.push({ text: text.slice(end, match.index), kind: null });
    tokens.push({
      text: match[0],
      kind: TOKEN_CLASSES[match.slice(1).findIndex((group) => group !== undefined)],
    });
    end = match.index + match[0].length;
  }
  if (end < text.length) tokens.push({ text: text.slice(end), kind: null });
  return tokens;
}

// Tokens line by line; one that spans lines is cut.
function tokenLines(tokens) {
  const lines = [[]];
  for (const { text, kind } of tokens) {
    text.split("\n").forEach((part, i) => {
      if (i > 0) lines.push([]);
      if (part !== "") lines[lines.length - 1].push({ text: part, kind });
    });
  }
  return lines;
}

// What is at the place a fixture's failure is looked for at first.
function placeWords({ verdict, breaks_expectations, breaks_relations }) {
  if (breaks_expectations) return "expected here";
  if (breaks_relations) return "related here";
  return verdict === "render_refused" ? "refused here" : "look here first";
}

function sourceLine(tokens, number, { blamed, place }) {
  const code = tokens.map(({ text, kind }) =>
    kind ? element("span", { class: `ron-${kind}` }, text) : text,
  );
  const note = blamed
    ? element("span", { class: "blame-note" }, `${percent(blamed.share)} of the difference`)
    : null;
  const marks = [blamed ? "is-blamed" : null, place ? "is-named" : null].filter(Boolean).join(" ");
  return element(
    "li",
    { id: `line-${number}`, class: marks || null, value: number },
    element("code", {}, code),
    place ? element("span", { class: "blame-note" }, place) : null,
    note,
  );
}

function sourceSection(fixture, text) {
  if (text === null || text === undefined) return null;
  const blamedByLine = new Map(
    fixture.blamed.filter((entry) => entry.line !== null).map((entry) => [entry.line, entry]),
  );
  // Of a difference the place is that of the object it lies on, which says so itself.
  const marksOf = (number) => {
    const blamed = blamedByLine.get(number);
    return { blamed, place: number === fixture.line && !blamed ? placeWords(fixture) : null };
  };
  const lines = tokenLines(ronTokens(text.replace(/\n$/, "")));
  return element(
    "section",
    { class: "source", "aria-labelledby": "source-title" },
    element("h2", { id: "source-title" }, fixture.path),
    element(
      "ol",
      { tabindex: "0", "aria-label": `Source of ${fixture.path}` },
      lines.map((tokens, i) => sourceLine(tokens, i + 1, marksOf(i + 1))),
    ),
  );
}

// Brings a line of the source into view.
function showLine(line) {
  const found = byId(`line-${line}`);
  if (!found) return;
  for (const other of document.querySelectorAll(".is-shown")) other.classList.remove("is-shown");
  found.classList.add("is-shown");
  found.scrollIntoView({ block: "center" });
  speak(`line ${line}: ${found.querySelector("code").textContent.trim()}`);
}
