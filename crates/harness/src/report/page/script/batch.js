// The bar of a review's overview: how many cards are selected, and what may be done with them.

function batchBar() {
  const words = element("span", { class: "words" });
  const names = () => selectedNames(overview.shown);
  const decisions = decisionButtons(names);
  const setAll = (isOn) => {
    for (const { index } of overview.shown) {
      const box = cards.get(index)?.box;
      if (box) box.checked = isOn;
    }
    update();
  };
  const update = () => {
    words.textContent = `${count(names().length)} selected`;
    decisions.update();
  };
  const root = element(
    "section",
    { class: "batch", "aria-label": "Selection" },
    words,
    button("Select all shown", () => setAll(true)),
    button("Select none", () => setAll(false)),
    decisions.root,
  );
  return { root, update, names };
}
