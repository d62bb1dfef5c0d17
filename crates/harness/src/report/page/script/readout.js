// The numbers of one pixel: codes of golden and actual picture, their difference, linear values.

const NOTHING = "–";

// Where three values of nine digits would run into each other, as in the style.
const NARROW = matchMedia("(max-width: 560px)");

// The three codes of a pixel; null beside the picture.
function codesAt(picture, { x, y }) {
  if (!picture || x >= picture.width || y >= picture.height) return null;
  const at = 4 * (y * picture.width + x);
  return Array.from(picture.data.slice(at, at + 3));
}

// Linear values of a pixel in words: as computed where they are known,
// otherwise what the codes stand for, marked as not exact.
function linearAt(codes, exact, picture, { x, y }, transfer) {
  if (!codes) return null;
  if (exact) {
    const at = 3 * (y * picture.width + x);
    return Array.from(exact.slice(at, at + 3), NARROW.matches ? fewDigits : singleDigits);
  }
  const values = codes.map((code) => linearOfCode(code, transfer));
  return values.includes(null) ? null : values.map((value) => `≈ ${Number(value.toPrecision(3))}`);
}

// What is known of a pixel.
function pixelFacts(pictures, fixture, place) {
  const { golden, actual, linear, objects } = pictures;
  const [goldenCodes, actualCodes] = [codesAt(golden, place), codesAt(actual, place)];
  const both = goldenCodes && actualCodes;
  return {
    golden: goldenCodes,
    actual: actualCodes,
    difference: both ? actualCodes.map((code, c) => signed(code - goldenCodes[c])) : null,
    linearGolden: linearAt(goldenCodes, null, golden, place, fixture.transfer),
    linearActual: linearAt(actualCodes, linear, actual, place, fixture.transfer),
    object:
      objects && actualCodes
        ? objectWords(objects.places, objects.numbers[place.y * actual.width + place.x])
        : null,
  };
}

// A table of a pixel's numbers. `show(place)` fills it, null empties it;
// `announce(place)` also says it.
function makeReadout(pictures, fixture) {
  const place = element("span", { class: "place" });
  const rows = {
    golden: readoutRow("golden"),
    actual: readoutRow("actual"),
    difference: readoutRow("difference"),
  };
  const show = (at) => {
    const facts = at ? pixelFacts(pictures, fixture, at) : {};
    place.textContent = at
      ? `x ${at.x}, y ${at.y}${facts.object ? ` · ${facts.object}` : ""}`
      : "point at one, or click to keep it and go on by arrow keys";
    rows.golden.fill(facts.golden, facts.linearGolden, facts.golden);
    rows.actual.fill(facts.actual, facts.linearActual, facts.actual);
    rows.difference.fill(facts.difference, null, null);
  };
  show(null);
  const head = (text) => element("th", { scope: "colgroup", colspan: "3" }, text);
  const table = element(
    "table",
    { class: "readout" },
    element("caption", {}, element("b", {}, "Pixel "), place),
    element(
      "thead",
      {},
      element("tr", {}, element("td"), head("codes R G B"), head("linear R G B")),
    ),
    element(
      "tbody",
      {},
      Object.values(rows).map((row) => row.root),
    ),
  );
  return {
    root: table,
    show,
    announce: (at) => speak(spokenPixel(at, pixelFacts(pictures, fixture, at))),
  };
}

function readoutRow(name) {
  const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
  const cells = Array.from({ length: 6 }, () => element("td", {}, NOTHING));
  const fill = (codes, linear, color) => {
    const texts = [...(codes ?? Array(3).fill(NOTHING)), ...(linear ?? Array(3).fill(NOTHING))];
    cells.forEach((cell, i) => (cell.textContent = texts[i]));
    swatch.style.background = color ? `rgb(${color.join(" ")})` : "none";
  };
  return {
    root: element("tr", { "data-row": name }, element("th", { scope: "row" }, swatch, name), cells),
    fill,
  };
}

function spokenPixel({ x, y }, { golden, actual, difference, object }) {
  const part = (name, codes) => (codes ? `, ${name} ${codes.join(" ")}` : "");
  return `x ${x}, y ${y}${part("golden", golden)}${part("actual", actual)}${part("difference", difference)}${object ? `, ${object}` : ""}`;
}
