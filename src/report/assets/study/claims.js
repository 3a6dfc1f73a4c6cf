// What follows for all scenes: factors between ways to the same error, and the fastest settings.

function claimCard(claim) {
  const range = typeof claim.low === "number" && typeof claim.high === "number"
    ? ` ${ratioText(claim.low)} to ${ratioText(claim.high)}` : "";
  const over = typeof claim.scenes === "number" ? ` over ${count(claim.scenes, "scene")}` : "";
  return element("li", { class: "claim" },
    element("strong", {}, ratioText(claim.times)),
    element("span", {}, `as fast: ${claim.text}`),
    range || over ? element("span", { class: "muted" }, `${range}${over}`.trim()) : null);
}

function fastestOverall() {
  const rows = (report.all.fastest || []).map((each) => element("tr", {},
    element("th", { scope: "row" }, `below ${ratioText(each.below)}`),
    element("td", {}, each.setting === undefined ? "none measured" : settingButton(settingOf.get(each.setting), showSetting)),
    element("td", { class: "number" }, each.setting === undefined ? "" : ratioText(each.time))));
  if (!rows.length) return null;
  return element("table", { class: "figures answers" },
    element("caption", {}, `The fastest setting for an error, relative to ${baseName}, of the mean over all scenes`),
    element("thead", {}, element("tr", {}, ...["Error", "Setting", "Time"].map((name) => element("th", { scope: "col" }, name)))),
    element("tbody", {}, ...rows));
}

function claimsSection() {
  const claims = report.all.claims || [];
  const fastest = fastestOverall();
  if (!claims.length && !fastest) return null;
  return element("section", { class: "claims", "aria-label": "In short" },
    claims.length ? element("ul", {}, ...claims.map(claimCard)) : null, fastest ? element("div", { class: "wide" }, fastest) : null);
}
