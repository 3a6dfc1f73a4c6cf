"""What is measured together, and the rounds in which it is."""
import dataclasses
from collections.abc import Callable

from . import goals, samples


@dataclasses.dataclass
class Line:
    """One line of the table: which of a group's values, and what they have to be."""
    key: str
    what: str
    unit: str
    goal: goals.Goal = goals.NONE
    more_is_better: bool = False
    digits: int = 1
    place: "Place | None" = None


@dataclasses.dataclass(frozen=True)
class Place:
    """Where a value stands in a table of growth: at `label`, which is `amount` along `axis`."""
    axis: str
    amount: float
    label: str
    quantity: str


@dataclasses.dataclass
class Group:
    """`sample` runs a build (building.Build) once, `anchor` the others; both give values by key."""
    stage: str
    sample: Callable
    lines: list
    anchor: Callable | None = None
    rounds: int = 5
    missing: str = ""  # why there is no anchor
    of_process: bool = False  # needs the program trace alone, not bench_kernels of the build


@dataclasses.dataclass
class Measured:
    ours: dict
    others: dict


def in_turns(group, build, other, quick):
    """Medians of `build` and of the other side, an anchor or a build, round by round. Who goes first changes."""
    if not group.of_process and other is not None and not other.kernels:
        return Measured({}, {})
    ours, others = [], []
    sides = [(lambda: group.sample(build), ours)]
    if other is not None:
        sides.append((lambda: group.sample(other), others))
    elif group.anchor:
        sides.append((group.anchor, others))
    for number in range(1 if quick else group.rounds):
        for measure, results in sides if number % 2 == 0 else sides[::-1]:
            results.append(measure())
    return Measured(by_key(ours), by_key(others))


def by_key(results):
    """The values of all rounds of each key."""
    return {key: [result[key] for result in results if key in result] for result in results for key in result}


def ratio(ours, others):
    """Median of the rounds' ratios, and their spread; None where there is nothing to compare."""
    ratios = [a / b for a, b in zip(ours or (), others or ()) if b]
    return (samples.median(ratios), samples.spread(ratios)) if ratios else (None, None)
