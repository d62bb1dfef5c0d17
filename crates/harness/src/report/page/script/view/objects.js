// Which object each pixel shows: a color for each, its name under the pointer, the blamed ones first.

// Neighbors in the list are far apart on the wheel of hues.
const GOLDEN_ANGLE_DEG = 137.508;

// How much of an object's color lies over the gray picture; of one that is not
// asked for, less.
const COVER = 0.6;
const FAINT_COVER = 0.12;

// Bright and strong enough to be told apart over gray.
const LIGHTNESS = 0.6;
const SATURATION = 0.7;

// The color of object `id`, which is 1 or more; the background has none.
//
// Source: CSS Color Module Level 4, section 7.1, HSL to sRGB.
function objectColor(id) {
  const hue = (id * GOLDEN_ANGLE_DEG) % 360;
  const a = SATURATION * Math.min(LIGHTNESS, 1 - LIGHTNESS);
  const f = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (LIGHTNESS - a * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [f(0), f(8), f(4)];
}

function objectWords(places, id) {
  if (id === 0) return "background";
  const { kind, line } = places[id - 1] ?? { kind: "object", line: null };
  return line === null ? kind : `${kind}, line ${line}`;
}

function objectsLayer(picture, numbers, chosen) {
  return makeLayer(picture.width, picture.height, (i) => {
    const gray = brightness(picture.data, i);
    const cover =
      numbers[i] === 0 ? 0 : chosen === null || chosen === numbers[i] ? COVER : FAINT_COVER;
    const [r, g, b] = objectColor(numbers[i]);
    const mix = (color) => gray * (1 - cover) + color * cover;
    return [mix(r), mix(g), mix(b)];
  });
}

// The objects that are seen, the blamed first, then those with the most pixels.
function objectsInOrder({ places, numbers }, blamed) {
  const pixels = new Map();
  for (const id of numbers) pixels.set(id, (pixels.get(id) ?? 0) + 1);
  pixels.delete(0);
  const isAt = ({ line, column }, id) =>
    line === places[id - 1]?.line && column === places[id - 1]?.column;
  const share = (id) => blamed.find((entry) => isAt(entry, id))?.share ?? 0;
  const all = [...pixels].map(([id, area]) => ({ id, area, share: share(id) }));
  return all.sort((a, b) => b.share - a.share || b.area - a.area);
}

const OBJECTS_VIEW = {
  id: "objects",
  key: "8",
  label: "Objects",
  lacks: (pictures, fixture) =>
    lacksActual(pictures, fixture) ??
    (pictures.objects ? null : "objects are told of pictures that fail"),
  open(stage) {
    const { actual, objects } = stage.pictures;
    let layer = objectsLayer(actual, objects.numbers, null);
    const choose = (id) => {
      layer = objectsLayer(actual, objects.numbers, id);
      stage.redraw();
    };
    const pane = makePane("Objects", actual, (draw) => draw(layer));
    const entries = objectsInOrder(objects, stage.fixture.blamed).map((entry) =>
      objectEntry(entry, objects.places, choose, stage),
    );
    return {
      panes: [pane],
      controls: element(
        "ul",
        { class: "objects", "aria-label": "Objects in the picture" },
        entries,
      ),
    };
  },
};

function objectEntry({ id, area, share }, places, choose, stage) {
  const blamed =
    share > 0
      ? element(
          "strong",
          { title: "its share of the difference" },
          ` ${percent(share)}`,
          unseen(" of the difference"),
        )
      : null;
  const swatch = element("span", {
    class: "swatch",
    style: `background: rgb(${objectColor(id).join(" ")})`,
  });
  const shown = {
    pointerenter: () => choose(id),
    pointerleave: () => choose(null),
    focus: () => choose(id),
    blur: () => choose(null),
  };
  const line = places[id - 1]?.line ?? null;
  const act = () => line !== null && stage.showLine(line);
  return element(
    "li",
    {},
    button(
      [
        swatch,
        objectWords(places, id),
        element("span", { class: "number" }, ` ${count(area)} px`),
        blamed,
      ],
      act,
      shown,
    ),
  );
}
