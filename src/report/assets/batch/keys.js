// The keys of this page, and going from failure to failure.

const keyHelp = [
  ["n", "Next failure"],
  ["p", "Previous failure"],
  ["b", "Blink between the rendered and the other picture"],
  ["\u2190 \u2192", "Move the border of the swipe, when it has the focus"],
  ["/", "Filter"],
  ["?", "This help"],
  ["Esc", "Close"],
];

// Those of the list, in its order; of all where the list shows none.
function failuresInOrder() {
  const shown = shownResults().filter((result) => result.failed);
  return shown.length ? shown : results.filter((result) => result.failed).sort(compareResults);
}

const keyActions = {
  n: () => stepThrough(failuresInOrder(), 1),
  p: () => stepThrough(failuresInOrder(), -1),
  b: () => stage && stage.blink(),
  "/": focusFilter,
  "?": openHelp,
};
