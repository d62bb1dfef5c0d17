// Mouse, pen and fingers on a pane: one drags, two pinch, and what does neither puts the cursor.

// A hand is not still: less than this, in screen pixels, is no drag.
const CLICK_SLACK_PX = 4;

function listenToPointers(canvas, moves) {
  // Of each that is down: where it was seen last, and how far it has come.
  const down = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    down.set(event.pointerId, { at: pointIn(canvas, event), travel: 0 });
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = pointIn(canvas, event);
    if (down.has(event.pointerId)) dragOrPinch(down, event, at, moves.viewport);
    moves.hover(at);
  });
  canvas.addEventListener("pointerup", (event) => {
    const place = moves.viewport.pixelAt(pointIn(canvas, event));
    const isClick = down.size === 1 && down.get(event.pointerId)?.travel < CLICK_SLACK_PX;
    down.delete(event.pointerId);
    if (isClick && place) moves.putCursor(place);
  });
  canvas.addEventListener("pointercancel", (event) => down.delete(event.pointerId));
}

function dragOrPinch(down, { pointerId, pointerType }, at, viewport) {
  const pointer = down.get(pointerId);
  const before = pointer.at;
  const [dx, dy] = [at.x - before.x, at.y - before.y];
  // A finger on the whole picture is about to scroll the page.
  const isScroll = pointerType === "touch" && viewport.isFitted;
  if (down.size === 1 && !isScroll) viewport.pan(dx, dy);
  if (down.size === 2) {
    const [, other] = [...down].find(([id]) => id !== pointerId);
    pinch(before, at, other.at, viewport);
  }
  down.set(pointerId, { at, travel: pointer.travel + Math.hypot(dx, dy) });
}

// One of two has moved, and what is between them stays there.
function pinch(before, at, other, viewport) {
  const apart = (point) => Math.max(Math.hypot(point.x - other.x, point.y - other.y), 1);
  const middle = { x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 };
  viewport.pan((at.x - before.x) / 2, (at.y - before.y) / 2);
  viewport.zoom(apart(at) / apart(before), middle);
}
