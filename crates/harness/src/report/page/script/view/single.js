// The golden alone, and the actual picture alone.

const GOLDEN_VIEW = {
  id: "golden",
  key: "g",
  label: "Golden",
  lacks: lacksGolden,
  open: ({ pictures }) => ({ panes: [layerPane("Golden", pictures.golden.canvas)] }),
};

const ACTUAL_VIEW = {
  id: "actual",
  key: "p",
  label: "Actual",
  lacks: lacksActual,
  open: ({ pictures }) => ({ panes: [layerPane("Actual", pictures.actual.canvas)] }),
};
