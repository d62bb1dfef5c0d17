// Wheel, double click and keys on a pane, as moves of the viewport and the cursor.

// A notch of a wheel, about 100 pixels, is a factor of 1.26.
const WHEEL_PIXELS_PER_DOUBLING = 300;

// Firefox counts lines instead of pixels.
const WHEEL_LINE_PIXELS = 16;

// How far the cursor goes with shift.
const CURSOR_LEAP = 10;

function pointIn(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}

// `moves` has `viewport`, `hover(point or null)`, `putCursor(place)` and
// `moveCursor(dx, dy)`.
function listenToPane(canvas, moves) {
  canvas.addEventListener("wheel", (event) => zoomByWheel(canvas, event, moves.viewport), {
    passive: false,
  });
  canvas.addEventListener("dblclick", (event) =>
    toggleClose(pointIn(canvas, event), moves.viewport),
  );
  canvas.addEventListener("pointerleave", () => moves.hover(null));
  canvas.addEventListener("keydown", (event) => moveCursorByKey(event, moves));
  listenToPointers(canvas, moves);
}

// Never below the whole picture: from there on the wheel is the page's, as is one
// that scrolls the page already, which cannot be taken from it.
function zoomByWheel(canvas, event, viewport) {
  const isOfPage = event.deltaY > 0 && viewport.isWhole();
  if (isOfPage || event.deltaY === 0 || !event.cancelable) return;
  event.preventDefault();
  const pixels =
    event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * WHEEL_LINE_PIXELS : event.deltaY;
  const factor = 2 ** (-pixels / WHEEL_PIXELS_PER_DOUBLING);
  if (factor < 1 && viewport.scale * factor <= viewport.wholeScale()) viewport.fit();
  else viewport.zoom(factor, pointIn(canvas, event));
}

// Close to where it was clicked, or back to the whole picture.
function toggleClose(at, viewport) {
  if (viewport.isFitted) viewport.zoom(CLOSE_SCALE / viewport.scale, at);
  else viewport.fit();
}

function moveCursorByKey(event, { moveCursor }) {
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const step = steps[event.key];
  if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  event.stopPropagation();
  const leap = event.shiftKey ? CURSOR_LEAP : 1;
  moveCursor(step[0] * leap, step[1] * leap);
}
