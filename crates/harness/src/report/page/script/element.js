// Elements of the page. What comes from a suite is only ever put in as text.

// An element with attributes and children. A function is a listener, true and
// false are an attribute with and without, null children are left out.
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) setAttribute(made, name, value);
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return made;
}

function setAttribute(target, name, value) {
  if (typeof value === "function") target.addEventListener(name, value);
  else if (typeof value === "boolean") target.toggleAttribute(name, value);
  else if (value !== null && value !== undefined) target.setAttribute(name, value);
}

// A button that does one thing.
function button(label, act, attributes = {}) {
  return element("button", { type: "button", click: act, ...attributes }, label);
}

// Text that is heard and not seen.
function unseen(text) {
  return element("span", { class: "unseen" }, text);
}

function byId(id) {
  return document.getElementById(id);
}

// Says something to those who do not see it.
function speak(text) {
  byId("spoken").textContent = text;
}
