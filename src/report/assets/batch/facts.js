// The figures of one result.

const measureTerms = [
  ["Mean absolute", "mean_absolute", figure],
  ["RMSE", "root_mean_square", figure],
  ["PSNR, dB", "peak_signal_to_noise", decibel],
  ["Mean signed", "mean_signed", figure],
  ["Largest", "largest", level],
];

function channelNames(measured) {
  const names = [["Gray"], ["Gray", "Alpha"], ["Red", "Green", "Blue"], ["Red", "Green", "Blue", "Alpha"]];
  return names[measured.channels - 1] || measured.channel.map((_, index) => `Channel ${index + 1}`);
}

function errorTable(measured) {
  const all = { ...measured, largest: Math.abs(measured.largest.difference) };
  const channels = measured.channel || [];
  const inColumns = [["All", all], ...(channels.length > 1 ? channels.map((one, i) => [channelNames(measured)[i], one]) : []),
    ["Foreground", measured.foreground]].filter(([, figures]) => figures);
  return element("div", { class: "wide" }, element("table", { class: "figures" },
    element("caption", {}, "Error, in levels of 255"),
    element("thead", {}, element("tr", {}, element("td"),
      ...inColumns.map(([name]) => element("th", { scope: "col" }, name)))),
    element("tbody", {}, ...measureTerms.map(([name, key, text]) => element("tr", {}, element("th", { scope: "row" }, name),
      ...inColumns.map(([, figures]) => element("td", {}, text(figures[key]))))))));
}

function largestText({ largest, channels }) {
  const names = channels >= 3 ? ["red", "green", "blue", "alpha"] : ["gray", "alpha"];
  return `at ${largest.x}, ${largest.y} in ${names[largest.channel] || largest.channel}: ${level(largest.test)} for ${level(largest.reference)}`;
}

function pictureTerms(measured) {
  const { percentiles, edge_tolerant: edges, not_finite: notFinite } = measured;
  const bad = notFinite && notFinite.reference + notFinite.test > 0;
  return [
    ["Largest difference", largestText(measured)],
    ["Pixels that differ", percent(measured.percent_different)],
    ["\u2026 by more than a level", percent(measured.percent_over_one)],
    measured.threshold !== 1 ? [`\u2026 by more than ${level(measured.threshold)}`, percent(measured.percent_over_threshold)] : null,
    percentiles ? ["50, 90, 99, 99.9 % are within", ["p50", "p90", "p99", "p99.9"].map((key) => level(percentiles[key])).join(", ")] : null,
    ["SSIM", figure(measured.ssim, 4)],
    ["FLIP", figure(measured.flip, 4)],
    edges ? ["Edges forgiven", `${figure(edges.root_mean_square)} RMS of the worst channel, ${percent(edges.percent_over_one)} over a level`] : null,
    bad ? ["Not finite", `${count(notFinite.test, "sample")} of the rendered picture, ${notFinite.reference} of the solution`] : null,
    ["Size", `${measured.width} \u00d7 ${measured.height}, ${count(measured.channels, "channel")}`],
  ];
}

function toleranceText(tolerance) {
  const number = (value) => typeof value === "number";
  return [number(tolerance.rmse) && `RMSE ${tolerance.rmse}`, number(tolerance.max) && `largest ${tolerance.max}`,
    number(tolerance.pixels) && `${tolerance.pixels} % of pixels over ${count(tolerance.over, "level")}`,
    number(tolerance.ssim) && `SSIM at least ${tolerance.ssim}`, number(tolerance.flip) && `FLIP ${tolerance.flip}`]
    .filter((text) => text).join(", ");
}

function runTerms(result) {
  const number = (value, text) => (typeof value === "number" ? text(value) : null);
  return [
    ["Time", duration(result.seconds)],
    ["Processor time", number(result.cpu_seconds, duration)],
    ["Memory", number(result.memory_mib, (value) => `${figure(value, 1)} MiB`)],
    ["Rays", number(result.rays, (value) => value.toLocaleString("en"))],
    ["Depth", number(result.depth, String)],
    ["Width", number(result.width, String)],
    ["Renderer", result.renderer],
    ["Picture", result.picture],
    ["Solution", result.solution],
  ].map((term) => (term[1] ? term : null));
}

function factsSection(result) {
  const { measured, comparison } = result;
  const tolerance = comparison && comparison.tolerance && toleranceText(comparison.tolerance);
  return element("section", { class: "facts-of" },
    measured ? element("h3", {}, "Measurements") : null,
    measured ? errorTable(measured) : null,
    measured ? termList([...pictureTerms(measured), tolerance ? ["Tolerance", tolerance] : null]) : null,
    element("h3", {}, "Run"), termList(runTerms(result)));
}
