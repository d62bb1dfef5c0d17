// Keys: what each does, and the list of them.

// Key, words, what it does; on which page. A key that does nothing there is
// left to the browser.
const KEYS = [
  {
    keys: ["j", "ArrowRight"],
    shown: "j →",
    words: "next fixture",
    page: "fixture",
    act: () => goBy(1),
  },
  {
    keys: ["k", "ArrowLeft"],
    shown: "k ←",
    words: "previous fixture",
    page: "fixture",
    act: () => goBy(-1),
  },
  {
    keys: ["Escape"],
    shown: "Esc",
    words: "back to all fixtures",
    page: "fixture",
    act: () => (location.hash = overviewHash(overview.filters)),
  },
  {
    keys: VIEWS.map((view) => view.key),
    shown: "1 … 8 g p",
    words: "a view: the first eight, the golden, the picture",
    page: "fixture",
    act: (key) => current.viewer?.choose(VIEWS.find((view) => view.key === key).id),
  },
  {
    keys: [" "],
    shown: "space",
    words: "golden or actual, while they blink",
    page: "fixture",
    act: () => current.viewer?.shown?.space?.(),
  },
  {
    keys: ["+", "="],
    shown: "+",
    words: "larger",
    page: "fixture",
    act: () => current.viewer?.step(true),
  },
  {
    keys: ["-"],
    shown: "−",
    words: "smaller",
    page: "fixture",
    act: () => current.viewer?.step(false),
  },
  {
    keys: ["0"],
    shown: "0",
    words: "the whole picture",
    page: "fixture",
    act: () => current.viewer?.viewport.fit(),
  },
  {
    keys: [],
    shown: "← ↑ ↓ →",
    words: "with a picture in focus: move the pixel cursor, ten pixels with shift",
    page: "fixture",
  },
  { keys: ["j"], shown: "j", words: "next card", page: "overview", act: () => focusCard(1) },
  { keys: ["k"], shown: "k", words: "previous card", page: "overview", act: () => focusCard(-1) },
  {
    keys: ["/"],
    shown: "/",
    words: "find by name",
    page: "overview",
    act: () => byId("filter-text").focus(),
  },
  {
    keys: ["x"],
    shown: "x",
    words: "select the card in focus",
    page: "overview",
    act: () => selectFocused(),
    isReview: true,
  },
  { keys: ["a"], shown: "a", words: "accept", act: () => decideHere("accept"), isReview: true },
  { keys: ["r"], shown: "r", words: "reject", act: () => decideHere("reject"), isReview: true },
  { keys: ["u"], shown: "u", words: "undo", act: () => decideHere("undo"), isReview: true },
  { keys: ["?"], shown: "?", words: "this list", act: () => byId("keys").showModal() },
];

// On the overview, of what is selected, or else of the card in focus.
function decideHere(action) {
  if (current.fixture) return current.decide(action);
  const names = current.batch?.names() ?? [];
  const focused = document.activeElement.closest?.(".card")?.dataset.name;
  return decide(action, names.length === 0 && focused ? [focused] : names);
}

function focusCard(by) {
  const all = overview.shown;
  const name = document.activeElement.closest?.(".card")?.dataset.name;
  const at = all.findIndex((fixture) => fixture.name === name);
  const next = all[at < 0 ? 0 : at + by];
  if (next) cardOf(next).link.focus();
}

function selectFocused() {
  const name = document.activeElement.closest?.(".card")?.dataset.name;
  cards.get(fixtureByName.get(name)?.index)?.box?.click();
}

// Where a key writes or has a meaning of its own.
function isTaken(event) {
  const { target, key } = event;
  if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return true;
  if (document.querySelector("dialog[open]")) return true;
  if (target.matches("select, textarea, input:not([type=checkbox], [type=range])"))
    return key !== "Escape";
  if (target.matches("input[type=range]")) return key.startsWith("Arrow");
  if (key.startsWith("Arrow")) return target.matches("ol, canvas, code");
  // A view's button is where the focus is after it was clicked; space then blinks.
  return key === " " && target.matches("button:not([data-view]), summary, input, a");
}

function startKeys() {
  document.addEventListener("keydown", (event) => {
    if (isTaken(event)) return;
    const page = current.fixture ? "fixture" : "overview";
    const isMeant = (entry) =>
      entry.keys.includes(event.key) &&
      (!entry.page || entry.page === page) &&
      (!entry.isReview || isReviewing);
    const found = KEYS.find(isMeant);
    if (!found || (event.key === " " && !current.viewer?.shown?.space)) return;
    event.preventDefault();
    found.act(event.key);
  });
  byId("show-keys").addEventListener("click", () => byId("keys").showModal());
  byId("keys").replaceChildren(...keyList());
}

function keyList() {
  const group = (title, page) => {
    const entries = KEYS.filter((entry) => entry.page === page && (!entry.isReview || isReviewing));
    const rows = entries.map(({ shown, words }) => [
      element("dt", {}, element("kbd", {}, shown)),
      element("dd", {}, words),
    ]);
    return [element("h3", {}, title), element("dl", {}, rows)];
  };
  const close = button("Close", () => byId("keys").close());
  return [
    element("h2", { id: "keys-title" }, "Keys"),
    ...group("A fixture", "fixture"),
    ...group("All fixtures", "overview"),
    ...group("Everywhere", undefined),
    close,
  ];
}
