// The keys of this page, and going from scene to scene.

const keyHelp = [
  ["n", "Next scene"],
  ["p", "Previous scene"],
  ["b", "Blink between this setting's and the other picture"],
  ["\u2190 \u2192", "From point to point of a plot, or the border of the swipe, whichever has the focus"],
  ["Enter", "Open the point"],
  ["+ - 0", "Zoom a plot, show all of it"],
  ["/", "Filter the scenes"],
  ["?", "This help"],
  ["Esc", "Close"],
];

// In the order of the list, around at its ends.
function stepScene(step) {
  const shown = sceneTable.ordered();
  const order = shown.length ? shown : scenes;
  if (!order.length) return;
  const at = order.indexOf(opened);
  const next = at < 0 ? (step > 0 ? 0 : order.length - 1) : (at + step + order.length) % order.length;
  location.hash = addressOf(order[next]);
  followAddress();  // now, for the next key
}

function focusFilter() {
  closeDetail();
  const field = document.getElementById("filter-text");
  field.focus();
  field.select();
}

const keyActions = {
  n: () => stepScene(1),
  p: () => stepScene(-1),
  b: () => stage && stage.blink(),
  "/": focusFilter,
  "?": openHelp,
};
