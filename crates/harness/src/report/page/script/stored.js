// What a page keeps over a reload of it, for as long as its tab is open.

// A browser may refuse to store; the page does without.
function stored(key, value) {
  try {
    if (value === undefined) return sessionStorage.getItem(key);
    sessionStorage.setItem(key, value);
  } catch {
    return null;
  }
  return value;
}
