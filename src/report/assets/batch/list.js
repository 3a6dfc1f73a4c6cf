// The table of results: a row each, sorted by a click on a column's head. The roles are written out because narrow
// windows show the rows as cards, which would end their being a table for those who listen.

const columns = [
  { title: "Pictures" },
  { title: "Scene", sort: "name" },
  ...(severalRenderers ? [{ title: "Renderer", sort: "renderer" }] : []),
  { title: "Verdict", sort: "verdict" },
  { title: "RMSE", sort: "error", number: true, note: "Root mean square error, in levels of 255" },
  { title: "> 1 level", sort: "pixels", number: true, note: "Share of pixels that are off by more than one level" },
  { title: "FLIP", sort: "flip", number: true, note: "Perceived difference: 0 equal, 1 most" },
  { title: "Max", sort: "largest", number: true, note: "Largest difference, in levels of 255" },
  { title: "Diagnosis" },
  { title: "Time", sort: "time", number: true },
];

const badge = (result) =>
  element("span", { class: `badge ${result.failed ? "fail" : "pass"}` }, icon(result.failed ? "fail" : "pass"), result.word);

function thumbnails(result) {
  const shown = result.failed ? roles : roles.slice(0, 1);
  return shown.filter(([role]) => result.places[role])
    .map(([role, name]) => thumbnail(result.places[role], `${name} of ${result.scene}`));
}

function resultRow(result) {
  const { measured } = result;
  const cell = (title, attributes, ...content) => element("td", { role: "cell", "data-title": title, ...attributes }, ...content);
  const number = (title, text) => cell(title, { class: text === absent ? "number none" : "number" }, text);
  const row = element("tr", { role: "row", class: result.failed ? "failed" : "passed", "data-scene": result.scene },
    cell("Pictures", { class: "thumbs" }, ...thumbnails(result)),
    element("th", { scope: "row", role: "rowheader" }, element("a", { href: addressOf(result) }, pathText(result.scene))),
    severalRenderers ? cell("Renderer", { class: "renderer" }, result.renderer) : null,
    cell("Verdict", {}, badge(result)),
    number("RMSE", figure(result.error)),
    number("> 1 level", percent(measured && measured.percent_over_one)),
    number("FLIP", figure(measured && measured.flip, 3)),
    number("Max", level(measured && Math.abs(measured.largest.difference))),
    cell("Diagnosis", { class: "diagnosis" }, explain(result)),
    number("Time", duration(result.seconds)));
  row.addEventListener("click", (event) => {
    if (!event.target.closest("a") && !String(getSelection())) location.hash = addressOf(result);
  });
  return row;
}

const rows = new Map();  // made once, then moved
function rowOf(result) {
  if (!rows.has(result)) rows.set(result, resultRow(result));
  return rows.get(result);
}

function columnHead(column) {
  if (!column.sort) return element("th", { scope: "col", role: "columnheader" }, column.title);
  const active = wanted.sort === column.sort;
  const order = wanted.descending ? "descending" : "ascending";
  return element("th",
    { scope: "col", role: "columnheader", class: column.number ? "number" : null, "aria-sort": active ? order : null, title: column.note },
    button(column.title, () => sortBy(column.sort), { "data-sort": column.sort }));
}

function listView(shown) {
  return element("table", { class: "list", role: "table" },
    element("caption", { class: "hidden" }, "Results. The buttons in the column heads sort."),
    element("thead", { role: "rowgroup" }, element("tr", { role: "row" }, ...columns.map(columnHead))),
    element("tbody", { role: "rowgroup" }, ...shown.map(rowOf)));
}
