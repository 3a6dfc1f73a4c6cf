// The keyboard, and the help that tells of it. A page has keyHelp, [[key, text], ...], and keyActions, {key: function}.

const help = document.getElementById("help");

function openHelp() {
  help.replaceChildren(
    element("h2", { id: "help-name" }, "Keys"),
    element("dl", {}, ...keyHelp.flatMap(([key, text]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, text)])),
    button("Close", () => help.close()));
  if (!help.open) help.showModal();
}

// From the open one of these to the next, or into them; around at their ends.
function stepThrough(items, step) {
  if (!items.length) return;
  const at = items.indexOf(opened);
  const next = at < 0 ? (step > 0 ? 0 : items.length - 1) : (at + step + items.length) % items.length;
  location.hash = addressOf(items[next]);
  followAddress();  // now, for the next key
}

function focusFilter() {
  closeDetail();
  const field = document.getElementById("filter-text");
  field.focus();
  field.select();
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || help.open) return;
  if (event.target.closest("input, select, textarea")) return;
  const action = keyActions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});
