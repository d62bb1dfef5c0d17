// How far a fixture is from its golden, for an order of fixtures: what people see first.

// What distance is, worst first: the visible error of the whole picture (mean
// FLIP), then how much of it differs, then by how much one pixel does. All
// zero for a match; null where there is nothing to compare.
function distanceOf(fixture) {
  if (fixture.flip_mean === null || fixture.flip_mean === undefined)
    return hasFailed(fixture) ? null : [0, 0, 0];
  return [fixture.flip_mean, fixture.differing_pixels ?? 0, fixture.max_abs ?? 0];
}

function isDifferent(fixture) {
  return (fixture.differing_pixels ?? 0) > 0;
}

// The share of a picture's pixels that differ; null where that is not known.
function differingShare(fixture) {
  if (!isDifferent(fixture) || !fixture.width || !fixture.height) return null;
  return fixture.differing_pixels / (fixture.width * fixture.height);
}

// The farther first; what cannot be compared, the first of all.
function fartherFirst(a, b) {
  const [left, right] = [distanceOf(a), distanceOf(b)];
  if (left === null || right === null) return Number(left !== null) - Number(right !== null);
  const at = left.findIndex((value, i) => value !== right[i]);
  return at < 0 ? 0 : right[at] - left[at];
}

// Whether this run has made a picture, a match's included, which is its golden.
function wasRendered(fixture) {
  return !fixture.cached && (fixture.has_actual || !hasFailed(fixture));
}

function timeOf(fixture) {
  return (fixture.render_ms ?? 0) + (fixture.compare_ms ?? 0) + (fixture.relate_ms ?? 0);
}
