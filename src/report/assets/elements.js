// Making elements. Text from the report only ever becomes text nodes and attribute values.

// element("a", {href: "#x", class: "link", onclick: f}, "text", child, null)
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

// A path that may break after each of its parts. It stays one word for those who copy it.
function pathText(path) {
  const text = element("span", { class: "path" });
  for (const part of path.split(/(?<=[/_])/)) text.append(part, element("wbr"));
  return text;
}

const icons = {
  pass: "M3 8.5 6.5 12 13 4.5",
  fail: "M4 4 12 12M12 4 4 12",
  stop: "M8 3V9M8 12V13",
  none: "M4 8H12",
};

// Decoration beside a word, never instead of one.
function icon(name) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", icons[name]);
  svg.append(path);
  return svg;
}

function button(text, action, attributes = {}) {
  return element("button", { type: "button", onclick: action, ...attributes }, text);
}

// A row of buttons of which one is pressed. `choices` is [[value, text], ...]; chosen(value) on a click.
function choice(label, choices, value, chosen) {
  const group = element("div", { class: "choice", role: "group", "aria-label": label });
  const show = (now) => {
    for (const each of group.children) each.setAttribute("aria-pressed", each.dataset.value === now);
  };
  for (const [name, text] of choices) {
    const press = () => {
      show(name);
      chosen(name);
    };
    group.append(button(text, press, { "data-value": name }));
  }
  show(value);
  group.show = show;
  return group;
}

// A labelled <select>; chosen(value) on a change.
function selection(label, choices, value, chosen) {
  const select = element("select", { onchange: (event) => chosen(event.target.value) });
  for (const [name, text] of choices) select.append(element("option", { value: name }, text));
  select.value = value;
  return element("label", { class: "field" }, element("span", {}, label), select);
}

// [[name, text], null, ...] as a list.
const termList = (terms) => element("dl", {},
  ...terms.filter((term) => term).flatMap(([name, text]) => [element("dt", {}, name), element("dd", {}, text)]));
