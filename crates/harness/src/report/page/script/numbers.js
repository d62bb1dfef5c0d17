// Numbers as people read them.

// 12345 as 12,345.
function count(value) {
  return value.toLocaleString("en-US");
}

function plural(value, one, many) {
  return `${count(value)} ${value === 1 ? one : many}`;
}

const MS_PER_S = 1000;

function duration(ms) {
  if (ms >= MS_PER_S) return `${(ms / MS_PER_S).toFixed(2)} s`;
  return `${ms < 10 ? ms.toFixed(1) : Math.round(ms)} ms`;
}

// A share of 1 in percent. None and all are only said of none and all.
function percent(share) {
  const value = 100 * share;
  if (value === 0 || value === 100) return `${value} %`;
  if (value < 0.01) return "< 0.01 %";
  return `${value < 1 ? value.toFixed(2) : Math.min(value, 99.9).toFixed(1)} %`;
}

// Smaller values would have few digits left of six decimals.
const LEAST_OF_SIX_DECIMALS = 1e-3;

// A metric's value: whole numbers whole, others to six decimals.
function metricValue(value) {
  if (value === null || value === undefined) return "–";
  if (Number.isInteger(value)) return count(value);
  return String(
    Number(Math.abs(value) < LEAST_OF_SIX_DECIMALS ? value.toPrecision(3) : value.toFixed(6)),
  );
}

// A difference with its sign.
function signed(value) {
  if (value === 0) return "0";
  return value > 0 ? `+${value}` : `−${-value}`;
}

// Four digits of it, marked where there are more.
function fewDigits(value) {
  const short = Number(value.toPrecision(4));
  return Math.fround(short) === value ? String(short) : `≈ ${short}`;
}

// The fewest digits that are this single-precision value and no other.
function singleDigits(value) {
  for (let digits = 1; digits < 9; digits++) {
    const short = Number(value.toPrecision(digits));
    if (Math.fround(short) === value) return String(short);
  }
  return String(Number(value.toPrecision(9)));
}
