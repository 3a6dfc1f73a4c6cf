// The large pictures of one result: swiped, blinking, or side by side.

const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
const blinkPeriod = 600;  // milliseconds a picture

// What the reader chose stays while going from scene to scene.
const viewing = { mode: "swipe", other: "solution", zoom: "fit" };

function otherRole(result) {
  if (result.places[viewing.other]) return viewing.other;
  return ["solution", "heat"].find((role) => result.places[role]) || null;
}

const stagePicture = (result, role) => picture(result.places[role], roleName.get(role));

// Zoom 2 makes each pixel of the picture two of the page.
function applyZoom(frame) {
  frame.dataset.zoom = viewing.zoom;
  for (const image of frame.querySelectorAll("img")) {
    const size = () => {
      const width = viewing.zoom === "fit" ? "" : `${image.naturalWidth * Number(viewing.zoom)}px`;
      image.style.width = width;
      image.style.maxWidth = width ? "none" : "";
    };
    if (image.naturalWidth) size();
    else image.addEventListener("load", size);
  }
}

function swipeView(result, role) {
  const left = stagePicture(result, "picture"), right = stagePicture(result, role);
  left.slot = "first";
  right.slot = "second";
  const slider = element("img-comparison-slider", { tabindex: "0", role: "slider", "aria-valuemin": 0,
    "aria-valuemax": 100, "aria-valuenow": 50,
    "aria-label": `Ours on the left, ${roleName.get(role)} on the right; the arrow keys move the border` }, left, right);
  slider.addEventListener("slide", () => slider.setAttribute("aria-valuenow", Math.round(slider.value)));
  return element("div", { class: "swipe" }, slider,
    element("span", { class: "side left" }, "Ours"), element("span", { class: "side right" }, roleName.get(role)));
}

// With `swap`, which shows the other picture, and `stop`. Alone it swaps only where motion is welcome.
function blinkView(result, role) {
  const shown = ["picture", role];
  const frame = element("div", { class: "blink", "data-shown": shown[0] },
    ...shown.map((each) => element("div", { "data-role": each }, stagePicture(result, each))));
  const name = element("span", { class: "side left", "aria-live": reducedMotion.matches ? "polite" : "off" }, "Ours");
  const swap = () => {
    shown.reverse();
    frame.dataset.shown = shown[0];
    name.textContent = roleName.get(shown[0]);
  };
  const timer = reducedMotion.matches ? null : setInterval(swap, blinkPeriod);
  frame.addEventListener("click", swap);
  const view = element("div", {}, frame, name);
  view.swap = swap;
  view.stop = () => clearInterval(timer);
  return view;
}

function regionMarks(result) {
  const { measured } = result;
  if (!measured) return [];
  const share = (value, whole) => `${(100 * value) / whole}%`;
  return (measured.worst || []).map((region, index) => {
    const mark = element("span", { class: "region", "aria-hidden": "true" }, String(index + 1));
    mark.style.left = share(region.x0, measured.width);
    mark.style.top = share(region.y0, measured.height);
    mark.style.width = share(region.x1 - region.x0, measured.width);
    mark.style.height = share(region.y1 - region.y0, measured.height);
    return mark;
  });
}

function sideView(result) {
  const present = roles.filter(([role]) => result.places[role]);
  const shownBeside = ([role, name]) => element("figure", {},
    element("div", { class: "frame" }, stagePicture(result, role), ...(role === "heat" ? [] : regionMarks(result))),
    element("figcaption", {}, name));
  return element("div", { class: "beside" }, ...present.map(shownBeside));
}

function stageView(result) {
  const role = otherRole(result);
  if (!result.places.picture || !role || viewing.mode === "side") return sideView(result);
  return viewing.mode === "blink" ? blinkView(result, role) : swipeView(result, role);
}
