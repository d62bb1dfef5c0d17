// Decisions: accept, reject and undo, made by the server and seen in every tab.

const isReviewing = report.kind === "review" || report.kind === "watch";

// Which page this is, of all that its server has shown.
const edition = document.currentScript.dataset.edition;

// What the server has said last.
const review = { decisions: {}, canAccept: new Set(), canUndo: new Set(), listeners: new Set() };

// How long a stream may be away before it is said to be lost: a reload of the
// server's page breaks it for a moment.
const LOST_AFTER_MS = 1500;

// Calls whenever a decision is made, until the returned function is called.
function onDecisions(listener) {
  review.listeners.add(listener);
  return () => review.listeners.delete(listener);
}

function takeState(state) {
  review.decisions = state.decisions;
  review.canAccept = new Set(state.can_accept);
  review.canUndo = new Set(state.can_undo);
  for (const listener of review.listeners) listener();
}

// Asks the server; what it answers, or null where it does not, or refuses.
async function ask(path, body) {
  const options = body
    ? {
        method: "POST",
        headers: { "Content-Type": "application/json" },
        body: JSON.stringify({ ...body, edition }),
      }
    : {};
  try {
    const answer = await fetch(path, options);
    const state = await answer.json();
    // Another picture than the one that is seen here would be decided about.
    if (answer.status === 409) reloadPage();
    if (state.decisions) takeState(state);
    else tell({ said: "", why: [state.error ?? `the server answers ${answer.status}`] });
    return state.decisions ? state : null;
  } catch {
    setLost(true);
    return null;
  }
}

// `action` is accept, reject or undo. The server is asked for all, also for what
// cannot be decided so, and says why not; only what is not decided has nothing to
// undo, and is left out of a selection.
async function decide(action, names) {
  if (names.length === 0) return;
  const decided = names.filter((name) => canDecide(action, name));
  const asked = action === "undo" && decided.length > 0 ? decided : names;
  if (action === "accept" && !(await isConfirmed(decided, asked.length))) return;
  const before = review.decisions;
  const state = await ask(`api/${action}`, { names: asked });
  if (state) tell(decisionWords(action, asked, before, state));
}

function canDecide(action, name) {
  const decision = review.decisions[name];
  if (action === "undo") return review.canUndo.has(name);
  if (action === "accept") return decision !== "accepted" && review.canAccept.has(name);
  // The server takes back what was accepted.
  return decision === "accepted" || (decision === undefined && hasFailed(fixtureByName.get(name)));
}

// How many of what has failed is decided.
function progressOf() {
  const failed = fixtures.filter(hasFailed);
  return {
    decided: failed.filter(({ name }) => review.decisions[name]).length,
    failed: failed.length,
  };
}

// The buttons for some names, which follow what can be done.
function decisionButtons(namesOf) {
  const made = ["accept", "reject", "undo"].map((action) => {
    const key = element("kbd", { "aria-hidden": "true" }, action[0]);
    const label = [action[0].toUpperCase() + action.slice(1), " ", key];
    return button(label, () => decide(action, namesOf()), {
      class: `act ${action}`,
      "data-action": action,
    });
  });
  const root = element(
    "div",
    { class: "decisions", role: "group", "aria-label": "Decide", tabindex: "-1" },
    made,
  );
  const update = () => {
    const focused = document.activeElement;
    for (const one of made)
      one.disabled = !namesOf().some((name) => canDecide(one.dataset.action, name));
    // The focus of a button that can do no more would be lost; on another one the
    // same key would take back what it did.
    if (made.includes(focused) && focused.disabled) root.focus();
  };
  update();
  return { root, update };
}

function setLost(isLost) {
  byId("lost").hidden = !isLost;
}

// Follows the server: decisions of other tabs, and a page made anew.
function followServer() {
  if (!isReviewing) return;
  ask("api/state");
  const stream = new EventSource(`events?edition=${edition}`);
  let timer = null;
  stream.addEventListener("open", () => {
    clearTimeout(timer);
    timer = null;
    setLost(false);
  });
  stream.addEventListener("error", () => {
    // Each attempt to come back fails anew, more often than that.
    timer ??= setTimeout(() => setLost(true), LOST_AFTER_MS);
  });
  stream.addEventListener("state", (event) => takeState(JSON.parse(event.data)));
  stream.addEventListener("trouble", (event) =>
    tell({ said: "", why: [`Nothing can be decided until this is mended: ${JSON.parse(event.data)}`] }),
  );
  stream.addEventListener("reload", reloadPage);
}

function reloadPage() {
  remember();
  location.reload();
}
