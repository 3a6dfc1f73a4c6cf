// Time against error, a point a result. A click on a point, or on a name in the list below, opens it.

const markSize = 4;  // half of it, in pixels of the screen

function scatterData() {
  const plotted = results.filter((result) => result.error !== null && result.seconds > 0)
    .sort((a, b) => a.seconds - b.seconds);
  const errors = plotted.map((result) => result.error).filter((error) => error > 0);
  const [low, high] = errors.length ? decades(errors) : [0.1, 1];
  const floor = low / 10;  // where a logarithmic axis shows an error of 0
  return { plotted, floor, high, height: (result) => result.error || floor };
}

// Circles pass, crosses fail.
function drawMark(context, x, y, failed, size) {
  context.beginPath();
  if (failed) {
    context.moveTo(x - size, y - size);
    context.lineTo(x + size, y + size);
    context.moveTo(x + size, y - size);
    context.lineTo(x - size, y + size);
  } else {
    context.arc(x, y, size, 0, 2 * Math.PI);
  }
  context.stroke();
}

function drawMarks(plot, data) {
  const { ctx: context } = plot;
  const scale = devicePixelRatio;
  context.save();
  context.lineWidth = 1.6 * scale;
  for (const result of data.plotted) {
    context.strokeStyle = colour(result.failed ? "fail" : "accent");
    drawMark(context, plot.valToPos(result.seconds, "x", true), plot.valToPos(data.height(result), "y", true),
      result.failed, markSize * scale);
  }
  context.restore();
}

const scatterText = (result) =>
  `${result.scene}${severalRenderers ? `, ${result.renderer}` : ""}: RMSE ${figure(result.error)}, ${duration(result.seconds)}`;

const axisDuration = (seconds) => (seconds < 1 ? `${+(seconds * 1000).toPrecision(1)} ms` : `${seconds} s`);

function drawScatter(place, width, data) {
  const errorName = (value) => (value <= data.floor * 1.01 ? "0" : String(+value.toPrecision(2)));
  const [first, last] = decades(data.plotted.map((result) => result.seconds));
  const errorSplits = [data.floor, ...decadeSplits(data.floor * 9, data.high * 1.2)];
  const plot = new uPlot({
    width, height: chartHeight, legend: { show: false },
    cursor: { x: false, y: false, points: { show: false }, drag: { x: false, y: false } },
    scales: { x: { time: false, distr: 3, range: [first * 0.9, last * 1.1] },
      y: { distr: 3, range: [data.floor * 0.7, data.high * 1.2] } },
    axes: [
      chartAxis({ label: "Time", size: 30, splits: () => decadeSplits(first * 0.9, last * 1.1), values: (_, splits) => splits.map(axisDuration) }),
      chartAxis({ label: "RMSE", size: 54, splits: () => errorSplits, values: (_, splits) => splits.map(errorName) }),
    ],
    series: [{}, { paths: () => null, points: { show: false } }],
    hooks: { draw: [(drawn) => drawMarks(drawn, data)] },
  }, [data.plotted.map((result) => result.seconds), data.plotted.map(data.height)], place);
  addPointer(plot, {
    marks: () => data.plotted.map((result) => ({ x: result.seconds, y: data.height(result), result })),
    text: ({ result }) => scatterText(result),
    open: ({ result }) => (location.hash = addressOf(result)),
  });
  return plot;
}

function pointList(data) {
  const order = [...data.plotted].sort((a, b) => b.error - a.error || b.seconds - a.seconds);
  const entry = (result) => element("li", {},
    element("a", { href: addressOf(result) }, result.scene, severalRenderers ? ` (${result.renderer})` : ""),
    ` RMSE ${figure(result.error)}, ${duration(result.seconds)}`);
  return element("details", { class: "points" }, element("summary", {}, "The points as a list of links"),
    element("ol", {}, ...order.map(entry)));
}

function scatterFigure() {
  const data = scatterData();
  if (data.plotted.length < 2) return null;
  const place = element("div", { class: "plot", role: "img",
    "aria-label": `Time against RMSE of ${count(data.plotted.length, "result")}; they follow as a list.` });
  keepDrawn(place, (width) => drawScatter(place, width, data));
  return chartFigure("Time against error", "A click on a point opens its scene; crosses fail", place, pointList(data));
}
