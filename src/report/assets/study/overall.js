// The plot over all scenes: time and error relative to the first setting.

function overallMarks() {
  const known = totals.filter(({ time, error }) => time > 0 && typeof error === "number");
  const errors = known.map((total) => total.error).filter((error) => error > 0);
  const least = errors.length ? Math.min(...errors) / 2 : 0.5;
  const none = known.some((total) => !(total.error > 0));
  const marks = known.map((total) => ({
    x: total.time, y: total.error > 0 ? total.error : least, xBar: total.timeInterval, yBar: total.errorInterval,
    low: !(total.error > 0), front: total.front, setting: total.setting, total,
  }));
  return { marks, floor: none ? { value: least, text: "no error" } : null };
}

function overallTip({ total }) {
  return `${total.setting.name}: ${ratioText(total.time)} the time, ${ratioText(total.error)} the error`;
}

function axisTexts() {
  return element("details", { class: "points" }, element("summary", {}, "What the axes are"),
    termList(axes.map((axis) => [axis.title, axis.text])));
}

function overallFigure() {
  const { marks, floor } = overallMarks();
  const base = settingOf.get(baseName);
  const keys = legend(marks);
  return plotFigure({
    title: "All scenes", marks, floor,
    text: `Geometric means over ${count(report.all.scenes, "scene")}, relative to ${base ? base.text : baseName}; bars: 95 % ` +
      "confidence; filled and joined: no other setting is better in both. Drag or wheel zooms, a double click shows all.",
    spokenName: `Time against error of ${count(marks.length, "setting")}; the table below has the same figures.`,
    x: { name: `Time, relative to ${baseName}`, text: ratioText }, y: { name: "Error", text: ratioText },
    tip: overallTip, open: ({ setting }) => showSetting(setting),
    below: element("div", {}, keys, axisTexts()),
  });
}
