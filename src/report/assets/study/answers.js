// For an error below a limit the fastest setting is ...

function answerRow(scene, head, below, choose) {
  const best = fastestBelow(scene, below);
  return element("tr", {}, element("th", { scope: "row" }, head),
    element("td", {}, best ? settingButton(best.setting, choose) : "none measured"),
    element("td", { class: "number" }, best ? timeText(best.ms.median) : ""),
    element("td", { class: "number" }, best ? errorText(best.error) : ""));
}

function answersTable(scene, choose) {
  const field = limitField();
  const head = element("span", {}, "below ", field);
  const typed = element("tbody", { class: "typed" }), given = element("tbody");
  const show = () => typed.replaceChildren(answerRow(scene, head, wish.below, choose));
  show();
  const end = followLimit(field, () => {
    const focused = document.activeElement === field, at = field.selectionStart;
    show();
    if (!focused) return;
    field.focus();
    field.setSelectionRange(at, at);
  });
  given.append(...scene.fastest.map(({ below }) => answerRow(scene, `below ${significant(below)}`, below, choose)));
  const table = element("table", { class: "figures answers" },
    element("caption", {}, "The fastest setting for an error, in levels of 255; the first limit may be typed"),
    element("thead", {}, element("tr", {}, ...["Error", "Setting", "Time", "Its error"].map((name) => element("th", { scope: "col" }, name)))),
    typed, given);
  table.stop = end;
  return table;
}
