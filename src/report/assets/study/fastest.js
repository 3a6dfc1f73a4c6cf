// The fastest setting whose error is below a limit that the reader may type.

const limits = [...new Set(scenes.flatMap((scene) => scene.fastest.map((each) => each.below)))].sort((a, b) => b - a);
const wish = { below: limits.find((limit) => limit <= 1) ?? 1 };
const wishChanged = new Set();  // functions to call

// The result; null where none measured is that good. Errors against other pictures than the converged one are not asked.
function fastestBelow(scene, below) {
  let best = null;
  for (const result of scene.results.values())
    if (result.error.against === "converged" && result.error.rms < below && (!best || result.ms.median < best.ms.median))
      best = result;
  return best;
}

// How often each setting is the fastest, the most frequent first: [[setting or null, number of scenes], ...].
function fastestTally(below) {
  const tally = new Map();
  for (const scene of scenes) {
    const best = fastestBelow(scene, below);
    const setting = best && best.setting;
    tally.set(setting, (tally.get(setting) || 0) + 1);
  }
  return [...tally].sort((a, b) => b[1] - a[1]);
}

// The field for the limit. All of them on the page are the same.
function limitField() {
  const field = element("input", { type: "text", inputmode: "decimal", class: "limit", "aria-label": "Error below, in levels",
    autocomplete: "off", value: String(wish.below) });
  field.addEventListener("input", () => {
    const below = Number(field.value.trim().replace(",", "."));
    const wrong = !(below > 0);
    field.setAttribute("aria-invalid", wrong);
    if (wrong || below === wish.below) return;
    wish.below = below;
    for (const changed of [...wishChanged]) changed(field);
  });
  return field;
}

// Keeps the field at the limit that was typed elsewhere; a function that ends this.
function followLimit(field, changed) {
  const follow = (source) => {
    if (source !== field) field.value = String(wish.below);
    changed();
  };
  wishChanged.add(follow);
  return () => wishChanged.delete(follow);
}
