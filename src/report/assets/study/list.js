// The scenes: a row each, with what a scene takes at the first setting and which setting is the fastest that is good enough.

const sceneWanted = { text: "" };
let sceneTable = null;

const bestOf = (scene) => fastestBelow(scene, wish.below);

const sceneColumns = [
  { key: "picture", title: "Picture", class: "thumbs", cell: ({ places }) => (places.converged || places.solution
    ? thumbnail(places.converged || places.solution, "") : "") },
  { key: "scene", title: "Scene", head: true, value: ({ scene }) => scene,
    cell: (scene) => element("a", { href: addressOf(scene) }, pathText(scene.scene)) },
  { key: "size", title: "Size", number: true, value: ({ width, height }) => width * height, downwards: true,
    cell: ({ width, height }) => `${width} ${times} ${height}` },
  { key: "time", title: `Time of ${baseName}`, number: true, downwards: true, value: (scene) => baseOf(scene)?.ms.median, cell: (scene) => timeText(baseOf(scene)?.ms.median) },
  { key: "error", title: `Error of ${baseName}`, number: true, downwards: true, note: "RMSE in levels of 255", value: (scene) => baseOf(scene)?.error.rms,
    cell: (scene) => significant(baseOf(scene)?.error.rms) },
  { key: "best", live: true, title: "Fastest good enough", note: "The fastest setting with an error below the limit", value: (scene) => bestOf(scene)?.setting.index,
    cell: (scene) => nameOf(bestOf(scene)?.setting) },
  { key: "best-time", live: true, title: "Its time", number: true, downwards: true, value: (scene) => bestOf(scene)?.ms.median, cell: (scene) => timeText(bestOf(scene)?.ms.median) },
  { key: "best-error", live: true, title: "Its error", number: true, downwards: true, value: (scene) => bestOf(scene)?.error.rms, cell: (scene) => significant(bestOf(scene)?.error.rms) },
  { key: "chosen", title: "Recommended", value: ({ chosen }) => chosen?.index, cell: ({ chosen }) => nameOf(chosen) },
];

const nameOf = (setting) => (setting ? [axisMark(setting.axis), setting.name] : absent);

const sceneTexts = new Map(scenes.map((scene) => [scene, [scene.scene, scene.chosen?.name].join("\n").toLowerCase()]));
const sceneMatches = (scene) => sceneWanted.text.toLowerCase().split(/\s+/).every((word) => sceneTexts.get(scene).includes(word));

function tallyText() {
  const words = fastestTally(wish.below).slice(0, 6)
    .map(([setting, number]) => `${setting ? setting.name : "none measured"} in ${number}`);
  return `Below ${levelsText(wish.below)} the fastest is ${words.join(", ")} of ${count(scenes.length, "scene")}.`;
}

function scenesSection() {
  const status = element("p", { class: "muted", role: "status", id: "count" });
  const tally = element("p", { id: "tally", role: "status" }, tallyText());
  const shown = () => scenes.filter(sceneMatches);
  sceneTable = sortedTable({ caption: "Scenes", columns: sceneColumns, rows: shown, sort: "scene", nothing: "No scene matches.",
    made: (row, scene) => {
      row.dataset.scene = scene.scene;
      row.addEventListener("click", (event) => {
        if (!event.target.closest("a, button") && !String(getSelection())) location.hash = addressOf(scene);
      });
    } });
  sceneTable.id = "scenes";
  const filter = (value) => {
    sceneWanted.text = value;
    sceneTable.show();
    const number = shown().length;
    status.textContent = number === scenes.length ? "" : `${number} of ${count(scenes.length, "scene")}`;
  };
  const text = element("input", { type: "search", id: "filter-text", "aria-keyshortcuts": "/", autocomplete: "off", placeholder: "name \u2026",
    oninput: (event) => filter(event.target.value) });
  text.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    text.value = "";
    filter("");
    text.blur();
  });
  const field = limitField();
  followLimit(field, () => {
    tally.textContent = tallyText();
    sceneTable.refresh();
  });
  return element("section", { "aria-label": "Scenes" }, element("h2", {}, "Scenes"),
    element("div", { class: "toolbar" }, element("label", { class: "field" }, element("span", {}, "Filter"), text),
      element("label", { class: "field" }, element("span", {}, "Error below"), field, element("span", {}, "levels"))),
    tally, status, sceneTable);
}
