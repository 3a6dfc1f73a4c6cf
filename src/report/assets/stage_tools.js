// The stage with its tools: how to compare, with what, how large.

let stage = null;  // of the result that is open: {blink, close, fit}

function openStage(result) {
  const frame = element("div", { class: "stage" });
  let view = null;
  const close = () => view && view.stop && view.stop();
  const show = () => {
    close();
    view = stageView(result);
    frame.dataset.mode = viewing.mode;
    frame.replaceChildren(view);
    applyZoom(frame, result.stretch);
  };

  const setMode = (mode) => {
    viewing.mode = mode;
    modes.show(mode);
    show();
  };
  // Blinks, or stops. Where motion is not welcome each call swaps the pictures by hand.
  const blink = () => {
    if (viewing.mode !== "blink") setMode("blink");
    else if (reducedMotion.matches && view.swap) view.swap();
    else setMode("swipe");
  };
  const choices = [["swipe", "Swipe"], ["blink", "Blink"], ["side", "Side by side"]];
  const modes = choice("Comparison", choices, viewing.mode, setMode);
  modes.children[1].setAttribute("aria-keyshortcuts", "b");

  const others = roles.slice(1).filter(([role]) => result.places[role]);
  const other = choice("Compare with", others, otherRole(result), (role) => {
    viewing.other = role;
    show();
  });
  const zoom = selection("Size", [["fit", "Fit"], ["1", "1\u00d7"], ["2", "2\u00d7"], ["4", "4\u00d7"], ["8", "8\u00d7"]],
    viewing.zoom, (value) => {
      viewing.zoom = value;
      applyZoom(frame, result.stretch);
    });

  requestAnimationFrame(show);  // when the frame is in the page and has a width
  stage = { blink, close, fit: () => applyZoom(frame, result.stretch) };
  const comparable = overlaid(result) && others.length;
  return element("div", { class: "pictures" },
    element("div", { class: "bar" }, comparable ? modes : null, comparable && others.length > 1 ? other : null, zoom),
    frame, pixelProbe(result, frame));
}

addEventListener("resize", () => stage && stage.fit());
