// What has come of a decision: how many are decided, which are not, and why.

const DONE_WORDS = { accept: "accepted", reject: "rejected", undo: "undone" };

// `{said, why}` of what was asked for: a sentence, and the server's own. What was
// so before is counted on neither side.
function decisionWords(action, names, before, { decisions, messages }) {
  const wanted = { accept: "accepted", reject: "rejected", undo: undefined }[action];
  const not = names.filter((name) => decisions[name] !== wanted).length;
  const isNew = (name) => decisions[name] === wanted && before[name] !== wanted;
  const done = `${count(names.filter(isNew).length)} ${DONE_WORDS[action]}`;
  const words = not > 0 ? `${done}, ${count(not)} not` : done;
  const said = `${words}${not > 0 && messages.length > 0 ? ":" : "."}`;
  return { said, why: messages, isAlone: names.length === 1 };
}

// Says it to those who see and to those who hear. One that is decided is seen
// where it is, and one that is not needs no count.
function tell({ said, why, isAlone }) {
  const hasCount = said !== "" && !(isAlone && why.length > 0);
  const parts = [hasCount ? said : null, ...why].filter(Boolean);
  showMessages(hasCount && !isAlone ? said : "", why);
  speak(parts.join(" "));
}

function showMessages(said, why) {
  const close = button("×", () => showMessages("", []), {
    class: "quiet",
    "aria-label": "Close messages",
  });
  const words = element(
    "div",
    {},
    said ? element("p", {}, said) : null,
    element(
      "ul",
      {},
      why.map((message) =>
        element("li", { class: message.includes("\n") ? "is-report" : null }, message),
      ),
    ),
  );
  byId("messages").replaceChildren(...(said || why.length > 0 ? [words, close] : []));
}
