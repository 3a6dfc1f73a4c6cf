"""One row of the results: what came of one line of a group."""
import dataclasses

from . import samples
from .group import Place, ratio


@dataclasses.dataclass
class Row:
    stage: str
    what: str
    unit: str
    ours: float | None
    anchor: float | None
    ratio: float | None        # ours / anchor, the median of the rounds
    spread: float | None       # of that: the middle half of the rounds, as a part of it
    more_is_better: bool
    goal: str = ""             # empty: none is set
    met: bool | None = None    # None: no goal, or nothing to judge by
    reach: float | None = None # how many times as good as the goal asks for
    note: str = ""             # why something is missing
    digits: int = 1
    place: Place | None = None


def rows_of(group, measured, judged=True):
    """With `judged`, by the goals."""
    return [_row(group, line, measured.ours.get(line.key), measured.others.get(line.key), judged)
            for line in group.lines]


def _row(group, line, ours, others, judged):
    row = Row(group.stage, line.what, line.unit, samples.median(ours) if ours else None,
              samples.median(others) if others else None, *ratio(ours, others), line.more_is_better,
              line.goal.text(line.unit), digits=line.digits, place=line.place)
    if row.ours is None:
        row.note = "not in this build"
        return row
    if row.anchor is None and row.goal and (group.missing or group.anchor):
        row.note = f"no anchor: {group.missing}" if group.missing else "no anchor"
    if not judged:
        return row
    # The ratio of rounds is less disturbed than that of medians.
    anchor = row.ours / row.ratio if row.ratio else None
    row.reach = line.goal.reach(row.ours, anchor) if row.ours > 0 else None
    if row.reach is not None:
        row.met = row.reach >= 1
    return row


def failed_row(stage, problem):
    return Row(stage, "", "", None, None, None, None, False, note=f"failed: {problem}")
