// A shape and a colour for each axis: who does not see the colours has the shapes.

// Around the origin, about 1 in radius, as paths of SVG.
const shapes = [
  "M1 0A1 1 0 1 1-1 0A1 1 0 1 1 1 0Z",
  "M-.87-.87H.87V.87H-.87Z",
  "M0-1.15 1.05 .8H-1.05Z",
  "M0-1.2 1.2 0 0 1.2-1.2 0Z",
  "M0 1.15 1.05-.8H-1.05Z",
  "M-.4-1.1H.4V-.4H1.1V.4H.4V1.1H-.4V.4H-1.1V-.4H-.4Z",
  "M-.55-1H.55L1.1 0 .55 1H-.55L-1.1 0Z",
  "M0-1.25 .37-.38 1.25-.35 .55 .22 .78 1.1 0 .6-.78 1.1-.55 .22-1.25-.35-.37-.38Z",
  "M-1-.6-.6-1 0-.4 .6-1 1-.6 .4 0 1 .6 .6 1 0 .4-.6 1-1 .6-.4 0Z",
  "M0-1.2 1.14-.37 .71 .97-.71 .97-1.14-.37Z",
];

const shapeOf = (axis) => shapes[axis.index % shapes.length];
const colourOf = (axis) => colour(`axis-${axis.index % shapes.length}`);

// The mark beside a word.
function axisMark(axis, hollow = false) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "-1.5 -1.5 3 3");
  svg.setAttribute("class", `mark axis-${axis.index % shapes.length}${hollow ? " hollow" : ""}`);
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", shapeOf(axis));
  svg.append(path);
  return svg;
}
