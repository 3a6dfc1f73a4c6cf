// The large pictures of one result: swiped, blinking, or side by side. `places` has them by role. With `stretch` they
// are shown as large as the largest, whatever their sizes.

const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
const blinkPeriod = 600;  // milliseconds a picture

const roleName = new Map(roles);  // a page's own: [[role, name], ...]

// What the reader chose stays while going from scene to scene.
const viewing = { mode: "swipe", other: roles[1][0], zoom: "fit" };

function otherRole(result) {
  if (result.places[viewing.other]) return viewing.other;
  return roles.map(([role]) => role).slice(1).find((role) => result.places[role]) || null;
}

const stagePicture = (result, role) => picture(result.places[role], roleName.get(role));

// How many pixels of the page a pixel of the picture takes: a whole number, unless the picture must shrink.
function fitScale(frame, images) {
  const most = (key) => Math.max(...images.map((image) => image[key]));
  const height = Math.max(320, innerHeight - 240);
  const scale = Math.min((frame.clientWidth - 2) / most("naturalWidth"), height / most("naturalHeight"));
  return scale < 1 ? scale : Math.min(8, Math.floor(scale));
}

// Side by side they fit by the style sheet alone.
async function applyZoom(frame, stretch) {
  frame.dataset.zoom = viewing.zoom;
  const images = [...frame.querySelectorAll("img")];
  const loaded = (image) => image.complete && image.naturalWidth ||
    new Promise((done) => image.addEventListener("load", done, { once: true }));
  await Promise.all(images.map(loaded));
  const alone = viewing.zoom === "fit" && frame.querySelector(".beside");
  const scale = alone ? null : viewing.zoom === "fit" ? fitScale(frame, images) : Number(viewing.zoom);
  const widest = Math.max(...images.map((image) => image.naturalWidth));
  for (const image of images) image.style.width = scale ? `${(stretch ? widest : image.naturalWidth) * scale}px` : "";
}

function swipeView(result, role) {
  const left = stagePicture(result, "picture"), right = stagePicture(result, role);
  left.slot = "first";
  right.slot = "second";
  const slider = element("img-comparison-slider", { tabindex: "0", role: "slider", "aria-valuemin": 0,
    "aria-valuemax": 100, "aria-valuenow": 50,
    "aria-label": `${roleName.get("picture")} on the left, ${roleName.get(role)} on the right; the arrow keys move the border` }, left, right);
  slider.addEventListener("slide", () => slider.setAttribute("aria-valuenow", Math.round(slider.value)));
  return element("div", { class: "swipe" }, slider,
    element("span", { class: "side left" }, roleName.get("picture")), element("span", { class: "side right" }, roleName.get(role)));
}

// With `swap`, which shows the other picture, and `stop`. Alone it swaps only where motion is welcome.
function blinkView(result, role) {
  const shown = ["picture", role];
  const frame = element("div", { class: "blink", "data-shown": shown[0] },
    ...shown.map((each) => element("div", { "data-role": each }, stagePicture(result, each))));
  const name = element("span", { class: "side left", "aria-live": reducedMotion.matches ? "polite" : "off" }, roleName.get("picture"));
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
  const shownBeside = ([role, name]) => {
    const image = stagePicture(result, role);
    const caption = element("figcaption", {}, name);
    if (role !== "heat") image.addEventListener("load", () => caption.append(`, ${image.naturalWidth} \u00d7 ${image.naturalHeight}`));
    return element("figure", {},
      element("div", { class: "frame" }, image, ...(role === "heat" ? [] : regionMarks(result))), caption);
  };
  return element("div", { class: "beside" }, ...present.map(shownBeside));
}

// Can the pictures lie on one another?
const overlaid = (result) => result.places.picture && result.state !== "size-differs";

function stageView(result) {
  const role = otherRole(result);
  if (!overlaid(result) || !role || viewing.mode === "side") return sideView(result);
  return viewing.mode === "blink" ? blinkView(result, role) : swipeView(result, role);
}
