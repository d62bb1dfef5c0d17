// The page as a whole: goes where the address says, and starts everything else.

// The page that is shown.
let current = null;

function openPage(route) {
  if (route.page === "overview") return makeOverview(route);
  const fixture = fixtureByName.get(route.name);
  return fixture ? makeFixturePage(fixture, route.view) : makeUnknownPage(route.name);
}


function go() {
  const route = parseHash(location.hash);
  const left = current?.fixture ?? null;
  const isFirst = current === null;
  if (current && !current.fixture) overviewPlace.keep(route.name);
  current?.close();
  current = openPage(route);
  byId("main").replaceChildren(...current.root);
  document.title = current.fixture ? `${current.fixture.name} · goldray` : `goldray ${report.kind}`;
  if (current.fixture) window.scrollTo(0, 0);
  else overviewPlace.restore(left);
  // Who goes by keys or ears goes on from the top of what has come.
  if (!isFirst) byId("main").focus({ preventScroll: true });
  if (left && !current.fixture) cards.get(left.index)?.link.focus({ preventScroll: true });
}

function showProgress() {
  const { decided, failed } = progressOf();
  byId("progress").textContent =
    failed === 0 ? "" : `${count(decided)} of ${count(failed)} decided`;
}

async function restore() {
  const place = recall();
  if (!place) return;
  await current.ready;
  const { viewer } = current;
  if (viewer && place.cursor) viewer.putCursor(place.cursor);
  if (viewer && place.zoom) viewer.viewport.place(place.zoom.x, place.zoom.y, place.zoom.scale);
  window.scrollTo(0, place.scroll);
}

byId("kind").textContent = report.kind;
startTheme();
applyFilters(NO_FILTERS);
addEventListener("hashchange", go);
go();
startKeys();
if (isReviewing) {
  onDecisions(showProgress);
  showProgress();
}
followServer();
restore();
