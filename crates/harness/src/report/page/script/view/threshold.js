// Which pixels differ by more than a threshold: marked on a dim picture, and counted.

const MARK_COLOR = [255, 64, 48];

// What is not marked has so little of its brightness.
const DIM = 0.35;

function countOver(differences, threshold) {
  return differences.reduce((sum, value) => sum + Number(value > threshold), 0);
}

function thresholdLayer(actual, differences, threshold) {
  return makeLayer(actual.width, actual.height, (i) => {
    if (differences[i] > threshold) return MARK_COLOR;
    const gray = DIM * brightness(actual.data, i);
    return [gray, gray, gray];
  });
}

const THRESHOLD_VIEW = {
  id: "threshold",
  key: "7",
  label: "Threshold",
  lacks: lacksPair,
  open(stage) {
    const { actual } = stage.pictures;
    const differences = stage.differences();
    let layer = thresholdLayer(actual, differences, 0);
    const pane = makePane("Over the threshold", actual, (draw) => draw(layer));
    const words = (threshold) => {
      const over = countOver(differences, threshold);
      return `> ${threshold}: ${plural(over, "pixel", "pixels")} (${percent(over / differences.length)})`;
    };
    const slider = makeSlider("Differs by", 0, 255, 0, words, (threshold) => {
      layer = thresholdLayer(actual, differences, threshold);
      stage.redraw();
    });
    return { panes: [pane], controls: slider };
  },
};
