// The keyboard, and the help that tells of it. A page has keyHelp, [[key, text], ...], and keyActions, {key: function}.

const help = document.getElementById("help");

function openHelp() {
  help.replaceChildren(
    element("h2", { id: "help-name" }, "Keys"),
    element("dl", {}, ...keyHelp.flatMap(([key, text]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, text)])),
    button("Close", () => help.close()));
  if (!help.open) help.showModal();
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || help.open) return;
  if (event.target.closest("input, select, textarea")) return;
  const action = keyActions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});
