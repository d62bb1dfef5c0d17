// The viewer: one view at a time of a fixture's pictures, with zoom, cursor and the numbers of a pixel.

// In the order of their buttons.
const VIEWS = [
  SIDES_VIEW,
  BLINK_VIEW,
  SWIPE_VIEW,
  DIFFERENCE_VIEW,
  SSIM_VIEW,
  FLIP_VIEW,
  THRESHOLD_VIEW,
  OBJECTS_VIEW,
  GOLDEN_VIEW,
  ACTUAL_VIEW,
];

// Where nothing is asked for: what says most.
const FAVORITES = ["sides", "actual", "golden"];

// The share of a window's height that panes may take, and one of several that
// stand below each other.
const PANE_SHARE = 0.62;
const STACKED_SHARE = 0.36;
const LEAST_PANE_PX = 120;

// Panes narrower than this stand below each other.
const LEAST_COLUMN_PX = 200;

// Pictures wider than so many times their height stand below each other.
const WIDE_ASPECT = 2.5;

class Viewer {
  // `went(view)` is told when another view is chosen, `showLine(line)` is asked
  // for a line of the source.
  constructor(fixture, pictures, { went, showLine }) {
    Object.assign(this, {
      fixture,
      pictures,
      went,
      showLine,
      cursor: null,
      pointer: null,
      hovered: null,
      view: null,
      shown: null,
    });
    const all = [pictures.golden, pictures.actual].filter(Boolean);
    const size = (side) => Math.max(1, ...all.map((picture) => picture[side]));
    this.viewport = new Viewport(size("width"), size("height"), () => this.redraw());
    this.readout = makeReadout(pictures, fixture);
    this.buttons = VIEWS.map((view) => this.viewButton(view));
    this.controls = element("div", { class: "view-controls" });
    this.note = element("p", { class: "note" });
    this.stage = element("div", { class: "stage" });
    this.zoomed = element("output", { class: "zoomed", "aria-label": "Zoom" });
    this.root = element(
      "section",
      { class: "viewer", "aria-labelledby": "viewer-title" },
      element("h2", { id: "viewer-title", class: "unseen" }, "Pictures"),
      element("div", { class: "views", role: "group", "aria-label": "View" }, this.buttons),
      this.note,
      this.controls,
      this.stage,
      element("div", { class: "tools" }, this.zoomTools(), this.jumps()),
      this.readout.root,
    );
    this.observer = new ResizeObserver(() => this.layOut());
    this.observer.observe(this.stage);
  }

  viewButton(view) {
    const reason = view.lacks(this.pictures, this.fixture);
    const label = [view.label, reason ? unseen(`, not here: ${reason}`) : null];
    const attributes = {
      "data-view": view.id,
      "aria-pressed": "false",
      title: reason ? `Not here: ${reason}` : `Key ${view.key}`,
    };
    if (reason) attributes["aria-disabled"] = "true";
    return button(label, () => this.choose(view.id), attributes);
  }

  zoomTools() {
    const step = (isIn) => () => this.step(isIn);
    return element(
      "div",
      { class: "zoom", role: "group", "aria-label": "Zoom" },
      button("−", step(false), { "aria-label": "Smaller", title: "Key −" }),
      this.zoomed,
      button("+", step(true), { "aria-label": "Larger", title: "Key +" }),
      button("Fit", () => this.viewport.fit(), { title: "Key 0, or double click" }),
    );
  }

  jumps() {
    const { ssim_min_at, flip_max_at, first_differing } = this.fixture;
    const jump = (words, at) =>
      at
        ? button(`${words} (${at[0]}, ${at[1]})`, () => this.lookAt({ x: at[0], y: at[1] }))
        : null;
    const isTold = isDifferent(this.fixture);
    return element(
      "div",
      { class: "jumps" },
      isTold
        ? [
            jump("Worst window", ssim_min_at),
            jump("Worst FLIP", flip_max_at),
            jump("First differing", first_differing),
          ]
        : null,
    );
  }

  // Shows the view that the reader asks for, and keeps in mind that it was.
  choose(id) {
    if (this.show(id)) this.went(id);
  }

  // Shows a view; one that cannot be says why.
  show(id) {
    const view = VIEWS.find((candidate) => candidate.id === id);
    const reason = view?.lacks(this.pictures, this.fixture);
    if (!view || reason) {
      if (reason) this.say(`${view.label} is not here: ${reason}.`);
      return false;
    }
    const lacking = lacksPair(this.pictures, this.fixture);
    this.note.textContent = lacking ? `Nothing to compare: ${lacking}.` : "";
    if (view === this.view) return true;
    this.shown?.close?.();
    this.view = view;
    this.shown = null;
    this.shown = view.open(this);
    this.controls.replaceChildren(...[this.shown.controls].filter(Boolean));
    for (const pane of this.shown.panes) listenToPane(pane.canvas, this.moves());
    this.stage.replaceChildren(...this.shown.panes.map((pane) => pane.root));
    for (const made of this.buttons)
      made.setAttribute("aria-pressed", String(made.dataset.view === id));
    this.layOut();
    return true;
  }

  // The wanted view, or else the one that says most.
  open(wanted) {
    const first = [wanted, ...FAVORITES].find((id) => id && this.show(id));
    if (!first)
      this.stage.replaceChildren(
        element(
          "p",
          { class: "empty" },
          "There is no picture: neither a golden, nor one of this run.",
        ),
      );
  }

  say(words) {
    this.note.textContent = words;
    speak(words);
  }

  moves() {
    return {
      viewport: this.viewport,
      hover: (point) => this.hover(point),
      putCursor: (place) => this.putCursor(place),
      moveCursor: (dx, dy) => this.moveCursor(dx, dy),
    };
  }

  // At a point of a pane.
  hover(point) {
    this.pointer = point;
    this.read();
  }

  // The pixel under the pointer, which is another one when the picture moves;
  // else that of the cursor.
  read() {
    this.hovered = this.pointer ? this.viewport.pixelAt(this.pointer) : null;
    this.readout.show(this.hovered ?? this.cursor);
  }

  moveCursor(dx, dy) {
    const { width, height } = this.viewport;
    const within = (value, limit) => Math.min(Math.max(value, 0), limit - 1);
    const from = this.cursor ?? this.hovered;
    const middle = { x: Math.floor(this.viewport.x), y: Math.floor(this.viewport.y) };
    const to = from ? { x: from.x + dx, y: from.y + dy } : middle;
    this.putCursor({ x: within(to.x, width), y: within(to.y, height) });
    this.viewport.reveal(this.cursor);
  }

  lookAt(place) {
    this.putCursor(place);
    this.viewport.goTo(place.x, place.y);
  }

  // To the next stop of zoom, about the pixel that is kept, which is what is
  // looked at; about the middle where there is none.
  step(isIn) {
    if (this.cursor) this.viewport.reveal(this.cursor);
    this.viewport.step(isIn, this.cursor ? this.viewport.pointOf(this.cursor) : undefined);
  }

  putCursor(place) {
    this.cursor = place;
    this.pointer = null;
    this.readout.announce(place);
    this.redraw();
  }

  // By how much the pictures differ, a number for each pixel.
  differences() {
    this.found ??= pixelDifferences(this.pictures.golden, this.pictures.actual);
    return this.found;
  }

  layOut() {
    const panes = this.shown?.panes ?? [];
    if (panes.length === 0 || !this.stage.isConnected) return;
    const { width, height } = this.viewport;
    const isRow =
      width / height <= WIDE_ASPECT && this.stage.clientWidth >= LEAST_COLUMN_PX * panes.length;
    const columns = isRow ? panes.length : 1;
    const room = window.innerHeight * (columns < panes.length ? STACKED_SHARE : PANE_SHARE);
    this.stage.style.setProperty("--columns", String(columns));
    const paneWidth = panes[0].canvas.clientWidth;
    const paneHeight = Math.round(
      Math.max(Math.min((paneWidth * height) / width, room), LEAST_PANE_PX),
    );
    this.stage.style.setProperty("--pane-height", `${paneHeight}px`);
    this.viewport.setPane(paneWidth, paneHeight);
  }

  redraw() {
    this.zoomed.textContent = `${Math.round(100 * this.viewport.scale)} %`;
    this.zoomed.dataset.scale = this.viewport.scale;
    // A drag at the whole picture's size scrolls the page, on a touch screen.
    this.stage.classList.toggle("is-fitted", this.viewport.isFitted);
    for (const pane of this.shown?.panes ?? []) drawPane(pane, this.viewport, this.cursor);
    this.read();
  }

  close() {
    this.shown?.close?.();
    this.observer.disconnect();
  }
}
