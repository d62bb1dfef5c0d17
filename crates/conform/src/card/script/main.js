// The page begins here: what the address asks for is shown.

const TITLE = document.title;

function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

function pageOf(hash) {
  const [, kind, ...rest] = hash.split("/");
  const parts = rest.map(decoded);
  if (kind === "fixture") return fixturePage(parts.join("/"));
  if (kind === "cell") return cellPage(parts[0], parts.slice(1).join("/"));
  return overviewPage();
}

function show(isFirst) {
  const main = byId("main");
  main.replaceChildren(...pageOf(location.hash).flat(Infinity));
  const heading = main.querySelector("h1").textContent;
  document.title = location.hash.length > 2 ? `${heading} · ${TITLE}` : TITLE;
  if (isFirst) return;
  window.scrollTo(0, 0);
  main.focus({ preventScroll: true });
  speak(heading);
}

startTheme();
window.addEventListener("hashchange", () => show(false));
show(true);
