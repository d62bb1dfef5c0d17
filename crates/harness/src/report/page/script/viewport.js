// Which part of a picture is seen, and how large: the same in every pane.

// Screen pixels per picture pixel that a step of zoom stops at, whole where a
// pixel is larger than a pixel.
const ZOOM_STOPS = [1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
const SMALLEST_SCALE = ZOOM_STOPS[0];
const LARGEST_SCALE = ZOOM_STOPS[ZOOM_STOPS.length - 1];

// Where single pixels are looked at.
const CLOSE_SCALE = 16;

// Pixels of equal size are worth so much of the pane, and no more.
const LEAST_WHOLE_SHARE = 0.75;

class Viewport {
  // Of pictures of so many pixels; `changed` is called whenever it moves.
  constructor(width, height, changed) {
    Object.assign(this, {
      width,
      height,
      changed,
      scale: 1,
      x: width / 2,
      y: height / 2,
      isFitted: true,
    });
    this.paneWidth = width;
    this.paneHeight = height;
  }

  // The size of a pane, in screen pixels.
  setPane(width, height) {
    this.paneWidth = width;
    this.paneHeight = height;
    if (this.isFitted) this.fit();
    else this.changed();
  }

  // The scale of the whole picture, as large as the pane allows.
  wholeScale() {
    const room = Math.min(this.paneWidth / this.width, this.paneHeight / this.height);
    const whole = Math.min(Math.floor(room), LARGEST_SCALE);
    return whole >= LEAST_WHOLE_SHARE * room ? whole : Math.min(room, LARGEST_SCALE);
  }

  // Whether the picture is no larger than when it is seen whole.
  isWhole() {
    return this.isFitted || this.scale <= this.wholeScale();
  }

  fit() {
    const scale = this.wholeScale();
    Object.assign(this, { scale, x: this.width / 2, y: this.height / 2, isFitted: true });
    this.changed();
  }

  // Shows the middle of a pixel in the middle of the pane.
  goTo(x, y, scale = Math.max(this.scale, CLOSE_SCALE)) {
    this.place(x + 1 / 2, y + 1 / 2, scale);
  }

  // Makes larger by a factor, what is at a point of the pane staying there.
  zoom(factor, at = { x: this.paneWidth / 2, y: this.paneHeight / 2 }) {
    const scale = Math.min(Math.max(this.scale * factor, SMALLEST_SCALE), LARGEST_SCALE);
    const [dx, dy] = [at.x - this.paneWidth / 2, at.y - this.paneHeight / 2];
    this.place(this.x + dx / this.scale - dx / scale, this.y + dy / this.scale - dy / scale, scale);
  }

  // To the next stop, up or down.
  step(isIn, at) {
    const larger = ZOOM_STOPS.find((stop) => stop > this.scale * 1.001) ?? LARGEST_SCALE;
    const smaller = ZOOM_STOPS.findLast((stop) => stop < this.scale * 0.999) ?? SMALLEST_SCALE;
    this.zoom((isIn ? larger : smaller) / this.scale, at);
  }

  // Moves by screen pixels.
  pan(dx, dy) {
    this.place(this.x - dx / this.scale, this.y - dy / this.scale, this.scale);
  }

  place(x, y, scale) {
    const within = (value, limit) => Math.min(Math.max(value, 0), limit);
    Object.assign(this, {
      x: within(x, this.width),
      y: within(y, this.height),
      scale,
      isFitted: false,
    });
    this.changed();
  }

  // Where in a pane the middle of a pixel is.
  pointOf({ x, y }) {
    return {
      x: this.paneWidth / 2 + (x + 1 / 2 - this.x) * this.scale,
      y: this.paneHeight / 2 + (y + 1 / 2 - this.y) * this.scale,
    };
  }

  // The pixel at a point of a pane; null beside the picture.
  pixelAt({ x, y }) {
    const column = Math.floor((x - this.paneWidth / 2) / this.scale + this.x);
    const row = Math.floor((y - this.paneHeight / 2) / this.scale + this.y);
    const isInside = 0 <= column && column < this.width && 0 <= row && row < this.height;
    return isInside ? { x: column, y: row } : null;
  }

  // Brings a pixel into view, moving no more than needed.
  reveal({ x, y }) {
    const [halfWidth, halfHeight] = [
      this.paneWidth / 2 / this.scale,
      this.paneHeight / 2 / this.scale,
    ];
    const toward = (center, pixel, half) =>
      Math.min(Math.max(center, pixel + 1 - half), Math.max(pixel + half, pixel + 1 - half));
    const [left, top] = [toward(this.x, x, halfWidth), toward(this.y, y, halfHeight)];
    if (left !== this.x || top !== this.y) this.place(left, top, this.scale);
    else this.changed();
  }
}
