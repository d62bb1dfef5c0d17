// Asks before many goldens are written at once, or one is removed.

// So many names are said; of more, how many there are.
const NAMES_SAID = 6;

function isOrphan(name) {
  return fixtureByName.get(name)?.verdict === "orphan_golden";
}

// `able` is what can be accepted, of so many that are asked for. One picture is
// not asked about: it has just been looked at.
async function isConfirmed(able, asked) {
  const orphans = able.filter(isOrphan);
  if (able.length < 2 && orphans.length === 0) return true;
  return isAnswered(questionWords(able.length - orphans.length, orphans, asked - able.length), {
    yes: able.length === orphans.length ? "Remove" : "Accept",
  });
}

function questionWords(pictures, orphans, others) {
  const removed = `${plural(orphans.length, "golden", "goldens")} without a fixture`;
  const names = orphans.slice(0, NAMES_SAID).join(", ");
  const more = orphans.length > NAMES_SAID ? ` and ${count(orphans.length - NAMES_SAID)} more` : "";
  if (pictures === 0) return [`Remove ${removed}: ${names}${more}?`, null];
  const question = `Accept ${plural(pictures, "picture as golden", "pictures as goldens")}?`;
  const be = orphans.length === 1 ? "is" : "are";
  const notes = [
    orphans.length > 0 ? `${removed} ${be} removed: ${names}${more}.` : null,
    others > 0 ? `${count(others)} of the selection cannot be accepted, or already are.` : null,
  ];
  return [question, notes.filter(Boolean).join(" ")];
}

// Whether the answer is yes. Enter, on the button that has the focus, says so;
// Esc, as of every dialog, does not. The browser gives the focus back.
function isAnswered([question, note], { yes }) {
  const dialog = byId("confirm");
  const answer = (value) => () => dialog.close(value);
  dialog.replaceChildren(
    element("h2", { id: "confirm-title" }, question),
    element("p", { id: "confirm-note" }, note),
    element(
      "div",
      { class: "answers" },
      button(yes, answer("yes"), { class: "yes", autofocus: true }),
      button("Cancel", answer("no")),
    ),
  );
  dialog.returnValue = "";
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => resolve(dialog.returnValue === "yes"), { once: true });
    dialog.showModal();
  });
}
