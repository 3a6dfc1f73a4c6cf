"""The goals, all in one place. Ratios are ours / anchor, as the table shows them."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Goal:
    """Met where every limit that is given is kept; the ones on ratios count only where there is an anchor."""
    least: float | None = None         # of our value
    most: float | None = None
    least_ratio: float | None = None
    most_ratio: float | None = None
    most_beyond: float | None = None   # of our value minus the anchor's
    note: str = ""                     # instead of the text made from the limits

    def reach(self, ours, anchor):
        """1 and more where it is met: how many times as good as it has to be. None where nothing can be told."""
        parts = []
        if self.least is not None:
            parts.append(ours / self.least)
        if self.most is not None:
            parts.append(self.most / ours)
        if anchor:
            if self.least_ratio is not None:
                parts.append(ours / anchor / self.least_ratio)
            if self.most_ratio is not None:
                parts.append(self.most_ratio / (ours / anchor))
            if self.most_beyond is not None:
                parts.append((anchor + self.most_beyond) / ours)
        return min(parts) if parts else None

    def text(self, unit):
        if self.note:
            return self.note
        limits = ((self.least, f">= {self.least:g} {unit}" if self.least is not None else ""),
                  (self.most, f"<= {self.most:g} {unit}" if self.most is not None else ""),
                  (self.least_ratio, f">= {self.least_ratio} x"),
                  (self.most_ratio, f"<= {self.most_ratio} x"),
                  (self.most_beyond, f"<= anchor + {self.most_beyond} {unit}"))
        return ", ".join(text for limit, text in limits if limit is not None)


NONE = Goal()
START_UP = Goal(most=1.5, most_beyond=1.0)
PARSING = Goal(least=600)
BUILDING = Goal(least_ratio=1.0)
SURFACE_AREA_COST = Goal(most_ratio=1.0)
SINGLE_RAYS = Goal(least_ratio=1.0)
INCOHERENT_RAYS = Goal(least_ratio=1.0)  # as the renderer traces them, against single rays
COHERENT_RAYS = Goal(least_ratio=0.7)
MESH_SCENE = Goal(most_ratio=1.2)
SCALING = Goal(least=1.95)
MEMORY = Goal(most=200)
PNG = {512: Goal(most=4.5), 2048: Goal(most=40)}

FLOOR_MS = 6           # a whole process need not be faster
REFERENCE_FACTOR = 10  # times the speed of the reference
LEAST_FRAME_MS = 20    # frames shorter than this need not scale


def of_reference(milliseconds):
    """For a whole process of which the reference is known."""
    return Goal(most=max(milliseconds / REFERENCE_FACTOR, FLOOR_MS))


def of_reference_speed(pixels, milliseconds):
    """The same, in millions of pixels a second."""
    limit = max(milliseconds / REFERENCE_FACTOR, FLOOR_MS)
    return Goal(least=pixels / limit / 1000,
                note=f">= {REFERENCE_FACTOR} x" if limit > FLOOR_MS else f"the {FLOOR_MS} ms floor")
