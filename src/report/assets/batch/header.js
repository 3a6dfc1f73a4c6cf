// The top of the page: what was done and how it went.

function headline() {
  const failures = results.filter((result) => result.failed).length;
  if (results.length === 0) return ["none", "No scenes"];
  if (failures && results.length === 1) return ["fail", "The only result fails"];
  if (failures) return ["fail", `${failures} of ${count(results.length, "result")} ${failures === 1 ? "fails" : "fail"}`];
  return ["pass", results.length === 1 ? "The only result passes" : `All ${count(results.length, "result")} pass`];
}

function factLine() {
  const scenes = new Set(results.map((result) => result.scene)).size;
  const facts = [count(scenes, "scene"), severalRenderers ? count(renderers.length, "renderer") : null,
    duration(report.seconds), startedText(report.started)];
  return element("p", { class: "facts" }, facts.filter((fact) => fact).join(" \u00b7 "));
}

// Each state that occurs, as a button that leaves only its results in the list.
function verdictChips(chosen) {
  const tally = new Map();
  for (const result of results) tally.set(result.state, (tally.get(result.state) || 0) + 1);
  const failures = results.filter((result) => result.failed).length;
  const choices = [["all", `All ${results.length}`]];
  if (failures) choices.push(["failures", `Failures ${failures}`]);
  const found = [...tally].sort((a, b) => (ranks.get(a[0]) ?? 0) - (ranks.get(b[0]) ?? 0));
  if (found.length > 1)
    for (const [state, number] of found) choices.push([state, `${states.get(state) || state} ${number}`]);
  const chips = choice("Verdict", choices, "all", chosen);
  chips.classList.add("chips");
  for (const chip of chips.children) {
    const state = chip.dataset.value;
    if (state === "all") continue;
    const fails = !passing.has(state);
    chip.classList.toggle("fails", fails);
    chip.prepend(icon(fails ? "fail" : "pass"));
  }
  return chips;
}

function buildHeader() {
  const [mark, text] = headline();
  document.getElementById("top").append(
    element("div", { class: "title" },
      element("h1", {}, report.title || "Renderings"),
      element("div", { class: "tools" }, themeChoice(), button("Keys", openHelp, { "aria-keyshortcuts": "?" }))),
    element("p", { class: `headline ${mark}` }, icon(mark), text),
    factLine(),
    report.command ? element("p", { class: "command" }, element("code", {}, report.command)) : "",
    report.interrupted ? element("p", { class: "notice" }, "The batch was interrupted: some scenes are not here.") : "");
}
