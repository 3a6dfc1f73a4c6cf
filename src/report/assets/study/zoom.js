// What part of a log-log plot is seen. A view: {x: [low, high], y: [low, high], whole: {x, y}}.

// Around all marks and their bars, with a margin.
function wholeView(marks, floor) {
  const around = (values) => {
    const positive = values.filter((value) => value > 0);
    if (!positive.length) return [0.1, 10];
    const low = Math.min(...positive), high = Math.max(...positive);
    const margin = (high / low) ** 0.07 * 1.25;
    return [low / margin, high * margin];
  };
  const x = around(marks.flatMap((mark) => [mark.x, ...(mark.xBar || [])]));
  const y = around([...marks.map((mark) => mark.y), ...marks.flatMap((mark) => (mark.yBar ? [mark.yBar[1]] : [])),
    ...(floor ? [floor.value] : [])]);
  return { x, y, whole: { x, y } };
}

const isWhole = (view) => view.x === view.whole.x && view.y === view.whole.y;
const leastSpan = 1.02;  // high / low

// By this factor (below 1: nearer) around a point; never beyond the whole.
function zoomView(view, factor, centre) {
  for (const key of ["x", "y"]) {
    const [low, high] = view[key], [least, most] = view.whole[key];
    const at = centre[key];
    const now = [Math.max(at * (low / at) ** factor, least), Math.min(at * (high / at) ** factor, most)];
    if (now[1] / now[0] < leastSpan) continue;
    view[key] = now[0] === least && now[1] === most ? view.whole[key] : now;
  }
}

function resetView(view) {
  view.x = view.whole.x;
  view.y = view.whole.y;
}

function middleOf(view) {
  return { x: Math.sqrt(view.x[0] * view.x[1]), y: Math.sqrt(view.y[0] * view.y[1]) };
}

// Wheel and double click; drags are told of by the plot itself. Where the whole is seen the wheel scrolls the page.
function addZoom(plot, view, changed) {
  plot.over.addEventListener("wheel", (event) => {
    if (event.ctrlKey || event.deltaY === 0 || (event.deltaY > 0 && isWhole(view))) return;
    event.preventDefault();
    const box = plot.over.getBoundingClientRect();
    zoomView(view, event.deltaY > 0 ? 1.25 : 0.8,
      { x: plot.posToVal(event.clientX - box.left, "x"), y: plot.posToVal(event.clientY - box.top, "y") });
    changed();
  }, { passive: false });
  plot.over.addEventListener("dblclick", () => {
    resetView(view);
    changed();
  });
}

// To the rectangle that was drawn with the pointer.
function zoomToSelection(plot, view) {
  const { left, top, width, height } = plot.select;
  if (width < 6 || height < 6) return false;
  const x = [plot.posToVal(left, "x"), plot.posToVal(left + width, "x")];
  const y = [plot.posToVal(top + height, "y"), plot.posToVal(top, "y")];
  if (x[1] / x[0] < leastSpan || y[1] / y[0] < leastSpan) return false;
  view.x = x;
  view.y = y;
  return true;
}
