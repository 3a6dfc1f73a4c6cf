// The pictures of the setting that is chosen.

function picturesOf(scene, setting) {
  const result = scene.results.get(setting);
  const text = element("p", { class: "muted" }, setting.text);
  const title = element("h3", {}, axisMark(setting.axis, !(result && result.front)), ` ${setting.name}`);
  if (stage) stage.close();
  stage = null;
  if (!result || !Object.keys(result.places).length)
    return element("section", { class: "shown" }, title, text, element("p", { class: "muted" }, "There are no pictures."));
  const missing = result.pictured ? null : element("p", { class: "muted" }, "Of this setting no picture was kept.");
  return element("section", { class: "shown" }, title, text, missing, openStage({ ...result, measured: null, state: "", stretch: true }));
}
