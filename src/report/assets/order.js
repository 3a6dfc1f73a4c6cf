// How values are sorted: names as people do, what is absent last either way.

const nameOrder = new Intl.Collator("en", { numeric: true });

function compareValues(a, b, descending) {
  const none = (value) => value === null || value === undefined;
  if (none(a) || none(b)) return none(a) - none(b);
  const order = typeof a === "string" ? nameOrder.compare(a, b) : a - b;
  return descending ? -order : order;
}
