// Maps of what is seen to be wrong: SSIM, window by window, and FLIP, pixel by pixel.

function mapView(id, key, label, legend, codeOf) {
  return {
    id,
    key,
    label,
    lacks: (pictures, fixture) =>
      lacksPair(pictures, fixture) ?? (pictures[id] ? null : `there is no map of ${label}`),
    open({ pictures }) {
      const map = pictures[id];
      const layer = makeLayer(map.width, map.height, (i) => HEAT_TABLE[codeOf(map.data[4 * i])]);
      return { panes: [layerPane(label, layer)], controls: legend() };
    },
  };
}

// A window that is alike is 255 in the page, and dark here, as all that is well.
const SSIM_VIEW = mapView(
  "ssim",
  "5",
  "SSIM",
  () => heatLegend("1 alike", "0 and below: nothing alike"),
  (code) => 255 - code,
);

const FLIP_VIEW = mapView(
  "flip",
  "6",
  "FLIP",
  () => heatLegend("0, no visible error", "1, as far as colors are apart"),
  (code) => code,
);
