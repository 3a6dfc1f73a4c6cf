// Numbers of a study for people: three significant digits, with their units.

const minus = "\u2212", thin = "\u202f", times = "\u00d7";

function significant(value, digits = 3) {
  if (typeof value !== "number") return absent;
  const text = Math.abs(value) >= 1000 ? Math.round(value).toLocaleString("en") : String(+value.toPrecision(digits));
  return text.replace("-", minus);
}

function timeText(milliseconds) {
  if (typeof milliseconds !== "number") return absent;
  if (milliseconds < 0) return minus + timeText(-milliseconds);
  if (milliseconds < 1) return `${significant(milliseconds * 1000)}${thin}\u00b5s`;
  if (milliseconds < 1000) return `${significant(milliseconds)}${thin}ms`;
  return milliseconds < 60000 ? `${significant(milliseconds / 1000)}${thin}s` : duration(milliseconds / 1000);
}

const ratioText = (value) => (typeof value === "number" ? significant(value) + times : absent);
const withSign = (value, text) => (value > 0 ? "+" : "") + text(value);
const levelsText = (value) => `${significant(value)} ${value === 1 ? "level" : "levels"}`;

// As many decimals as the uncertainty has when it is given with two digits.
function errorText({ rms, uncertainty }) {
  if (!(uncertainty > 0)) return significant(rms);
  const decimals = Math.min(8, Math.max(0, 1 - Math.floor(Math.log10(uncertainty))));
  return `${rms.toFixed(decimals)} \u00b1 ${uncertainty.toFixed(decimals)}`;
}

function bytesText(bytes) {
  if (typeof bytes !== "number") return absent;
  return bytes < 1e6 ? `${significant(bytes / 1024)}${thin}KiB` : `${significant(bytes / 1048576)}${thin}MiB`;
}

const intervalText = (low, high, text) => `${text(low)}\u2013${text(high)}`;
