// The difference of each channel, amplified until it can be seen.

const LARGEST_GAIN = 100;

// The gain at which the largest difference is as bright as can be.
function fullGain(differences) {
  const largest = differences.reduce((most, value) => Math.max(most, value), 1);
  return Math.min(Math.max(Math.floor(255 / largest), 1), LARGEST_GAIN);
}

function differenceLayer(golden, actual, gain) {
  const channel = (at) => Math.min(gain * Math.abs(golden.data[at] - actual.data[at]), 255);
  return makeLayer(golden.width, golden.height, (i) => [
    channel(4 * i),
    channel(4 * i + 1),
    channel(4 * i + 2),
  ]);
}

const DIFFERENCE_VIEW = {
  id: "difference",
  key: "4",
  label: "Difference",
  lacks: lacksPair,
  open(stage) {
    const { golden, actual } = stage.pictures;
    let gain = fullGain(stage.differences());
    let layer = differenceLayer(golden, actual, gain);
    const pane = makePane("Difference", golden, (draw) => draw(layer));
    const slider = makeSlider(
      "Amplified",
      1,
      LARGEST_GAIN,
      gain,
      (value) => `× ${value}`,
      (value) => {
        gain = value;
        layer = differenceLayer(golden, actual, gain);
        stage.redraw();
      },
    );
    return { panes: [pane], controls: slider };
  },
};
