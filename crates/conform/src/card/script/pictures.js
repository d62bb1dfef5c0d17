// Pictures side by side: goldray's, the renderer's, where they differ, and the worst pixel marked in each.

// A small picture is enlarged by whole numbers, to about this many pixels of the screen.
const SEEN_WIDTH = 330;

function pngUrl(base64) {
  return `data:image/png;base64,${base64}`;
}

// A picture with a caption; `mark` is a pixel with a ring around it.
function figure(base64, size, caption, mark = null) {
  const scale = Math.max(1, Math.floor(SEEN_WIDTH / size[0]));
  const picture = element("img", {
    src: pngUrl(base64),
    alt: caption,
    width: size[0] * scale,
    height: size[1] * scale,
    decoding: "async",
  });
  const frame = element("span", { class: "picture" }, picture, mark ? ring(mark, size) : null);
  return element("figure", {}, frame, element("figcaption", {}, caption));
}

// A ring around a pixel.
function ring([x, y], [width, height]) {
  const made = element("span", { class: "ring", "aria-hidden": "true" });
  made.style.left = `${(100 * (x + 0.5)) / width}%`;
  made.style.top = `${(100 * (y + 0.5)) / height}%`;
  return made;
}

// A picture's place where there is none.
function noFigure(caption, why) {
  const frame = element("span", { class: "picture is-none" }, why);
  return element("figure", {}, frame, element("figcaption", {}, caption));
}

// The three pictures of a result.
function resultPictures(fixture, id) {
  const result = fixture.results[id];
  const pictures = picturesOf(fixture);
  if (pictures.left_out) {
    return element("p", { class: "soft" }, "Its pictures are left out, as the page would be too large.");
  }
  const own = pictures.by?.[id];
  if (!own) return null;
  const mark = result.numbers?.interior_off > 0 ? result.numbers.worst_at : null;
  const show = (base64, caption, why) =>
    base64 ? figure(base64, pictures.size, caption, mark) : noFigure(caption, why);
  const reference = own.reference ?? pictures.reference;
  return element(
    "div",
    { class: "pictures" },
    show(reference, "goldray", "no picture: a value in it is no number"),
    show(own.is_same ? reference : own.actual, nameOf(id), "no picture: a value in it is no number"),
    show(own.difference, "Difference", "no pixel is beyond the tolerance"),
  );
}

function swatch(color) {
  const made = element("span", { class: "swatch", "aria-hidden": "true" });
  made.style.background = `rgb(${color.join(" ")})`;
  return made;
}

// What the colors of a difference mean.
function differenceLegend() {
  const { heat, edge, step } = card.colors;
  const most = step ** (heat.length - 1);
  return element(
    "p",
    { class: "legend soft" },
    "In a difference: ",
    heat.map((color) => swatch(color)),
    ` interior pixels, from just beyond the tolerance to ${count(most)} times it; `,
    swatch(edge),
    " edge pixels beyond it, which are no failure unless the adapter says so. The ring is around the worst pixel. Errors are relative to the brightest channel of goldray's pixel, and where that is darker than a hundredth of white, or of the picture's brightest, to such a hundredth.",
  );
}
