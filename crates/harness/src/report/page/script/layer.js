// Layers: pictures made from pictures, such as a difference or a map in colors.

// A canvas whose pixels are what `color(i)` says, `[r, g, b]` for pixel `i`.
function makeLayer(width, height, color) {
  const canvas = blankCanvas(width, height);
  const context = contextOf(canvas);
  const image = context.createImageData(width, height);
  const { data } = image;
  for (let i = 0; i < width * height; i++) {
    const at = 4 * i;
    [data[at], data[at + 1], data[at + 2]] = color(i);
    data[at + 3] = 255;
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

// By how much two pictures of one size differ in each pixel: the largest of
// its three channels.
function pixelDifferences(golden, actual) {
  const found = new Uint8Array(golden.width * golden.height);
  for (let i = 0; i < found.length; i++) {
    const channel = (c) => Math.abs(golden.data[4 * i + c] - actual.data[4 * i + c]);
    found[i] = Math.max(channel(0), channel(1), channel(2));
  }
  return found;
}

// How bright a pixel is, of 255.
//
// Source: ITU-R BT.709, section 3, on the codes.
function brightness(data, i) {
  return 0.2126 * data[4 * i] + 0.7152 * data[4 * i + 1] + 0.0722 * data[4 * i + 2];
}

// Dark to bright, by way of violet and orange, as even to the eye as a ramp of
// few colors can be: what is worse is brighter, also to the color-blind.
const HEAT_COLORS = [
  [0, 0, 4],
  [29, 17, 71],
  [81, 18, 124],
  [130, 38, 129],
  [183, 55, 121],
  [231, 82, 99],
  [252, 137, 97],
  [254, 196, 136],
  [252, 253, 191],
];

// The color of `share`, from 0 to 1.
function heatColor(share) {
  const place = share * (HEAT_COLORS.length - 1);
  const below = Math.min(Math.floor(place), HEAT_COLORS.length - 2);
  const mix = (c) =>
    Math.round(
      HEAT_COLORS[below][c] + (place - below) * (HEAT_COLORS[below + 1][c] - HEAT_COLORS[below][c]),
    );
  return [mix(0), mix(1), mix(2)];
}

const HEAT_TABLE = Array.from({ length: 256 }, (_, code) => heatColor(code / 255));

// A ramp with what its ends stand for.
function heatLegend(low, high) {
  const steps = HEAT_COLORS.map((color) => `rgb(${color.join(" ")})`).join(", ");
  return element(
    "div",
    { class: "legend" },
    low,
    element("span", { class: "ramp", style: `background: linear-gradient(to right, ${steps})` }),
    high,
  );
}
