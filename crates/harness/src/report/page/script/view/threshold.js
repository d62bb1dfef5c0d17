// Which pixels differ by more than a threshold: marked on a dim picture, and counted.

const MARK_COLOR = [255, 64, 48];

// What is not marked has so little of its brightness.
const DIM = 0.35;

function countOver(differences, threshold) {
  return differences.reduce((sum, value) => sum + Number(value > threshold), 0);
}

function thresholdLayer(actual, marks) {
  return makeLayer(actual.width, actual.height, (i) => {
    if (marks[i]) return MARK_COLOR;
    const gray = DIM * brightness(actual.data, i);
    return [gray, gray, gray];
  });
}

// What is over the threshold, each pixel grown by so many to every side.
function marksOver(differences, threshold, width, growth) {
  const over = differences.map((value) => Number(value > threshold));
  return growth === 0 ? over : grown(grown(over, 1, width, growth), width, over.length, growth);
}

// Each mark also on `growth` pixels before and behind it, `step` apart, within
// its stretch of `length`.
function grown(marks, step, length, growth) {
  const found = marks.slice();
  for (let i = 0; i < marks.length; i++) {
    if (!marks[i]) continue;
    const start = i - (i % length);
    for (let n = -growth; n <= growth; n++) {
      const at = i + n * step;
      if (start <= at && at < start + length) found[at] = 1;
    }
  }
  return found;
}

// By how much a mark must grow to be a pixel of the screen: one that is lost
// among others would be one that nobody sees.
function growthAt(scale) {
  return scale < 1 ? Math.ceil(1 / (2 * scale)) : 0;
}

const THRESHOLD_VIEW = {
  id: "threshold",
  key: "7",
  label: "Threshold",
  lacks: lacksPair,
  open(stage) {
    const { actual } = stage.pictures;
    const differences = stage.differences();
    let threshold = 0;
    let made = {};
    const layerNow = () => {
      const growth = growthAt(stage.viewport.scale);
      if (made.threshold !== threshold || made.growth !== growth) {
        const marks = marksOver(differences, threshold, actual.width, growth);
        made = { threshold, growth, layer: thresholdLayer(actual, marks) };
      }
      return made.layer;
    };
    const pane = makePane("Over the threshold", actual, (draw) => draw(layerNow()));
    const words = (value) => {
      const over = countOver(differences, value);
      return `> ${value}: ${plural(over, "pixel", "pixels")} (${percent(over / differences.length)})`;
    };
    const slider = makeSlider("Differs by", 0, 255, 0, words, (value) => {
      threshold = value;
      stage.redraw();
    });
    return { panes: [pane], controls: slider };
  },
};
