"""The results as text: aligned for a terminal, or as Markdown."""
from . import samples

HEADS = ("stage", "what", "ours", "anchor", "ratio", "goal", "met")
HEADS_AGAINST = ("stage", "what", "before", "now", "now / before", "spread", "change")
NOTABLE = 0.03  # smaller changes are not called any


def figure(value, digits, unit=""):
    if value is None:
        return "-"
    return f"{value:.{digits}f} {unit}".rstrip()


def verdict(row):
    return {True: "yes", False: "no", None: row.note or "-"}[row.met]


def cells(row):
    return (row.stage, row.what, figure(row.ours, row.digits, row.unit), figure(row.anchor, row.digits),
            figure(row.ratio, 2), row.goal or "-", verdict(row))


def change(row):
    """What a ratio of two builds means: a change that is larger than the runs differ by. Too few tell nothing."""
    if row.ratio is None or row.spread is None:
        return row.note or "-"
    if abs(row.ratio - 1) <= max(NOTABLE, row.spread):
        return "same"
    return "better" if (row.ratio > 1) == row.more_is_better else "WORSE"


def cells_against(row):
    return (row.stage, row.what, figure(row.anchor, row.digits, row.unit), figure(row.ours, row.digits),
            figure(row.ratio, 3), "-" if row.spread is None else f"{100 * row.spread:.0f} %", change(row))


def aligned(heads, lines):
    widths = [max(len(line[i]) for line in (heads, *lines)) for i in range(len(heads))]
    return "".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() + "\n"
                   for line in (heads, tuple("-" * width for width in widths), *lines))


def markdown(heads, lines):
    return "".join(f"| {' | '.join(line)} |\n" for line in (heads, ("---",) * len(heads), *lines))


def growth(rows):
    """Of the rows that have a place: (axis, heads, lines) of each axis, with the exponents of the power laws that fit
    them in the last line."""
    axes = dict.fromkeys(row.place.axis for row in rows if row.place and row.ours is not None)
    for axis in axes:
        here = [row for row in rows if row.place and row.place.axis == axis and row.ours is not None]
        quantities = {row.place.quantity: row.unit for row in here}
        lines = []
        for label in dict.fromkeys(row.place.label for row in here):
            of = {row.place.quantity: row for row in here if row.place.label == label}
            lines.append((label, *(figure(of[q].ours, of[q].digits) if q in of else "-" for q in quantities)))
        exponents = [samples.exponent([(row.place.amount, row.ours) for row in here if row.place.quantity == q])
                     for q in quantities]
        lines.append(("exponent", *("-" if e is None else f"{e:.2f}" for e in exponents)))
        yield axis, (axis, *(f"{q} ({unit})" for q, unit in quantities.items())), lines
