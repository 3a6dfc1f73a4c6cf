// The top of the page: what was measured, on what, when.

function buildHeader() {
  const machine = report.machine || {};
  const facts = [report.program, machine.processor, machine.threads && count(machine.threads, "thread"), machine.instruction_set];
  const run = [startedText(report.started), `measured for ${duration(report.seconds)}`];
  const line = (parts) => element("p", { class: "facts" }, parts.filter((part) => part).join(" \u00b7 "));
  document.getElementById("top").append(
    element("div", { class: "title" },
      element("h1", {}, `Study: ${report.title}`),
      element("div", { class: "tools" }, themeChoice(), button("Keys", openHelp, { "aria-keyshortcuts": "?" }))),
    element("p", { class: "headline" }, `Time and error of ${count(settings.length, "setting")} on ${count(scenes.length, "scene")}`),
    line(run), line(facts),
    report.command ? element("p", { class: "command" }, element("code", {}, report.command)) : "");
}
