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
  if (state.messages.length > 0) showMessages(state.messages);
  for (const listener of review.listeners) listener();
}

// Asks the server; whether it has answered.
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
    if (Array.isArray(state.messages)) showMessages([]);
    if (state.decisions) takeState(state);
    else showMessages([state.error ?? `the server answers ${answer.status}`]);
    return true;
  } catch {
    setLost(true);
    return false;
  }
}

// `action` is accept, reject or undo. What cannot be decided so is left out of
// a selection; alone it is asked for, and the server says why not.
async function decide(action, names) {
  if (names.length === 0) return;
  const able = names.filter((name) => canDecide(action, name));
  const asked = able.length > 0 ? able : names;
  if (await ask(`api/${action}`, { names: asked }))
    speak(`${action}: ${plural(asked.length, "fixture", "fixtures")}`);
}

function canDecide(action, name) {
  const decision = review.decisions[name];
  if (action === "undo") return review.canUndo.has(name);
  if (action === "accept") return decision !== "accepted" && review.canAccept.has(name);
  return decision === undefined && hasFailed(fixtureByName.get(name));
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
  const update = () => {
    for (const one of made)
      one.disabled = !namesOf().some((name) => canDecide(one.dataset.action, name));
  };
  update();
  return {
    root: element("div", { class: "decisions", role: "group", "aria-label": "Decide" }, made),
    update,
  };
}

function showMessages(messages) {
  const close = button("×", () => showMessages([]), {
    class: "quiet",
    "aria-label": "Close messages",
  });
  const list = element(
    "ul",
    {},
    messages.map((message) => element("li", {}, message)),
  );
  byId("messages").replaceChildren(...(messages.length > 0 ? [list, close] : []));
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
    showMessages([`Nothing can be decided until this is mended: ${JSON.parse(event.data)}`]),
  );
  stream.addEventListener("reload", reloadPage);
}

function reloadPage() {
  remember();
  location.reload();
}
