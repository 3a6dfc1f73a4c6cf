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

// Those of the list, in its order; all where it shows none.
function scenesInOrder() {
  const shown = sceneTable.ordered();
  return shown.length ? shown : scenes;
}

const keyActions = {
  n: () => stepThrough(scenesInOrder(), 1),
  p: () => stepThrough(scenesInOrder(), -1),
  b: () => stage && stage.blink(),
  "/": focusFilter,
  "?": openHelp,
};
