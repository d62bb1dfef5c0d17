// A card of the contact sheet: picture, name, verdict, one number.

// Pictures come a screen before they are seen.
const COMING_INTO_VIEW = "400px";

const pictureObserver = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      pictureObserver.unobserve(entry.target);
      showPicture(entry.target, fixtures[Number(entry.target.dataset.index)]);
    }
  },
  { rootMargin: COMING_INTO_VIEW },
);

// Today's picture, or else the golden, which may be no picture at all.
function showPicture(frame, fixture) {
  const evidence = evidenceOf(fixture);
  const base64 = evidence.actual ?? evidence.golden;
  const picture = base64
    ? element("img", {
        alt: "",
        src: `data:image/png;base64,${base64}`,
        load: sharpen,
        error: () => frame.replaceChildren("no picture"),
        decoding: "async",
      })
    : "no picture";
  frame.replaceChildren(picture);
}

// Smooth only where a picture is made smaller.
function sharpen({ target }) {
  target.classList.toggle("is-small", target.naturalWidth <= target.clientWidth);
}

const cards = new Map();

// The one card of a fixture, made when it is first asked for.
function cardOf(fixture) {
  if (!cards.has(fixture.index)) cards.set(fixture.index, makeCard(fixture));
  return cards.get(fixture.index);
}

function makeCard(fixture) {
  const frame = element("span", { class: "frame", "data-index": fixture.index });
  pictureObserver.observe(frame);
  const number = element("span", { class: "number" });
  const decision = element("span", { class: "decision" });
  const area = fixture.area ? element("span", { class: "area" }, `${fixture.area}/`) : null;
  const link = element(
    "a",
    { href: fixtureHash(fixture.name) },
    frame,
    element("span", { class: "name", title: fixture.name }, area, element("wbr"), fixture.leaf),
    element("span", { class: "line" }, verdictBadge(fixture), number),
  );
  const box = isReviewing && hasFailed(fixture) ? selectBox(fixture) : null;
  const root = element(
    "li",
    { class: "card", "data-name": fixture.name, "data-verdict": fixture.verdict },
    link,
    decision,
    box?.label,
  );
  return { root, link, number, decision, box: box?.input, fixture };
}

function selectBox(fixture) {
  const input = element("input", {
    type: "checkbox",
    "aria-label": `Select ${fixture.name}`,
    change: () => document.dispatchEvent(new Event("selected")),
  });
  return { input, label: element("label", { class: "select" }, input) };
}

function verdictBadge(fixture) {
  return element(
    "span",
    { class: "badge", "data-verdict": fixture.verdict },
    verdictWords(fixture),
  );
}

// Shows a decision in words, as colors alone do not tell everybody.
function markDecision(target, name) {
  const decision = review.decisions[name] ?? "";
  target.textContent = decision;
  target.dataset.decision = decision;
}

// The names of the cards that are selected, of those shown.
function selectedNames(shown) {
  return shown.filter(({ index }) => cards.get(index)?.box?.checked).map(({ name }) => name);
}
