// Where the reader was, over a reload of the page: place, zoom and cursor.

const MEMORY = "goldray-place";

function remember() {
  const viewport = current?.viewer?.viewport;
  const zoom =
    viewport && !viewport.isFitted ? { x: viewport.x, y: viewport.y, scale: viewport.scale } : null;
  const place = {
    hash: location.hash,
    scroll: window.scrollY,
    zoom,
    cursor: current?.viewer?.cursor ?? null,
  };
  stored(MEMORY, JSON.stringify(place));
}

// Once, and only for the address it was of.
function recall() {
  const text = stored(MEMORY);
  if (!text) return null;
  stored(MEMORY, "");
  const place = JSON.parse(text);
  return place.hash === location.hash ? place : null;
}
