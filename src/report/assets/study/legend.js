// The axes with their marks; a click hides the points of one, in all plots.

const hiddenAxes = new Set();
const axesChanged = new Set();  // functions to call

// Of those axes of which there are marks. `stop` ends its following the others.
function legend(marks) {
  const present = axes.filter((axis) => marks.some((mark) => mark.setting.axis === axis));
  const group = element("div", { class: "legend", role: "group", "aria-label": "Axes shown" });
  for (const axis of present) {
    const one = button("", () => {
      if (!hiddenAxes.delete(axis)) hiddenAxes.add(axis);
      for (const changed of [...axesChanged]) changed();
    }, { title: axis.text, "data-axis": axis.name });
    one.append(axisMark(axis), axis.title);
    group.append(one);
  }
  const show = () => {
    for (const one of group.children) one.setAttribute("aria-pressed", !hiddenAxes.has(axisOf.get(one.dataset.axis)));
  };
  show();
  axesChanged.add(show);
  group.stop = () => axesChanged.delete(show);
  return group;
}
