// Drawing a plot's marks on its canvas. A mark: {x, y, xBar, yBar, low, front, setting, ...} in the plot's units; the bars
// are [low, high] or null; `low`: the error is too small to be shown and y is the floor.

const markRadius = 5;  // pixels of the page

function placeOf(plot, mark) {
  return [plot.valToPos(mark.x, "x", true), plot.valToPos(mark.y, "y", true)];
}

function drawShape(context, axis, x, y, radius, filled) {
  context.save();
  context.translate(x, y);
  context.scale(radius, radius);
  const path = new Path2D(shapeOf(axis));
  context.lineWidth = 1.7 * devicePixelRatio / radius;
  context.strokeStyle = colourOf(axis);
  context.fillStyle = filled ? colourOf(axis) : colour("panel");
  context.fill(path);
  context.stroke(path);
  context.restore();
}

function line(context, ...points) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.stroke();
}

function drawBars(plot, mark) {
  const { ctx: context } = plot;
  const [x, y] = placeOf(plot, mark);
  const at = (value, scale) => plot.valToPos(value, scale, true);
  context.strokeStyle = colourOf(mark.setting.axis);
  if (mark.xBar) line(context, [at(mark.xBar[0], "x"), y], [at(mark.xBar[1], "x"), y]);
  if (mark.yBar) line(context, [x, at(Math.max(mark.yBar[0], 1e-12), "y")], [x, at(mark.yBar[1], "y")]);
}

// Below a mark at the floor: it would be lower.
function drawArrow(plot, mark) {
  const { ctx: context } = plot;
  const [x, y] = placeOf(plot, mark), scale = devicePixelRatio;
  context.strokeStyle = colourOf(mark.setting.axis);
  line(context, [x, y], [x, y + 13 * scale]);
  line(context, [x - 3 * scale, y + 10 * scale], [x, y + 13 * scale], [x + 3 * scale, y + 10 * scale]);
}

const frontPlaces = (plot, marks) =>
  marks.filter((mark) => mark.front).sort((a, b) => a.x - b.x).map((mark) => placeOf(plot, mark));

function drawFront(plot, marks) {
  const { ctx: context } = plot;
  context.strokeStyle = colour("muted");
  context.lineWidth = 1.4 * devicePixelRatio;
  line(context, ...frontPlaces(plot, marks));
}

// Small boxes along the front, [left, top, right, bottom] each.
function frontBoxes(plot, marks) {
  const places = frontPlaces(plot, marks), boxes = [], gap = 6 * devicePixelRatio;
  for (let i = 1; i < places.length; ++i) {
    const [[x0, y0], [x1, y1]] = [places[i - 1], places[i]];
    const pieces = Math.min(400, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / gap));
    for (let piece = 1; piece < pieces; ++piece) {
      const x = x0 + (x1 - x0) * piece / pieces, y = y0 + (y1 - y0) * piece / pieces;
      boxes.push([x - 1, y - 1, x + 1, y + 1]);
    }
  }
  return boxes;
}

function drawFloor(plot, floor) {
  const { ctx: context, bbox: box } = plot;
  const y = plot.valToPos(floor.value, "y", true), scale = devicePixelRatio;
  context.strokeStyle = context.fillStyle = colour("muted");
  context.lineWidth = scale;
  context.setLineDash([4 * scale, 4 * scale]);
  line(context, [box.left, y], [box.left + box.width, y]);
  context.setLineDash([]);
  context.textAlign = "left";
  context.fillText(floor.text, box.left + 6 * scale, y + 14 * scale);
}

// Names beside the marks of the front, as far as there is room.
function drawNames(plot, marks, floor, selected) {
  const { ctx: context, bbox } = plot;
  const scale = devicePixelRatio, tall = 13 * scale;
  const taken = marks.map((mark) => {
    const [x, y] = placeOf(plot, mark), r = markRadius * scale;
    return [x - r, y - r, x + r, y + r];
  });
  taken.push(...frontBoxes(plot, marks));
  if (floor) {
    const y = plot.valToPos(floor.value, "y", true);
    taken.push([bbox.left, y, bbox.left + 6 * scale + context.measureText(floor.text).width, y + 18 * scale]);
  }
  const free = ([l, t, r, b]) => l >= bbox.left && r <= bbox.left + bbox.width && t >= bbox.top && b <= bbox.top + bbox.height &&
    taken.every(([left, top, right, bottom]) => r < left || l > right || b < top || t > bottom);
  context.textAlign = "left";
  context.fillStyle = colour("text");
  const first = (mark) => (mark.setting === selected ? 0 : 1);
  for (const mark of marks.filter((each) => each.front || each.setting === selected).sort((a, b) => first(a) - first(b))) {
    const [x, y] = placeOf(plot, mark), gap = (mark.setting === selected ? 13 : 9) * scale;
    const wide = context.measureText(mark.setting.name).width;
    const above = y - gap * 0.6 - tall, below = y + gap * 0.6;
    const places = [[x + gap, y - tall / 2], [x + gap * 0.6, above], [x - gap - wide, y - tall / 2], [x - gap * 0.6 - wide, below],
      [x + gap * 0.6, below], [x - gap * 0.6 - wide, above], [x - wide / 2, above - gap * 0.5], [x - wide / 2, below + gap * 0.5]];
    const place = places.map(([l, t]) => [l, t, l + wide, t + tall]).find(free);
    if (!place) continue;
    taken.push(place);
    context.fillText(mark.setting.name, place[0], place[1] + tall * 0.8);
  }
}

function drawAll(plot, marks, floor, selected) {
  const { ctx: context, bbox: box } = plot;
  context.save();
  context.beginPath();
  context.rect(box.left, box.top, box.width, box.height);
  context.clip();
  context.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
  if (floor) drawFloor(plot, floor);
  drawFront(plot, marks);
  context.lineWidth = 1.2 * devicePixelRatio;
  for (const mark of marks) drawBars(plot, mark);
  context.lineWidth = 1.5 * devicePixelRatio;
  for (const mark of marks) if (mark.low) drawArrow(plot, mark);
  for (const mark of marks) {
    const [x, y] = placeOf(plot, mark), chosen = mark.setting === selected;
    if (chosen) {
      context.strokeStyle = colour("text");
      context.beginPath();
      context.arc(x, y, 10 * devicePixelRatio, 0, 2 * Math.PI);
      context.stroke();
    }
    drawShape(context, mark.setting.axis, x, y, markRadius * devicePixelRatio, mark.front);
  }
  drawNames(plot, marks, floor, selected);
  context.restore();
}
