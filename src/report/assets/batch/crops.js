// The worst regions, enlarged pixel by pixel.

const cropLeast = 16, cropMost = 56;  // pixels of the picture along an edge
const cropScreen = 224;               // wanted size on the page

// A square around the region; of a large one, the part around its largest difference or its middle.
function cropBox(region, measured) {
  const { largest, width, height } = measured;
  const inside = largest && largest.x >= region.x0 && largest.x < region.x1 && largest.y >= region.y0 && largest.y < region.y1;
  const longest = Math.max(region.x1 - region.x0, region.y1 - region.y0) + 4;
  const side = Math.min(Math.max(longest, cropLeast), cropMost, width, height);
  const large = longest > cropMost;
  const middle = large && inside ? [largest.x, largest.y] : [(region.x0 + region.x1) / 2, (region.y0 + region.y1) / 2];
  const clamp = (centre, limit) => Math.round(Math.min(Math.max(centre - side / 2, 0), limit - side));
  return { x: clamp(middle[0], width), y: clamp(middle[1], height), side };
}

// Whole multiples of pixels, at least four, without smoothing.
function cropCanvas(place, box, name) {
  const scale = Math.max(4, Math.floor(cropScreen / box.side));
  const size = box.side * scale;
  const canvas = element("canvas", { width: size, height: size, role: "img", "aria-label": name });
  decodedPicture(place).then((image) => {
    const context = canvas.getContext("2d");
    context.imageSmoothingEnabled = false;
    context.drawImage(image, box.x, box.y, box.side, box.side, 0, 0, size, size);
    canvas.dataset.drawn = scale;
  }, (error) => canvas.replaceWith(pictureNote(`${name}: ${error.message}`)));
  return canvas;
}

function regionFigure(result, region, index) {
  const box = cropBox(region, result.measured);
  const present = roles.filter(([role]) => result.places[role]);
  const where = `x ${region.x0}\u2013${region.x1 - 1}, y ${region.y0}\u2013${region.y1 - 1}`;
  const shown = ([role, name]) => element("figure", {},
    cropCanvas(result.places[role], box, `${name}, region ${index + 1}`), element("figcaption", {}, name));
  return element("section", { class: "crop" },
    element("h4", {}, `Region ${index + 1}`),
    element("p", { class: "muted" },
      `${where}: ${count(region.pixels, "pixel")} off, RMSE ${figure(region.root_mean_square)}; ` +
      `shown from ${box.x}, ${box.y}, ${box.side} pixels wide`),
    element("div", { class: "crop-row" }, ...present.map(shown)));
}

function cropsSection(result) {
  const { measured } = result;
  const regions = (measured && measured.worst) || [];
  if (!regions.length || !result.places.picture) return null;
  return element("section", { class: "crops" }, element("h3", {}, "Worst regions"),
    ...regions.map((region, index) => regionFigure(result, region, index)));
}
