// Dark or light: as the system says unless the reader chose. The choice is remembered where the browser lets
// a page from disk do that.

const themeChanged = new Set();  // functions to call
const systemDark = matchMedia("(prefers-color-scheme: dark)");

function chosenTheme() {
  try {
    return localStorage.getItem("trace-theme") || "system";
  } catch {
    return "system";
  }
}

function applyTheme(choice) {
  const dark = choice === "dark" || (choice !== "light" && systemDark.matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  for (const changed of themeChanged) changed();
}

function chooseTheme(choice) {
  try {
    localStorage.setItem("trace-theme", choice);
  } catch {
    // It holds until the page is closed.
  }
  applyTheme(choice);
}

function themeChoice() {
  const choices = [["system", "Auto"], ["light", "Light"], ["dark", "Dark"]];
  return choice("Colours", choices, chosenTheme(), chooseTheme);
}

// The value of a colour of base.css now, for drawing on a canvas.
function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

systemDark.addEventListener("change", () => applyTheme(chosenTheme()));
matchMedia("print").addEventListener("change", () => applyTheme(chosenTheme()));  // what is drawn gets the colours of paper
applyTheme(chosenTheme());
