// Swipe: the golden left of a line, the actual picture right of it, and the line to be moved.

// In percent of the pane: an arrow key, and with shift or by page.
const SMALL_STEP = 1;
const LARGE_STEP = 10;

const SWIPE_VIEW = {
  id: "swipe",
  key: "3",
  label: "Swipe",
  lacks: lacksTwo,
  open(stage) {
    const { golden, actual } = stage.pictures;
    let place = 50;
    const larger = {
      width: Math.max(golden.width, actual.width),
      height: Math.max(golden.height, actual.height),
    };
    const pane = makePane("Golden | Actual", larger, (draw, at) => {
      const edge = Math.round((at.width * place) / 100);
      clipped(at, 0, edge, () => draw(golden.canvas));
      clipped(at, edge, at.width, () => draw(actual.canvas));
    });
    const handle = element("div", {
      class: "swipe",
      role: "slider",
      tabindex: "0",
      "aria-label": "Golden up to here",
      "aria-valuemin": "0",
      "aria-valuemax": "100",
    });
    const moveTo = (value) => {
      place = Math.min(Math.max(value, 0), 100);
      handle.style.left = `${place}%`;
      handle.setAttribute("aria-valuenow", String(Math.round(place)));
      handle.setAttribute("aria-valuetext", `${Math.round(place)} percent golden`);
      stage.redraw();
    };
    const placeOf = (event) =>
      (100 * (event.clientX - pane.canvas.getBoundingClientRect().left)) / pane.canvas.clientWidth;
    handle.addEventListener("pointerdown", (event) => handle.setPointerCapture(event.pointerId));
    handle.addEventListener(
      "pointermove",
      (event) => handle.hasPointerCapture(event.pointerId) && moveTo(placeOf(event)),
    );
    handle.addEventListener("keydown", (event) => moveByKey(event, place, moveTo));
    pane.root.append(element("div", { class: "over" }, handle));
    moveTo(place);
    return { panes: [pane] };
  },
};

function clipped({ context, height }, left, right, paint) {
  context.save();
  context.beginPath();
  context.rect(left, 0, right - left, height);
  context.clip();
  paint();
  context.restore();
}

function moveByKey(event, place, moveTo) {
  const step = event.shiftKey ? LARGE_STEP : SMALL_STEP;
  const places = {
    ArrowLeft: place - step,
    ArrowDown: place - step,
    ArrowRight: place + step,
    ArrowUp: place + step,
    PageDown: place - LARGE_STEP,
    PageUp: place + LARGE_STEP,
    Home: 0,
    End: 100,
  };
  if (!Object.hasOwn(places, event.key)) return;
  event.preventDefault();
  event.stopPropagation();
  moveTo(places[event.key]);
}
