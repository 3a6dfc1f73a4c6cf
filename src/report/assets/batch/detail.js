// What the dialog shows of one result.

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
      failures.length ? button("Previous", () => stepThrough(failuresInOrder(), -1), { "aria-keyshortcuts": "p", title: "Previous failure (p)" }) : null,
      failures.length ? button("Next", () => stepThrough(failuresInOrder(), 1), { "aria-keyshortcuts": "n", title: "Next failure (n)" }) : null,
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
  const pictures = Object.keys(result.places).length
    ? openStage(result)
    : element("p", { class: "pictures muted" }, "There is no picture.");
  detail.replaceChildren(detailHead(result), otherRenderers(result) || "",
    element("div", { class: "body" },
      element("div", { class: "main" }, ...explanations(result), pictures, cropsSection(result) || ""),
      factsSection(result)));
  detail.scrollTop = 0;
}
