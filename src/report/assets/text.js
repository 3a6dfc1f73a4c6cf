// Numbers and words for people.

const absent = "\u2013";

// With so many decimals; what is not zero does not look like zero.
function figure(value, decimals = 2) {
  if (value === null || value === undefined) return absent;
  if (value === 0) return "0";
  const least = 10 ** -decimals;
  if (Math.abs(value) < least / 2) return (value < 0 ? "> -" : "< ") + least.toFixed(decimals);
  return value.toFixed(decimals);
}

// Levels, which are mostly whole.
const level = (value) => figure(value, Number.isInteger(value) ? 0 : 2);
const percent = (value) => (typeof value === "number" ? `${figure(value)}\u202f%` : absent);
const decibel = (value) => (typeof value === "number" ? figure(value, 1) : "\u221e");

function duration(seconds) {
  if (typeof seconds !== "number") return absent;
  if (seconds < 0.0095) return `${figure(seconds * 1000, 1)}\u202fms`;
  if (seconds < 0.9995) return `${Math.round(seconds * 1000)}\u202fms`;
  if (seconds < 59.95) return `${seconds.toFixed(1)}\u202fs`;
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}\u202fmin ${whole % 60}\u202fs`;
}

function count(number, singular, plural = `${singular}s`) {
  return `${number.toLocaleString("en")} ${number === 1 ? singular : plural}`;
}

// When a report was begun, in the reader's time; null where that is no date.
function startedText(started) {
  const date = new Date(started);
  return isNaN(date) ? null : date.toLocaleString("en-GB", { dateStyle: "medium", timeStyle: "short" });
}
