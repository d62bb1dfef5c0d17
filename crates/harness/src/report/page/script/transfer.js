// Codes of 8 bits back into linear values, as far as they can be: a code stands for a range.

// Source: IEC 61966-2-1:1999, section 5.2, solved for the linear value.
function linearOfSrgb(f) {
  return f <= 0.04045 ? f / 12.92 : ((f + 0.055) / 1.055) ** 2.4;
}

// The inverse of `f(c) = c^(1/2.2)`.
function linearOfGamma22(f) {
  return f ** 2.2;
}

// The linear value in the middle of what a code stands for; null where the
// transfer is not known.
function linearOfCode(code, transfer) {
  if (transfer === "srgb") return linearOfSrgb(code / 255);
  if (transfer === "gamma22") return linearOfGamma22(code / 255);
  return null;
}
