// What the dialog shows of one scene.

// An error below the converged picture's own is not known better than that.
function sceneMarks(scene) {
  const results = [...scene.results.values()];
  const errors = results.map(({ error }) => error.rms).filter((rms) => rms > 0);
  const own = scene.converged.error;
  const value = own > 0 ? own : errors.length ? Math.min(...errors) / 2 : 0.01;
  const marks = results.filter(({ ms }) => ms.median > 0).map((result) => {
    const { ms, error } = result, low = !(error.rms > value);
    return {
      x: ms.median, y: low ? value : error.rms, xBar: [ms.low, ms.high], low, front: result.front, setting: result.setting, result,
      yBar: low || !(error.uncertainty > 0) ? null : [Math.max(error.rms - error.uncertainty, value / 10), error.rms + error.uncertainty],
    };
  });
  return { marks, floor: { value, text: own > 0 ? "error of the converged picture" : "no error" } };
}

const sceneTip = ({ result }) => `${result.setting.name}: ${timeText(result.ms.median)}, ${errorText(result.error)} levels` +
  (result.error.against === "converged" ? "" : ` against ${result.error.against}`);

function sceneHead(scene) {
  const order = sceneTable.ordered(), at = order.indexOf(scene);
  return element("header", {},
    element("h2", { id: "detail-name", tabindex: "-1" }, scene.scene),
    element("div", { class: "tools" },
      element("span", { class: "muted" }, at < 0 ? count(order.length, "scene") : `${at + 1} of ${count(order.length, "scene")}`),
      button("Previous", () => stepThrough(scenesInOrder(), -1), { "aria-keyshortcuts": "p", title: "Previous scene (p)" }),
      button("Next", () => stepThrough(scenesInOrder(), 1), { "aria-keyshortcuts": "n", title: "Next scene (n)" }),
      button("Close", closeDetail, { "aria-keyshortcuts": "Escape" })));
}

function convergedTerms({ converged, width, height, depth }) {
  return [
    ["Picture", `${width} ${times} ${height} pixels, depth ${depth}`],
    ["Converged", `${converged.text}: ${count(converged.samples, "sample")} a pixel, ${duration(converged.seconds)}`],
    ["Its own error", levelsText(converged.error)],
  ];
}

// The one recommended, if there is a picture of it; else the first of which there is one.
function firstShown(scene) {
  const results = [...scene.results.values()];
  const chosen = scene.results.get(scene.chosen);
  return ((chosen && chosen.pictured && chosen) || results.find((result) => result.pictured) || chosen || results[0])?.setting || null;
}

function fillDetail(scene) {
  let selected = firstShown(scene);
  const { marks, floor } = sceneMarks(scene);
  const keys = legend(marks);
  const plot = plotFigure({
    title: "Time against error", marks, floor, height: 360, selected: () => selected,
    text: "bars: confidence of the median, uncertainty of the error; filled and joined: the front; a click shows a setting's pictures",
    spokenName: `Time against error of ${count(marks.length, "setting")}; the table below has the same figures.`,
    x: { name: "Time", text: timeText }, y: { name: "RMSE, levels", text: significant },
    tip: sceneTip, open: ({ setting }) => choose(setting), below: keys,
  });
  const pictures = element("div", { class: "main" });
  const choose = (setting) => {
    selected = setting;
    pictures.replaceChildren(picturesOf(scene, setting));
    table.mark(setting);
    plot.redraw();
  };
  const table = resultsTable(scene, choose);
  const answers = answersTable(scene, choose);
  leaving.push(plot.stop, keys.stop, answers.stop);
  detail.replaceChildren(sceneHead(scene), element("div", { class: "body" },
    element("div", { class: "main" }, plot, element("div", { class: "wide" }, answers), termList(convergedTerms(scene))), pictures,
    element("section", { class: "all wide", "aria-label": "Settings of this scene" }, table)));
  if (selected) choose(selected);
  detail.scrollTop = 0;
}
