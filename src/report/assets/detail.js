// One result, over the page. It is open while the page's address names it.

const detail = document.getElementById("detail");
let opened = null;  // the result

function otherRenderers(result) {
  if (!severalRenderers) return null;
  const same = results.filter((each) => each.scene === result.scene);
  const link = (each) => element("a", { href: addressOf(each), "aria-current": each === result ? "true" : null },
    icon(each.failed ? "fail" : "pass"), each.renderer);
  return element("nav", { class: "renderers", "aria-label": "Renderers" }, ...same.map(link));
}

function detailHead(result) {
  const failures = failuresInOrder();
  const at = failures.indexOf(result);
  const place = at < 0 ? count(failures.length, "failure") : `${at + 1} of ${count(failures.length, "failure")}`;
  return element("header", {},
    element("h2", { id: "detail-name", tabindex: "-1" }, badge(result), " ", result.scene),
    element("div", { class: "tools" },
      failures.length ? element("span", { class: "muted" }, place) : null,
      failures.length ? button("Previous", () => stepFailure(-1), { "aria-keyshortcuts": "p", title: "Previous failure (p)" }) : null,
      failures.length ? button("Next", () => stepFailure(1), { "aria-keyshortcuts": "n", title: "Next failure (n)" }) : null,
      button("Close", closeDetail, { "aria-keyshortcuts": "Escape" })));
}

function explanations(result) {
  const { explanation, reason, message } = result;
  return [
    explanation ? element("p", { class: "diagnosis" }, explanation[0].toUpperCase() + explanation.slice(1)) : null,
    reason ? element("p", { class: "reason" }, reason) : null,
    message ? element("pre", { class: "message", tabindex: "0" }, message.replace(/\n$/, "")) : null,
  ].filter((part) => part);
}

function fillDetail(result) {
  if (stage) stage.close();
  stage = null;
  const pictures = Object.keys(result.places).length
    ? openStage(result)
    : element("p", { class: "pictures muted" }, "There is no picture.");
  detail.replaceChildren(detailHead(result), otherRenderers(result) || "",
    element("div", { class: "body" },
      element("div", { class: "main" }, ...explanations(result), pictures, cropsSection(result) || ""),
      factsSection(result)));
  detail.scrollTop = 0;
}

function showDetail(result) {
  opened = result;
  fillDetail(result);
  if (!detail.open) detail.showModal();
  document.getElementById("detail-name").focus();
}

function closeDetail() {
  if (detail.open) detail.close();
}

// However it was closed, by Escape too: the address no longer names it, and its row is where one was.
// Unless by now another has been asked for.
detail.addEventListener("close", () => {
  if (detail.open) return;
  if (stage) stage.close();
  stage = null;
  detail.replaceChildren();
  if (opened && location.hash === addressOf(opened))
    history.replaceState(null, "", location.pathname + location.search);
  const link = opened && document.querySelector(`#results a[href="${CSS.escape(addressOf(opened))}"]`);
  opened = null;
  if (link) link.focus();
});

function followAddress() {
  const result = resultsByAddress.get(location.hash);
  if (result && result === opened) return;
  if (result) showDetail(result);
  else if (opened) closeDetail();
}
