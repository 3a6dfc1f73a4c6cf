// Pictures of the report as <img>. Nothing is decoded before it is to be seen.

const urls = new Map();  // of embedded pictures, by number

const documentRead = new Promise((done) => {
  if (document.readyState !== "loading") done();
  else document.addEventListener("DOMContentLoaded", done);
});

async function embeddedUrl(id) {
  const find = () => document.getElementById(`picture-${id}`);
  // The end of an element that is still being read may be missing.
  if (!find() || !find().nextElementSibling) await documentRead;
  const data = find();
  if (!data) throw new Error("it is not in this file");
  if (data.dataset.error) throw new Error(data.dataset.error);
  const text = atob(data.textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return URL.createObjectURL(new Blob([bytes], { type: "image/png" }));
}

// A promise of an address for <img>; it fails with the reason.
function pictureUrl(place) {
  if (!place) return Promise.reject(new Error("there is none"));
  if (place.href !== undefined) return Promise.resolve(place.href);
  if (!urls.has(place.id)) urls.set(place.id, embeddedUrl(place.id));
  return urls.get(place.id);
}

const pictureNote = (text) => element("span", { class: "no-picture" }, icon("none"), text);

// An <img> that fills itself. Where that fails, the reason stands in its place.
function picture(place, alt) {
  const image = element("img", { alt, decoding: "async", draggable: "false" });
  const fail = (reason) => image.replaceWith(pictureNote(`${alt}: ${reason}`));
  image.addEventListener("error", () => fail("cannot be shown"));
  pictureUrl(place).then((url) => (image.src = url), (error) => fail(error.message));
  return image;
}

// The same picture decoded, for drawing; a promise that fails with the reason.
async function decodedPicture(place) {
  const image = new Image();
  image.src = await pictureUrl(place);
  await image.decode();
  return image;
}

const whenNear = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    whenNear.unobserve(target);
    target.fill();
  }
}, { rootMargin: "300px" });

// A small picture that is made when it comes near the window.
function thumbnail(place, alt) {
  const frame = element("span", { class: "thumb" });
  frame.fill = () => {
    const image = element("img", { alt, title: alt, decoding: "async" });
    image.addEventListener("error", () => frame.classList.add("broken"));
    pictureUrl(place).then((url) => (image.src = url), () => frame.classList.add("broken"));
    frame.append(image);
  };
  whenNear.observe(frame);
  return frame;
}
