// Why a view cannot be shown, as a sentence; null where it can.

function lacksGolden({ golden, isUnreadable }) {
  if (golden) return null;
  return isUnreadable ? "the golden cannot be read" : "there is no golden";
}

function lacksActual({ actual }, fixture) {
  if (actual) return null;
  if (fixture.cached) return "it was not rendered, as nothing changed since its last match";
  return "there is no picture of this run";
}

// Two pictures that are not one.
function lacksTwo(pictures, fixture) {
  const lacking = lacksGolden(pictures, fixture) ?? lacksActual(pictures, fixture);
  return lacking ?? (pictures.isGolden ? "the picture is the golden, byte for byte" : null);
}

// Two pictures of one size.
function lacksPair(pictures, fixture) {
  const lacking = lacksTwo(pictures, fixture);
  if (lacking) return lacking;
  const { golden, actual } = pictures;
  const isAlike = golden.width === actual.width && golden.height === actual.height;
  return isAlike
    ? null
    : `the golden has ${sizeWords(golden)} pixels, the picture ${sizeWords(actual)}`;
}

function sizeWords({ width, height }) {
  return `${width} × ${height}`;
}
