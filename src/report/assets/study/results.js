// The settings of one scene as a table.

const raysOf = ({ rays }) => (rays ? Object.values(rays).reduce((sum, value) => sum + value, 0) : null);

function raysText(result) {
  const total = raysOf(result);
  if (total === null) return absent;
  const words = Object.entries(result.rays).map(([kind, number]) => `${number.toLocaleString("en")} ${kind}`).join(", ");
  return element("span", { title: words }, total.toLocaleString("en"));
}

function gainText({ gain }) {
  if (!gain) return absent;
  return [`${withSign(gain.rms, significant)} for ${withSign(gain.ms, timeText)}`, " ", element("span", { class: "muted interval" }, `over ${gain.over}`)];
}

// Levels less for a millisecond more; what is better for nothing is first.
function gainRate({ gain }) {
  if (!gain) return null;
  if (gain.rms >= 0) return -gain.rms / Math.max(Math.abs(gain.ms), 1e-9);
  return gain.ms > 0 ? -gain.rms / gain.ms : Infinity;
}

function remarks(result) {
  const words = [result.error.against !== "converged" ? `against ${result.error.against}` : null,
    result.same_picture === true ? "same picture" : result.same_picture === false ? "another picture" : null];
  return words.filter((word) => word).join(", ");
}

function resultColumns(scene, choose) {
  const columns = [
    { key: "setting", title: "Setting", head: true, value: ({ setting }) => setting.index,
      cell: ({ setting, front }) => [settingButton(setting, choose, !front),
        setting === scene.chosen ? element("span", { class: "badge front" }, icon("pass"), "recommended") : "",
        element("span", { class: "about" }, copyable(setting.options))] },
    { key: "time", title: "Time", number: true, value: ({ ms }) => ms.median, note: "Median; the confidence interval of the median",
      cell: ({ ms }) => element("span", { title: `${count(ms.runs, "run")}` }, timeText(ms.median), " ", element("span", { class: "muted interval" }, intervalText(ms.low, ms.high, timeText))) },
    { key: "error", title: "Error", number: true, value: ({ error }) => error.rms, note: "RMSE in levels of 255, with its uncertainty",
      cell: (result) => [errorText(result.error), remarks(result) ? element("span", { class: "muted about" }, remarks(result)) : ""] },
    { key: "mean", title: "Mean", number: true, value: ({ error }) => error.mean, note: "Mean absolute error, in levels", cell: ({ error }) => significant(error.mean) },
    { key: "largest", title: "Max", number: true, downwards: true, value: ({ error }) => error.largest, note: "Largest error, in levels", cell: ({ error }) => significant(error.largest) },
    { key: "front", title: "Front", value: ({ front }) => (front ? 0 : 1), note: "No other setting of this scene is better in both time and error", cell: ({ front }) => (front ? frontBadge() : absent) },
    { key: "gain", title: "Gain", number: true, downwards: true, value: gainRate, note: "Change of the error and of the time against the step before on its axis; sorted by levels a millisecond", cell: gainText },
    { key: "rays", title: "Rays", number: true, downwards: true, value: raysOf, cell: raysText },
    { key: "memory", title: "Memory", number: true, downwards: true, value: ({ memory }) => memory, cell: ({ memory }) => bytesText(memory) },
  ];
  if ([...scene.results.values()].some((result) => result.solution))
    columns.push({ key: "solution", title: "To solution", number: true, value: ({ solution }) => solution?.rms, note: "RMSE to the solution, in levels; share of pixels off by more than one",
      cell: ({ solution }) => (solution ? [significant(solution.rms), " ", element("span", { class: "muted interval" }, `${significant(solution.off_by_more_than_one)}${thin}%`)] : absent) });
  return columns;
}

function resultsTable(scene, choose) {
  const rows = [...scene.results.values()].map((result) => Object.assign(result, { index: result.setting.index }));
  const table = sortedTable({ caption: `Settings of ${scene.scene}`, columns: resultColumns(scene, choose), rows: () => rows, sort: "setting",
    made: (row, result) => {
      row.dataset.setting = result.setting.name;
      row.classList.toggle("on-front", result.front);
      row.addEventListener("click", (event) => {
        if (!event.target.closest("button") && !String(getSelection())) choose(result.setting);
      });
    } });
  table.mark = (setting) => {
    for (const result of rows) {
      const row = table.rowOf(result);
      if (result.setting === setting) row.setAttribute("aria-current", "true");
      else row.removeAttribute("aria-current");
    }
  };
  return table;
}
