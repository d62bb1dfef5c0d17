// The part of the address after #: where the reader is, so that a link leads there.

const FIXTURE_PATH = "#/fixture/";

// Every fixture, failures first.
const NO_FILTERS = { verdicts: [], area: null, text: "", sort: "failures" };

// `{page: "fixture", name, view}` or `{page: "overview", verdicts, area, text, sort}`.
function parseHash(hash) {
  const mark = hash.indexOf("?");
  const path = mark < 0 ? hash : hash.slice(0, mark);
  const query = new URLSearchParams(mark < 0 ? "" : hash.slice(mark + 1));
  if (path.startsWith(FIXTURE_PATH)) {
    return {
      page: "fixture",
      name: decodeName(path.slice(FIXTURE_PATH.length)),
      view: query.get("view"),
    };
  }
  return {
    page: "overview",
    verdicts: (query.get("verdict") ?? "").split(",").filter((id) => wordsOfVerdict.has(id)),
    area: query.get("area"),
    text: query.get("text") ?? "",
    sort: Object.hasOwn(SORTS, query.get("sort") ?? "") ? query.get("sort") : NO_FILTERS.sort,
  };
}

// A name that is no good escape is taken as it stands: it may be one that a
// person typed.
function decodeName(path) {
  try {
    return decodeURIComponent(path);
  } catch {
    return path;
  }
}

function overviewHash({ verdicts, area, text, sort }) {
  const query = new URLSearchParams();
  if (verdicts.length > 0) query.set("verdict", verdicts.join(","));
  if (area !== null) query.set("area", area);
  if (text !== "") query.set("text", text);
  if (sort !== NO_FILTERS.sort) query.set("sort", sort);
  return query.size === 0 ? "#/" : `#/?${query}`;
}

function fixtureHash(name, view = null) {
  const path = name.split("/").map(encodeURIComponent).join("/");
  return `${FIXTURE_PATH}${path}${view ? `?${new URLSearchParams({ view })}` : ""}`;
}

// Says where the reader is without another step to go back over.
function rewriteHash(hash) {
  history.replaceState(null, "", hash);
}
