// The values of the pixel under the pointer, in every picture of the result, as the browser shows them.

// A function (x, y) => [red, green, blue], or null where the browser keeps the values of files to itself. x and y are
// those of a picture that is `width` pixels wide, where that is given.
async function pixelReader(place, width) {
  const image = await decodedPicture(place);
  const canvas = element("canvas", { width: image.naturalWidth, height: image.naturalHeight });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  const share = width ? image.naturalWidth / width : 1;
  const own = (value) => Math.floor((value + 0.5) * share);
  return (x, y) => {
    try {
      return [...context.getImageData(own(x), own(y), 1, 1).data.slice(0, 3)];
    } catch {
      return null;
    }
  };
}

function pixelAt(image, event) {
  const box = image.getBoundingClientRect();
  const x = Math.floor(((event.clientX - box.left) / box.width) * image.naturalWidth);
  const y = Math.floor(((event.clientY - box.top) / box.height) * image.naturalHeight);
  return x >= 0 && y >= 0 && x < image.naturalWidth && y < image.naturalHeight ? [x, y] : null;
}

// A line of text that follows the pointer over `frame`. The pictures are read at its first move.
function pixelProbe(result, frame) {
  const line = element("p", { class: "probe muted" }, "Point at a pixel for its values");
  const readers = new Map();
  const read = (width) => {
    for (const [role, name] of roles) {
      if (role === "heat" || !result.places[role]) continue;
      readers.set(name, null);
      pixelReader(result.places[role], width).then((reader) => readers.set(name, reader), () => {});
    }
  };
  frame.addEventListener("mousemove", (event) => {
    const image = (event.target.closest(".frame") || frame).querySelector("img");
    if (!readers.size) read(result.stretch && image ? image.naturalWidth : null);
    const at = image && image.naturalWidth && pixelAt(image, event);
    if (!at) return;
    const values = [...readers].map(([name, reader]) => [name, reader && reader(...at)]).filter(([, rgb]) => rgb);
    line.textContent = [`x ${at[0]}, y ${at[1]}`, ...values.map(([name, rgb]) => `${name} ${rgb.join(" ")}`)].join(" \u00b7 ");
  });
  return line;
}
