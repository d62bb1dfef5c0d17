// Outcomes, errors and features in words.

// An outcome's name for people.
function outcomeWords(id) {
  return id.replace("_", " ");
}

function outcomeBadge(id) {
  return element("span", { class: "badge", "data-outcome": id }, outcomeWords(id));
}

// Smaller errors are written with an exponent.
const LEAST_PLAIN = 1e-2;

// An error with two digits, as 0.12 or 1.2e−5; null is one that is no finite number.
function errorWords(error) {
  if (error === null) return "not finite";
  const short = Number(error.toPrecision(2));
  if (short === 0 || Math.abs(short) >= LEAST_PLAIN) return count(short);
  return short.toExponential().replace("-", "−");
}

function placeWords(at) {
  return at ? `(${at[0]}, ${at[1]})` : "";
}

// A place in a fixture's file: the Torus of fixtures/a.ron:10:9.
function objectWords(fixture, seen) {
  if (seen.line === null) return "the background";
  return `the ${seen.kind} of fixtures/${fixture.name}.ron:${seen.line}:${seen.column}`;
}

// A feature's name, which may be parted between its words.
function featureName(name) {
  const parts = name.split(/(?<=[a-z])(?=[A-Z])/);
  return parts.flatMap((part, i) => (i === 0 ? [part] : [element("wbr"), part]));
}

// A fixture's name, which may be parted after its area.
function fixtureName(name) {
  const parts = name.split(/(?<=\/)/);
  return parts.flatMap((part, i) => (i === 0 ? [part] : [element("wbr"), part]));
}

function fixtureHash(name) {
  return `#/fixture/${name.split("/").map(encodeURIComponent).join("/")}`;
}

function cellHash(id, feature) {
  return `#/cell/${encodeURIComponent(id)}/${encodeURIComponent(feature)}`;
}

function fixtureLink(name) {
  return element("a", { href: fixtureHash(name), class: "name" }, fixtureName(name));
}

// What a failure may be put down to, as a sentence.
function suspectWords({ features, pairs }) {
  if (features.length > 0) {
    const which = features.length === 1 ? "the only feature" : "the features";
    const told = [features.slice(0, -1).join(", "), features.at(-1)].filter(Boolean).join(" or ");
    return `It may be ${told}: ${which} of it that no passing fixture has.`;
  }
  if (pairs.length > 0) {
    const told = pairs.map(([one, other]) => `${one} with ${other}`).join(", or ");
    return `Each of its features passes elsewhere. No passing fixture has ${told}.`;
  }
  return "All that it asks for passes elsewhere, also in pairs: what is wrong is a case of this scene.";
}
