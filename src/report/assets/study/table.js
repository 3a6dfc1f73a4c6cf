// A table that a click on a column's head sorts. The roles are written out because narrow windows show the rows as cards,
// which would end their being a table for those who listen.

// A setting with the mark of its axis, to be clicked.
function settingButton(setting, chosen, hollow = false) {
  if (!setting) return absent;
  const made = button("", () => chosen(setting), { class: "setting", title: setting.text, "data-setting": setting.name });
  made.append(axisMark(setting.axis, hollow), setting.name);
  return made;
}

function tableCell(column, row) {
  const content = column.cell(row);
  const tag = column.head ? "th" : "td";
  return element(tag, { role: column.head ? "rowheader" : "cell", scope: column.head ? "row" : null, "data-title": column.title,
    class: [column.number && "number", column.class, content === absent && "none"].filter((name) => name).join(" ") || null },
  ...(Array.isArray(content) ? content : [content]));
}

// columns: [{key, title, note, cell(row), value(row) to sort by, number, head, class, downwards: first click shows the
// largest, live: refresh() makes its cells anew}]. `made(rowElement, row)` is called once a row. rows(): those to be shown
// now; `table.show()` after a change of these.
function sortedTable({ caption, columns, rows, sort, made, nothing }) {
  const order = { key: sort, descending: false };
  const built = new Map();
  const rowOf = (row) => {
    if (!built.has(row)) {
      const one = element("tr", { role: "row" }, ...columns.map((column) => tableCell(column, row)));
      made(one, row);
      built.set(row, one);
    }
    return built.get(row);
  };
  const sortBy = (column) => {
    order.descending = order.key === column.key ? !order.descending : Boolean(column.downwards);
    order.key = column.key;
    table.show();
    table.querySelector(`[data-sort="${column.key}"]`).focus();
  };
  const headOf = (column) => {
    const active = order.key === column.key ? (order.descending ? "descending" : "ascending") : null;
    return element("th", { scope: "col", role: "columnheader", class: column.number ? "number" : null, title: column.note, "aria-sort": active },
      column.value ? button(column.title, () => sortBy(column), { "data-sort": column.key }) : column.title);
  };
  const head = element("tr", { role: "row" }), body = element("tbody", { role: "rowgroup" });
  const table = element("table", { class: "list", role: "table" }, element("caption", { class: "hidden" }, `${caption}. The buttons in the column heads sort.`),
    element("thead", { role: "rowgroup" }, head), body);
  table.ordered = () => {
    const { value } = columns.find((column) => column.key === order.key) || columns.find((column) => column.value);
    return [...rows()].sort((a, b) => compareValues(value(a), value(b), order.descending) || a.index - b.index);
  };
  table.show = () => {
    head.replaceChildren(...columns.map(headOf));
    const now = table.ordered();
    body.replaceChildren(...now.map(rowOf));
    if (!now.length) body.append(element("tr", { role: "row" }, element("td", { class: "nothing", colspan: columns.length }, nothing || "Nothing matches.")));
  };
  table.refresh = () => {
    for (const [row, one] of built)
      columns.forEach((column, at) => column.live && one.cells[at].replaceWith(tableCell(column, row)));
    if (columns.find((column) => column.key === order.key)?.live) table.show();
  };
  table.rowOf = rowOf;
  table.show();
  return table;
}
