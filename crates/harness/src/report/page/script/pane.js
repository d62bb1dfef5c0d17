// A pane: a canvas that shows layers, canvases of the picture's size, through the viewport.

// From so many screen pixels per pixel on, lines part the pixels.
const GRID_SCALE = 8;

const GRID_COLOR = "rgb(128 128 128 / 0.25)";

// A figure with a caption and its canvas. `paint` is given `draw(layer)` and
// the canvas's context, size and pixel ratio, and puts the picture there.
function makePane(title, size, paint) {
  const canvas = element("canvas", {
    tabindex: "0",
    role: "application",
    "aria-roledescription": "picture",
    "aria-label": `${title}, ${size.width} by ${size.height} pixels. Arrow keys move the pixel cursor, plus and minus zoom.`,
  });
  const caption = element("figcaption", {}, title);
  return {
    canvas,
    caption,
    size,
    paint,
    root: element("figure", { class: "pane" }, caption, canvas),
  };
}

// Of one layer.
function layerPane(title, layer) {
  return makePane(title, layer, (draw) => draw(layer));
}

function drawPane(pane, viewport, cursor) {
  const { canvas } = pane;
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [
    Math.round(canvas.clientWidth * ratio),
    Math.round(canvas.clientHeight * ratio),
  ];
  if (width === 0 || height === 0) return;
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d");
  context.clearRect(0, 0, width, height);
  const scale = viewport.scale * ratio;
  const origin = {
    x: Math.round(width / 2 - viewport.x * scale),
    y: Math.round(height / 2 - viewport.y * scale),
  };
  // Below 1 pixels are averaged; above, each is seen as it is.
  context.imageSmoothingEnabled = scale < 1;
  const draw = (layer) =>
    context.drawImage(layer, origin.x, origin.y, layer.width * scale, layer.height * scale);
  pane.paint(draw, { context, width, height, ratio });
  if (viewport.scale >= GRID_SCALE) drawGrid(context, origin, scale, pane.size, { width, height });
  if (cursor) drawCursor(context, origin, scale, cursor, ratio);
}

function drawGrid(context, origin, scale, size, canvas) {
  const lines = (start, pixels, end) => {
    const first = Math.max(0, Math.floor(-start / scale));
    const last = Math.min(pixels, Math.ceil((end - start) / scale));
    return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) =>
      Math.round(start + (first + i) * scale),
    );
  };
  const [left, top] = [Math.max(origin.x, 0), Math.max(origin.y, 0)];
  const right = Math.min(origin.x + size.width * scale, canvas.width);
  const bottom = Math.min(origin.y + size.height * scale, canvas.height);
  context.fillStyle = GRID_COLOR;
  for (const x of lines(origin.x, size.width, canvas.width))
    context.fillRect(x, top, 1, bottom - top);
  for (const y of lines(origin.y, size.height, canvas.height))
    context.fillRect(left, y, right - left, 1);
}

// Black around white, so that it is seen on any picture.
function drawCursor(context, origin, scale, cursor, ratio) {
  const side = Math.max(scale, 3 * ratio);
  const [x, y] = [
    origin.x + (cursor.x + 1 / 2) * scale - side / 2,
    origin.y + (cursor.y + 1 / 2) * scale - side / 2,
  ];
  for (const [color, gap] of [
    ["#000", 2 * ratio],
    ["#fff", ratio],
  ]) {
    context.strokeStyle = color;
    context.lineWidth = ratio;
    context.strokeRect(x - gap / 2, y - gap / 2, side + gap, side + gap);
  }
}
