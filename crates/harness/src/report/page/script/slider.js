// A labelled slider with its value in words.

function makeSlider(label, low, high, value, words, changed) {
  const output = element("output", {}, words(value));
  const input = element("input", {
    type: "range",
    min: low,
    max: high,
    step: "1",
    value,
    "aria-label": label,
  });
  input.addEventListener("input", () => {
    changed(input.valueAsNumber);
    output.textContent = words(input.valueAsNumber);
    input.setAttribute("aria-valuetext", output.textContent);
  });
  input.setAttribute("aria-valuetext", output.textContent);
  return element("div", { class: "controls" }, element("span", {}, label), input, output);
}
