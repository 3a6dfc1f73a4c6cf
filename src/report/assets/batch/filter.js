// Which results are shown, in which order.

const wanted = { text: "", verdict: "all", renderer: "all", sort: "verdict", descending: false };

// What each order compares; what is absent comes last either way.
const sortKeys = {
  verdict: (result) => result.rank,
  name: (result) => result.scene,
  renderer: (result) => renderers.indexOf(result.renderer),
  error: (result) => result.error,
  pixels: (result) => result.measured && result.measured.percent_over_one,
  flip: (result) => result.measured && result.measured.flip,
  largest: (result) => result.measured && Math.abs(result.measured.largest.difference),
  time: (result) => result.seconds,
};
// Clicking these first shows the largest on top.
const largestFirst = new Set(["error", "pixels", "flip", "largest", "time"]);

function compareResults(a, b) {
  const key = sortKeys[wanted.sort];
  return compareValues(key(a), key(b), wanted.descending) || b.failed - a.failed ||
    compareValues(a.error, b.error, true) || nameOrder.compare(a.scene, b.scene) || a.index - b.index;
}

function verdictMatches(result) {
  if (wanted.verdict === "all") return true;
  return wanted.verdict === "failures" ? result.failed : result.state === wanted.verdict;
}

function searchText(result) {
  return [result.scene, result.renderer, result.word, result.explanation, result.reason, result.message]
    .join("\n").toLowerCase();
}
const searchTexts = new Map(results.map((result) => [result, searchText(result)]));

// Every word must occur.
function textMatches(result) {
  const text = searchTexts.get(result);
  return wanted.text.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

function shownResults() {
  return results
    .filter((result) => verdictMatches(result) && textMatches(result) &&
      (wanted.renderer === "all" || result.renderer === wanted.renderer))
    .sort(compareResults);
}
