// With several renderers: a row a scene, a column a renderer.

function matrixCell(result) {
  if (!result) return element("td", { class: "empty" }, absent);
  const text = result.error === null ? result.word : figure(result.error);
  const spoken = `${result.scene}, ${result.renderer}: ${result.word}, RMSE ${figure(result.error)}, ${duration(result.seconds)}`;
  return element("td", { class: result.failed ? "failed" : "passed" },
    element("a", { href: addressOf(result), title: explain(result) || result.word, "aria-label": spoken },
      icon(result.failed ? "fail" : "pass"),
      element("span", { class: "value" }, text),
      element("span", { class: "time" }, duration(result.seconds))));
}

function rendererHead(renderer) {
  const own = results.filter((result) => result.renderer === renderer);
  const failures = own.filter((result) => result.failed).length;
  const seconds = own.reduce((sum, result) => sum + (result.seconds || 0), 0);
  return element("th", { scope: "col" },
    element("span", { class: "renderer", title: renderer }, renderer),
    element("span", { class: "time" }, `${failures ? count(failures, "failure") : "all pass"} \u00b7 ${duration(seconds)}`));
}

// The solution, or what one of them made of it.
function sceneThumbnail(cells) {
  for (const role of ["solution", "picture"])
    for (const result of cells.values()) if (result.places[role]) return thumbnail(result.places[role], "");
  return null;
}

function matrixView(shown) {
  const inView = renderers.filter((renderer) => wanted.renderer === "all" || renderer === wanted.renderer);
  const byScene = new Map();  // in the order of the best placed result of each
  for (const result of shown) if (!byScene.has(result.scene)) byScene.set(result.scene, new Map());
  for (const result of results) byScene.get(result.scene)?.set(result.renderer, result);
  const row = ([scene, cells]) => element("tr", { "data-scene": scene },
    element("th", { scope: "row" }, sceneThumbnail(cells), pathText(scene)), ...inView.map((renderer) => matrixCell(cells.get(renderer))));
  return element("div", { class: "wide" },
    element("table", { class: "matrix" },
      element("caption", { class: "hidden" }, "Scenes by renderers: the RMSE, or what went wrong, and the time."),
      element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "Scene"), ...inView.map(rendererHead))),
      element("tbody", {}, ...[...byScene].map(row))));
}
