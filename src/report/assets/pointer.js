// The points of a plot under the pointer: a tip beside the nearest, and what a click on it does.

// The mark within 12 pixels of the pointer, or null.
function nearest(plot, marks, event) {
  const box = plot.over.getBoundingClientRect();
  let best = null, least = 12;
  for (const mark of marks) {
    const distance = Math.hypot(plot.valToPos(mark.x, "x") - (event.clientX - box.left),
      plot.valToPos(mark.y, "y") - (event.clientY - box.top));
    if (distance < least) [best, least] = [mark, distance];
  }
  return best;
}

// `marks()`: those that can be pointed at, as {x, y, ...} in the plot's units; text(mark); open(mark). The result is a
// function that shows the tip of a mark, or hides it for null.
function addPointer(plot, { marks, text, open }) {
  const tip = element("div", { class: "tip", hidden: true });
  plot.over.append(tip);
  const show = (mark) => {
    tip.hidden = !mark;
    if (!mark) return;
    tip.textContent = text(mark);
    const x = plot.valToPos(mark.x, "x");
    tip.classList.toggle("left", x > plot.over.clientWidth / 2);
    tip.style.left = `${x}px`;
    tip.style.top = `${plot.valToPos(mark.y, "y")}px`;
  };
  plot.over.addEventListener("mousemove", (event) => {
    const mark = nearest(plot, marks(), event);
    plot.over.style.cursor = mark ? "pointer" : "default";
    show(mark);
  });
  plot.over.addEventListener("mouseleave", () => show(null));
  let pressed = null;  // where the button went down; a drag is no click
  plot.over.addEventListener("mousedown", (event) => (pressed = [event.clientX, event.clientY]));
  plot.over.addEventListener("click", (event) => {
    if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const mark = nearest(plot, marks(), event);
    if (mark) open(mark);
  });
  return show;
}
