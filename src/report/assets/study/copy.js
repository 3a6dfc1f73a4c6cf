// Text with a button that copies it.

async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {  // a browser that keeps the clipboard from pages
    const field = element("textarea", { class: "hidden" });
    field.value = text;
    (document.querySelector("dialog[open]") || document.body).append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
}

function copyable(text) {
  if (!text) return element("span", { class: "muted" }, "no options");
  const copy = button("Copy", async () => {
    await copyText(text);
    copy.textContent = "Copied";
    setTimeout(() => (copy.textContent = "Copy"), 1500);
  }, { class: "copy", "aria-label": `Copy ${text}` });
  return element("span", { class: "copyable" }, element("code", {}, text), copy);
}
