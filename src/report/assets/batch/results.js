// The report's data, with what the page needs to know of each result.

// The pictures of a result, as the stage shows them: the first is compared with the others.
const roles = [["picture", "Rendered"], ["solution", "Solution"], ["heat", "Heat map"]];

const report = JSON.parse(document.getElementById("report").textContent);

// What can have come of a scene, worst first: the outcome, or the verdict where there is a picture.
const states = new Map([
  ["crashed", "crashed"],
  ["memory", "out of memory"],
  ["timeout", "timed out"],
  ["failed", "failed"],
  ["no-picture", "no picture"],
  ["stale-picture", "stale picture"],
  ["bad-picture", "bad picture"],
  ["unreadable", "unreadable"],
  ["missing", "missing"],
  ["extra", "no solution"],
  ["not-finite", "not finite"],
  ["size-differs", "size differs"],
  ["channels-differ", "channels differ"],
  ["beyond", "beyond tolerance"],
  ["within", "within tolerance"],
  ["rendered", "rendered"],
  ["identical", "identical"],
]);
const passing = new Set(["within", "rendered", "identical"]);
const ranks = new Map([...states.keys()].map((state, rank) => [state, rank]));

function stateOf(result) {
  if (result.outcome !== "rendered") return result.outcome;
  return result.comparison ? result.comparison.verdict : "rendered";
}

function withState(result, index) {
  const comparison = result.comparison || {};
  const measured = comparison.measurements || null;
  const state = stateOf(result);
  return {
    ...result,
    index,
    state,
    word: states.get(state) || state,
    rank: ranks.get(state) ?? 0,
    failed: !passing.has(state),
    measured,
    error: measured ? measured.root_mean_square : null,
    explanation: (comparison.diagnosis && comparison.diagnosis.text) || "",
    reason: comparison.reason || "",
    places: result.places || {},
  };
}

const results = report.results.map(withState);
const renderers = [...new Set([...(report.renderers || []), ...results.map((result) => result.renderer)])];
const severalRenderers = renderers.length > 1;

// The address of a result's details within the page: short, and the same in the next report.
const addressOf = (result) =>
  "#" + encodeURIComponent(result.scene) + (severalRenderers ? "@" + renderers.indexOf(result.renderer) : "");
const resultsByAddress = new Map(results.map((result) => [addressOf(result), result]));

// The first line that says something, of a diagnostic.
const firstLine = (text) => (text || "").split("\n").find((line) => line.trim()) || "";

// Why a result is what it is, in one line.
function explain(result) {
  return result.explanation || firstLine(result.message) || result.reason;
}
