"""The results in all their forms."""
import dataclasses
import json

from . import tables


@dataclasses.dataclass
class Report:
    machine: dict          # what it is measured on, by name
    rows: list
    quick: bool = False
    against: str = ""      # the build that ours is compared with, instead of anchors

    def plain(self):
        """The rows that are in the main table."""
        return [row for row in self.rows if self.against or not row.place]

    def text(self):
        return self._tables(tables.aligned, lambda axis: f"\nGrowth with {axis}:\n") + self.summary() + "\n"

    def markdown(self):
        machine = "".join(f"- {name}: {value}\n" for name, value in self.machine.items())
        heading = "## {}\n\n" if not self.against else "## Against " + self.against + "\n\n"
        return (machine + "\n" + heading.format("Stages")
                + self._tables(tables.markdown, lambda axis: f"\n### Growth with {axis}\n\n")
                + f"\n{self.summary()}\n")

    def _tables(self, form, title):
        if self.against:
            return form(tables.HEADS_AGAINST, [tables.cells_against(row) for row in self.plain()])
        text = form(tables.HEADS, [tables.cells(row) for row in self.plain()]) if self.plain() else ""
        return text + "".join(title(axis) + form(heads, lines) for axis, heads, lines in tables.growth(self.rows))

    def summary(self):
        if self.against:
            worse = [row for row in self.rows if tables.change(row) == "WORSE"]
            return f"{len(worse)} of {len(self.rows)} figures are worse than those of {self.against}."
        if self.quick:
            return "Only tried: the figures mean nothing."
        judged = [row for row in self.rows if row.met is not None]
        return f"{sum(row.met for row in judged)} of {len(judged)} goals met."

    def json(self):
        rows = [dataclasses.asdict(row) for row in self.rows]
        growth = [{"axis": axis, "heads": heads, "lines": lines} for axis, heads, lines in tables.growth(self.rows)]
        return json.dumps({"format": "trace-bench-1", "machine": self.machine, "quick": self.quick,
                           "against": self.against, "rows": rows, "growth": growth}, indent=2) + "\n"
