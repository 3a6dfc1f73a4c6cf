// The study's data, with what the page needs to know of each scene and result.

// The pictures of a result, as the stage shows them: the first is compared with the others.
const roles = [["picture", "This setting"], ["converged", "Converged"], ["heat", "Heat map"], ["solution", "Solution"]];

const report = JSON.parse(document.getElementById("report").textContent);
const baseName = "1";  // the setting that the means over all scenes are relative to

const axes = report.axes.map((axis, index) => ({ ...axis, index }));
const axisOf = new Map(axes.map((axis) => [axis.name, axis]));
const settings = report.settings.map((setting, index) => ({ ...setting, index, axis: axisOf.get(setting.axis) || axes[0] }));
const settingOf = new Map(settings.map((setting) => [setting.name, setting]));

// With objects for the names of settings. `places`: of all pictures that the stage can show of a result.
function withSettings(scene, index) {
  const common = scene.places || {};
  const own = scene.results.filter((result) => settingOf.has(result.setting)).map((result) => ({
    ...result, setting: settingOf.get(result.setting), places: { ...common, ...result.places },
    pictured: Boolean(result.places && result.places.picture),
  }));
  const results = new Map(own.map((result) => [result.setting, result]));
  return { ...scene, index, results, places: common, chosen: settingOf.get(scene.chosen) || null };
}

const scenes = report.scenes.map(withSettings);
const baseOf = (scene) => scene.results.get(settingOf.get(baseName)) || null;

// The geometric mean of `values` and its 95 % confidence interval, from the spread of their logarithms, as [low, high];
// null for fewer than two positive values.
function meanInterval(values) {
  const logs = values.filter((value) => value > 0).map(Math.log);
  if (logs.length < 2 || logs.length < values.length) return null;
  const mean = logs.reduce((sum, value) => sum + value, 0) / logs.length;
  const variance = logs.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (logs.length - 1);
  const reach = 1.96 * Math.sqrt(variance / logs.length);
  return [Math.exp(mean - reach), Math.exp(mean + reach)];
}

// Of one setting over all scenes, with how the scenes spread and on how many of their fronts it is.
function withSpread(total) {
  const setting = settingOf.get(total.setting);
  const pairs = scenes.map((scene) => [scene.results.get(setting), baseOf(scene)]).filter(([own, base]) => own && base);
  const ratios = (value) => pairs.map(([own, base]) => value(own) / value(base)).filter(Number.isFinite);
  return {
    ...total, setting,
    timeInterval: meanInterval(ratios((result) => result.ms.median)),
    errorInterval: meanInterval(ratios((result) => result.error.rms)),
    fronts: scenes.filter((scene) => scene.results.get(setting)?.front).length,
  };
}

const totals = report.all.results.filter((total) => settingOf.has(total.setting)).map(withSpread);

// The address of a scene's details within the page: short, and the same in the next report.
const addressOf = (scene) => "#" + encodeURIComponent(scene.scene);
const resultsByAddress = new Map(scenes.map((scene) => [addressOf(scene), scene]));
