// The filters of the overview: verdicts, area, text, and the order.

const DISTANCE_WORDS =
  "Distance: the visible error of the whole picture (mean FLIP), then how many pixels differ, then by how much.";

// `change(part)` is told what is asked for; `update(filters)` shows what is.
function filterControls(filters, change) {
  const chips = report.verdicts
    .filter(({ id }) => report.summary[id] > 0)
    .map((verdict) => verdictChip(verdict, change));
  const text = textField(filters.text, change);
  const area = areaField(change);
  const sort = orderField(change);
  const field = (words, input) =>
    element("span", { class: "field" }, element("label", { for: input.id }, words), input);
  const root = element(
    "section",
    { class: "filters", "aria-label": "Filters" },
    element(
      "div",
      { class: "chips", role: "group", "aria-label": "Verdicts" },
      chips.map((chip) => chip.root),
    ),
    element(
      "div",
      { class: "fields" },
      field("Find", text),
      field("Area", area),
      field("Order", sort),
    ),
  );
  const update = (now) => {
    for (const chip of chips) chip.update(now);
    area.value = areaValue(now.area);
    sort.value = now.sort;
    if (text.value !== now.text) text.value = now.text;
  };
  return { root, update };
}

function verdictChip({ id, words }, change) {
  const toggle = () => {
    const { verdicts } = overview.filters;
    const others = verdicts.filter((other) => other !== id);
    change({ verdicts: others.length < verdicts.length ? others : [...verdicts, id] });
  };
  const label = [element("b", {}, count(report.summary[id])), ` ${words}`];
  const root = button(label, toggle, { class: "chip", "data-verdict": id });
  const update = ({ verdicts }) => root.setAttribute("aria-pressed", String(verdicts.includes(id)));
  return { root, update };
}

function textField(value, change) {
  const input = element("input", { type: "search", id: "filter-text", placeholder: "name", value });
  input.addEventListener("input", () => change({ text: input.value }));
  return input;
}

// The value of an area's option: every area has none, and the area of names
// without a slash is empty.
function areaValue(area) {
  return area === null ? "" : `/${area}`;
}

function areaField(change) {
  const options = areasOf(fixtures).map(([area, size]) =>
    element("option", { value: areaValue(area) }, `${area || "(top)"} (${count(size)})`),
  );
  const every = element("option", { value: areaValue(null) }, "every area");
  const select = element("select", { id: "filter-area" }, every, options);
  select.addEventListener("change", () =>
    change({ area: select.value === "" ? null : select.value.slice(1) }),
  );
  return select;
}

function orderField(change) {
  const options = Object.entries(SORTS).map(([id, { words }]) =>
    element("option", { value: id }, words),
  );
  const select = element("select", { id: "sort", title: DISTANCE_WORDS }, options);
  select.addEventListener("change", () => change({ sort: select.value }));
  return select;
}
