"""The results in all their forms."""
import dataclasses
import json
import math
import statistics

from . import tables


@dataclasses.dataclass
class Report:
    machine: dict          # what it is measured on, by name
    rows: list
    quick: bool = False
    against: str = ""      # the build that ours is compared with, instead of anchors

    def text(self):
        machine = "".join(f"{name}: {value}\n" for name, value in self.machine.items())
        return machine + "".join(f"\n{title}\n{text}" for title, text in self.parts(tables.aligned)) + (
            f"\n{self.summary()}\n")

    def parts(self, form):
        """Titles and tables: the stages, and the growth along each axis."""
        if self.against:
            yield f"against {self.against}", form(tables.HEADS_AGAINST, [tables.cells_against(r) for r in self.rows])
            return
        stages = [row for row in self.rows if not row.place]
        if stages:
            yield "stages", form(tables.HEADS, [tables.cells(row) for row in stages])
        for axis, heads, lines in tables.growth(self.rows):
            yield f"growth with {axis}", form(heads, lines)

    def summary(self):
        if self.quick:
            return "Only tried: the figures mean nothing."
        if self.against:
            changes = [tables.change(row) for row in self.rows]
            counts = ", ".join(f"{changes.count(word)} {word}" for word in ("better", "same", "WORSE"))
            return f"Against {self.against}: {counts}. {self._means()}"
        judged = [row for row in self.rows if row.met is not None]
        return f"{sum(row.met for row in judged)} of {len(judged)} goals met."

    def _means(self):
        """How many times as good each stage is, as the geometric mean of its figures."""
        means = []
        for stage in dict.fromkeys(row.stage for row in self.rows):
            logs = [math.log(row.ratio if row.more_is_better else 1 / row.ratio)
                    for row in self.rows if row.stage == stage and row.ratio]
            if logs:
                means.append(f"{stage} {math.exp(statistics.fmean(logs)):.3f}")
        return "Times as good, geometric means: " + ", ".join(means) + "." if means else ""

    def json(self):
        rows = [dataclasses.asdict(row) for row in self.rows]
        growth = [{"axis": axis, "heads": heads, "lines": lines} for axis, heads, lines in tables.growth(self.rows)]
        return json.dumps({"format": "trace-bench-1", "machine": self.machine, "quick": self.quick,
                           "against": self.against, "summary": self.summary(), "rows": rows, "growth": growth},
                          indent=2) + "\n"
