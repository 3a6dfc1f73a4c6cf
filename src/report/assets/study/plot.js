// A plot of time against error, both logarithmic.

// Marks of a logarithmic axis, about `most` of them: powers of ten; nearer 1, 2, 5; nearer still equal steps.
function logMarks(low, high, most) {
  const span = Math.log10(high / low);
  if (span > 0.8 && span * 3 > most) return decadeSplits(low, high);
  const marks = [];
  if (span > 0.8) {
    for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
      for (const digit of [1, 2, 5]) marks.push(+`${digit}e${power}`);
  } else {
    const rough = (high - low) / Math.min(5, most), power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find((digit) => digit * power >= rough);
    for (let mark = Math.ceil(low / step); mark * step <= high; ++mark) marks.push(+(mark * step).toPrecision(6));
  }
  return marks.filter((mark) => mark >= low && mark <= high);
}

function drawPlot(place, width, view, options) {
  const { shown, marks, x, y, floor, height, selected, changed } = options;
  const axis = ({ name, text }, length, room, size) => chartAxis({ label: name, size, space: 10,
    splits: (_, __, low, high) => logMarks(low, high, Math.max(2, length / room)), values: (_, splits) => splits.map((value) => text(value)) });
  const plot = new uPlot({
    width, height, legend: { show: false },
    cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: true, setScale: false, dist: 6 },
      bind: { dblclick: () => null } },
    scales: { x: { time: false, distr: 3, range: () => view.x }, y: { distr: 3, range: () => view.y } },
    axes: [
      axis(x, width - 80, 56, 32),
      axis(y, height - 60, 28, 58),
    ],
    series: [{}, { paths: () => null, points: { show: false } }],
    hooks: {
      draw: [(drawn) => drawAll(drawn, shown(), floor, selected ? selected() : null)],
      setSelect: [(drawn) => {
        const zoomed = zoomToSelection(drawn, view);
        drawn.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
        if (zoomed) changed();
      }],
    },
  }, [[...view.whole.x], [...view.whole.y]], place);
  plot.over.dataset.marks = marks.length;
  return plot;
}

// A figure with its plot. `marks`: all; x, y: {name, text(value)}; tip(mark), open(mark): pointed at, clicked; `floor`:
// {value, text} or null; selected(): the setting with a ring. `figure.redraw()` after a change, `figure.stop()` at the end.
function plotFigure({ title, text, spokenName, marks, x, y, tip, open, floor = null, height = 420, selected = null, below = "" }) {
  const view = wholeView(marks, floor);
  const shown = () => marks.filter((mark) => !hiddenAxes.has(mark.setting.axis));
  const place = element("div", { class: "plot", tabindex: "0", role: "group",
    "aria-label": `${spokenName} The arrow keys go from point to point, Enter opens, plus and minus zoom, 0 shows all.` });
  const whole = button("Show all", () => {
    resetView(view);
    changed();
    place.focus();
  }, { class: "whole", title: "Show all (0, or a double click)", hidden: true });
  const spoken = element("p", { class: "hidden", "aria-live": "polite" });
  let plot = null, showTip = null;
  const changed = () => {
    whole.hidden = isWhole(view);
    place.dataset.view = [...view.x, ...view.y].map((value) => value.toPrecision(4)).join(" ");
    if (!plot) return;
    showTip(null);
    plot.batch(() => {
      plot.setScale("x", { min: view.x[0], max: view.x[1] });
      plot.setScale("y", { min: view.y[0], max: view.y[1] });
    });
    plot.redraw();
  };
  const stopDrawing = keepDrawn(place, (width) => {
    plot = drawPlot(place, width, view, { shown, marks, x, y, floor, height, selected, changed });
    addZoom(plot, view, changed);
    showTip = addPointer(plot, { marks: () => shown().filter((mark) => inView(view, mark)), text: tip, open });
    return plot;
  });
  addSteps(place, {
    marks: shown, open,
    show: (mark) => {
      if (!inView(view, mark)) {
        resetView(view);
        changed();
      }
      showTip(mark);
      spoken.textContent = tip(mark);
    },
    hide: () => showTip && showTip(null),
    zoom: (factor) => {
      if (factor) zoomView(view, factor, middleOf(view));
      else resetView(view);
      changed();
    },
  });
  const redraw = () => plot && plot.redraw();
  axesChanged.add(redraw);
  changed();
  const figure = chartFigure(title, text, element("div", { class: "plot-frame" }, place, whole), below);
  figure.append(spoken);
  figure.redraw = redraw;
  figure.stop = () => {
    stopDrawing();
    axesChanged.delete(redraw);
  };
  return figure;
}
