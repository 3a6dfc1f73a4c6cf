// What the charts have in common: colours of the theme, the width of their place, redrawing when either
// changes.

const chartFont = "12px system-ui, sans-serif";

// draw(width) makes a uPlot in `place`; it is made anew when the width or the theme changes. The result is a function
// that ends this.
function keepDrawn(place, draw) {
  let plot = null;
  let width = 0;
  const again = () => {
    if (plot) plot.destroy();
    plot = width > 0 ? draw(width) : null;
  };
  const observer = new ResizeObserver(() => {
    const now = Math.floor(place.clientWidth);
    if (now === width) return;
    width = now;
    again();
  });
  observer.observe(place);
  themeChanged.add(again);
  return () => {
    observer.disconnect();
    themeChanged.delete(again);
    if (plot) plot.destroy();
    plot = null;
  };
}

function chartAxis(options) {
  const lines = { stroke: colour("line"), width: 1 };
  return { stroke: colour("muted"), font: chartFont, labelFont: chartFont, grid: lines, ticks: lines,
    labelSize: 18, filter: (_, splits) => splits, ...options };
}

const chartHeight = 180;  // pixels

function chartFigure(title, text, place, extra) {
  return element("figure", { class: "chart" },
    element("figcaption", {}, element("h2", {}, title), element("span", { class: "muted" }, text)), place, extra);
}

// The powers of ten around the values, as [low, high].
function decades(values) {
  const low = Math.min(...values), high = Math.max(...values);
  const down = 10 ** Math.floor(Math.log10(low)), up = 10 ** Math.ceil(Math.log10(high));
  return [down, up > down ? up : down * 10];
}

// Marks of a logarithmic axis: the powers of ten in its range, at most six.
function decadeSplits(low, high) {
  const first = Math.ceil(Math.log10(low)), last = Math.floor(Math.log10(high));
  const step = Math.ceil((last - first + 1) / 6);
  const marks = [];
  for (let power = first; power <= last; power += step) marks.push(10 ** power);
  return marks;
}
