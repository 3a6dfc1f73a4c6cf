// How many results have how large an error.

const errorSteps = [0, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, Infinity];  // levels

// Bars: no error at all, then (step, next step], then the results without a figure.
function errorBars() {
  const bars = [{ name: "0", passed: 0, failed: 0 }];
  for (let i = 1; i < errorSteps.length; ++i)
    bars.push({ name: i === 1 ? "<.01" : String(errorSteps[i - 1]).replace(/^0/, ""), passed: 0, failed: 0 });
  bars.push({ name: "none", passed: 0, failed: 0 });
  for (const result of results) {
    const { error } = result;
    const place = error === null ? bars.length - 1 : error === 0 ? 0 : errorSteps.findIndex((step) => error <= step);
    bars[place][result.failed ? "failed" : "passed"] += 1;
  }
  return bars;
}

function drawHistogram(place, width, bars) {
  const at = bars.map((_, index) => index);
  const totals = bars.map((bar) => bar.passed + bar.failed || null);
  const passed = bars.map((bar) => bar.passed || null);
  const paths = uPlot.paths.bars({ size: [0.8, 60] });
  const series = (name) => ({ fill: colour(name), stroke: colour(name), width: 0, paths, points: { show: false } });
  const names = bars.map((bar, index) => (width > 460 || index % 2 === 1 ? bar.name : ""));
  const whole = (plot, splits) => splits.map((value) => (Number.isInteger(value) ? value : ""));
  return new uPlot({
    width, height: chartHeight, legend: { show: false }, cursor: { show: false },
    scales: { x: { time: false, range: [-0.6, bars.length - 0.4] }, y: { range: [0, Math.max(...totals) * 1.08] } },
    axes: [
      chartAxis({ splits: () => at, values: () => names, size: 30, grid: { show: false },
        label: "RMSE above \u2026 levels; none: it has no figure", space: 10 }),
      chartAxis({ values: whole, size: 44, label: "Results" }),
    ],
    series: [{}, series("fail"), series("accent")],
  }, [at, totals, passed], place);
}

function histogramFigure() {
  if (!results.some((result) => result.error !== null)) return null;
  const bars = errorBars();
  const spoken = bars.filter((bar) => bar.passed + bar.failed)
    .map((bar) => `${bar.name}: ${bar.passed} passing, ${bar.failed} failing`).join("; ");
  const place = element("div", { class: "plot", role: "img", "aria-label": `Results by RMSE. ${spoken}` });
  keepDrawn(place, (width) => drawHistogram(place, width, bars));
  const keys = element("p", { class: "keys muted" },
    element("span", { class: "key pass" }), "passing", element("span", { class: "key fail" }), "failing");
  return chartFigure("Errors", "How many results are how far off", place, keys);
}
