// Side by side: the golden, the actual picture, and their difference where sizes agree.

const SIDES_VIEW = {
  id: "sides",
  key: "1",
  label: "Side by side",
  lacks: lacksTwo,
  open(stage) {
    const { golden, actual } = stage.pictures;
    const panes = [layerPane("Golden", golden.canvas), layerPane("Actual", actual.canvas)];
    if (lacksPair(stage.pictures, stage.fixture) !== null) return { panes };
    const gain = fullGain(stage.differences());
    panes.push(layerPane(`Difference × ${gain}`, differenceLayer(golden, actual, gain)));
    return { panes };
  },
};
