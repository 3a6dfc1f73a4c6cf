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

// From the open result, or into the list; around at its ends.
function stepFailure(step) {
  const failures = failuresInOrder();
  if (!failures.length) return;
  const at = failures.indexOf(opened);
  const next = at < 0 ? (step > 0 ? 0 : failures.length - 1) : (at + step + failures.length) % failures.length;
  location.hash = addressOf(failures[next]);
  followAddress();  // now, for the next key
}

function focusFilter() {
  closeDetail();
  const field = document.getElementById("filter-text");
  field.focus();
  field.select();
}

const keyActions = {
  n: () => stepFailure(1),
  p: () => stepFailure(-1),
  b: () => stage && stage.blink(),
  "/": focusFilter,
  "?": openHelp,
};
