// The list's tools, the charts above it, and the start.

const place = document.getElementById("results");
const body = element("div", { id: "list" });
const status = element("p", { class: "muted", role: "status", id: "count" });
let form = severalRenderers ? "matrix" : "list";

function show() {
  const shown = shownResults();
  status.textContent = shown.length === results.length ? "" : `${shown.length} of ${count(results.length, "result")}`;
  if (shown.length) body.replaceChildren(form === "matrix" ? matrixView(shown) : listView(shown));
  else body.replaceChildren(element("p", { class: "nothing" }, results.length ? "No result matches." : "There are no results."));
}

function sortBy(key, fromList = false) {
  const again = !fromList && wanted.sort === key;
  wanted.descending = again ? !wanted.descending : largestFirst.has(key);
  wanted.sort = key;
  show();
  sortField.querySelector("select").value = key;
  document.querySelector(`#list [data-sort="${key}"]`)?.focus();
}

function want(name) {
  return (value) => {
    wanted[name] = value;
    show();
  };
}

const sorts = [["verdict", "Failures first"], ["name", "Name"], ["error", "Error"], ["time", "Time"],
  ["pixels", "Pixels off"], ["flip", "FLIP"], ["largest", "Largest difference"],
  ...(severalRenderers ? [["renderer", "Renderer"]] : [])];
const sortField = selection("Sort", sorts, wanted.sort, (key) => sortBy(key, true));

function toolbar() {
  const text = element("input", { type: "search", id: "filter-text", "aria-keyshortcuts": "/", autocomplete: "off",
    placeholder: "name, diagnosis \u2026", oninput: (event) => want("text")(event.target.value) });
  text.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    text.value = "";
    want("text")("");
    text.blur();
  });
  const named = [["all", "All"], ...renderers.map((renderer) => [renderer, renderer])];
  const forms = [["matrix", "Overview"], ["list", "List"]];
  const setForm = (value) => {
    form = value;
    show();
  };
  return element("div", { class: "toolbar" },
    element("label", { class: "field" }, element("span", {}, "Filter"), text),
    severalRenderers ? selection("Renderer", named, "all", want("renderer")) : null,
    sortField,
    severalRenderers ? choice("Form", forms, form, setForm) : null);
}

function buildCharts() {
  const section = document.getElementById("charts");
  if (results.length < 2) return section.remove();
  const made = [histogramFigure(), scatterFigure()].filter((chart) => chart);
  if (made.length) section.append(...made);
  else section.remove();
}

buildHeader();
buildCharts();
place.append(element("h2", { class: "hidden" }, "Results"), verdictChips(want("verdict")), toolbar(), status, body);
show();
addEventListener("hashchange", followAddress);
followAddress();
