// The table of all settings, over all scenes.

const settingsWanted = { axis: "all" };
let settingsTable = null;

const frontBadge = () => element("span", { class: "badge front" }, icon("pass"), "front");

const settingsColumns = [
  { key: "setting", title: "Setting", head: true, value: ({ setting }) => setting.index,
    cell: ({ setting, front }) => [axisMark(setting.axis, !front), element("span", { class: "name" }, setting.name), element("span", { class: "muted about" }, setting.text)] },
  { key: "axis", title: "Axis", value: ({ setting }) => setting.axis.index, cell: ({ setting }) => setting.axis.title },
  { key: "options", title: "Options", cell: ({ setting }) => copyable(setting.options) },
  { key: "time", title: "Time", number: true, value: ({ time }) => time, note: `Geometric mean over the scenes, relative to ${baseName}`,
    cell: ({ time, timeInterval }) => withInterval(ratioText(time), timeInterval) },
  { key: "error", title: "Error", number: true, value: ({ error }) => error, note: `Geometric mean of the RMSE over the scenes, relative to ${baseName}`,
    cell: ({ error, errorInterval }) => withInterval(ratioText(error), errorInterval) },
  { key: "front", title: "Front", value: ({ front }) => (front ? 0 : 1), note: "No other setting is better in both means", cell: ({ front }) => (front ? frontBadge() : absent) },
  { key: "fronts", title: "Fronts of scenes", number: true, downwards: true, value: ({ fronts }) => fronts, note: "On how many scenes' fronts it is", cell: ({ fronts }) => String(fronts) },
  { key: "scenes", title: "Scenes", number: true, downwards: true, value: ({ scenes: number }) => number, note: "Measured on so many", cell: ({ scenes: number }) => String(number) },
];

function withInterval(text, interval) {
  if (!interval || significant(interval[0]) === significant(interval[1])) return text;
  return [text, " ", element("span", { class: "muted interval" }, intervalText(...interval, significant))];
}

function settingsSection() {
  const rows = totals.map((total) => ({ ...total, index: total.setting.index }));
  const shown = () => rows.filter(({ setting }) => settingsWanted.axis === "all" || setting.axis.name === settingsWanted.axis);
  settingsTable = sortedTable({ caption: "Settings over all scenes", columns: settingsColumns, rows: shown, sort: "setting",
    made: (row, { setting, front }) => {
      row.dataset.setting = setting.name;
      row.classList.toggle("on-front", front);
      row.tabIndex = -1;
    } });
  const choices = [["all", "All"], ...axes.map((axis) => [axis.name, axis.title])];
  const filter = selection("Axis", choices, "all", (name) => {
    settingsWanted.axis = name;
    settingsTable.show();
  });
  settingsTable.reveal = (setting) => {
    if (settingsWanted.axis !== "all" && settingsWanted.axis !== setting.axis.name) {
      settingsWanted.axis = "all";
      filter.querySelector("select").value = "all";
      settingsTable.show();
    }
    for (const row of settingsTable.querySelectorAll("[aria-current]")) row.removeAttribute("aria-current");
    const row = settingsTable.rowOf(rows.find((each) => each.setting === setting));
    row.setAttribute("aria-current", "true");
    row.scrollIntoView({ block: "center" });
    row.focus({ preventScroll: true });
  };
  return element("section", { id: "settings", "aria-label": "Settings" }, element("h2", {}, "Settings"),
    element("div", { class: "toolbar" }, filter), settingsTable);
}

// The setting's row, from a point of the plot.
function showSetting(setting) {
  settingsTable.reveal(setting);
}
