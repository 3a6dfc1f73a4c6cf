// A plot by the keyboard: from point to point in the order of time.

const inView = (view, mark) => mark.x >= view.x[0] && mark.x <= view.x[1] && mark.y >= view.y[0] && mark.y <= view.y[1];

// marks(): those shown; show(mark), hide(), open(mark), zoom(factor), of which 0 shows all.
function addSteps(place, { marks, show, hide, open, zoom }) {
  let current = null;
  const step = (by) => {
    const order = [...marks()].sort((a, b) => a.x - b.x || b.y - a.y);
    if (!order.length) return;
    const at = order.indexOf(current);
    current = order[at < 0 ? (by > 0 ? 0 : order.length - 1) : Math.min(Math.max(at + by, 0), order.length - 1)];
    show(current);
  };
  const actions = {
    ArrowRight: () => step(1),
    ArrowLeft: () => step(-1),
    Enter: () => current && open(current),
    "+": () => zoom(0.7),
    "-": () => zoom(1 / 0.7),
    0: () => zoom(0),
  };
  place.addEventListener("keydown", (event) => {
    const action = !event.ctrlKey && !event.altKey && !event.metaKey && actions[event.key];
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  });
  place.addEventListener("blur", () => {
    current = null;
    hide();
  });
}
