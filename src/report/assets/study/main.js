// The parts of the page, and the start.

buildHeader();
document.getElementById("charts").append(...[overallFigure(), claimsSection()].filter((part) => part));
document.getElementById("results").append(settingsSection(), scenesSection());
addEventListener("hashchange", followAddress);
followAddress();
