"""Things laid out in rows: checkerboard, bricks, tiles. All of them can be repeated side by side."""

import math
import random

from noise import Noise, blend, mix, rgb, shade, step


def checker(u, v):
    """8 x 8 fields; the one at the bottom left is dark."""
    return rgb("e9e4d8") if (int(u * 8) + int(v * 8)) % 2 else rgb("31343b")


class Bricks:
    ROWS, COLUMNS = 8, 4
    JOINT = 0.0065  # half its width, in units of the picture
    FIRED = [rgb(c) for c in ("9d4a35", "a8543b", "8b3f30", "b3624a", "94513f", "7c3a30")]
    MORTAR = rgb("b9b2a4")

    def __init__(self):
        self.noise = Noise(11)
        chance = random.Random(12)
        count = self.ROWS * self.COLUMNS
        self.colours = [shade(chance.choice(self.FIRED), chance.uniform(0.88, 1.08)) for _ in range(count)]

    def __call__(self, u, v):
        row = int(v * self.ROWS) % self.ROWS
        along = (u * self.COLUMNS + row % 2 / 2) % self.COLUMNS
        column = int(along)
        # Distances to the brick's edges, with a little wear; whole wave lengths keep the pattern repeatable.
        wear = 0.003 * self.repeating(u, v, 16)
        beside = min(along - column, column + 1 - along) / self.COLUMNS
        above = min(v * self.ROWS % 1, 1 - v * self.ROWS % 1) / self.ROWS
        inside = min(beside, above) - self.JOINT + wear
        grain = self.repeating(u, v, 64) + 0.6 * self.repeating(u, v, 32)
        brick = shade(self.colours[row * self.COLUMNS + column], 1 + 0.13 * grain)
        brick = shade(brick, mix(0.72, 1.0, step(0.0, 0.008, inside)))  # rounded edges
        mortar = shade(self.MORTAR, 1 + 0.09 * grain)
        return blend(mortar, brick, step(-0.001, 0.0012, inside))

    def repeating(self, u, v, frequency):
        """Noise that is the same at u and u + 1, v and v + 1: a mixture of shifted copies."""
        x, y = u * frequency, v * frequency
        copies = [(x, y, (1 - u) * (1 - v)), (x - frequency, y, u * (1 - v)),
                  (x, y - frequency, (1 - u) * v), (x - frequency, y - frequency, u * v)]  # fmt: skip
        total = sum(weight * self.noise(px, py) for px, py, weight in copies)
        return total / math.sqrt(sum(weight * weight for _, _, weight in copies))


def tiles(u, v):
    """4 x 4 glazed tiles, each with a quarter of an ornament: four together make the whole of it."""
    x, y = u * 4, v * 4
    column, row = int(x), int(y)
    x, y = x - column, y - row
    joint = min(x, 1 - x, y, 1 - y)
    # Mirrored from tile to tile, so that the corners of four neighbours meet in one centre.
    x, y = (1 - x if column % 2 else x), (1 - y if row % 2 else y)
    colour = rgb("f2ead9")
    white, blue, ochre = rgb("f2ead9"), rgb("2b5c8f"), rgb("d59a3a")
    radius, angle = math.hypot(x, y), math.atan2(y, x)
    for edge, paint in ((0.80, blue), (0.72, white)):
        colour = blend(paint, colour, step(edge - 0.006, edge + 0.006, radius))
    petal = 0.40 + 0.22 * abs(math.cos(4 * angle)) ** 0.7
    for edge, paint in ((petal, blue), (petal * 0.82, white), (petal * 0.70, ochre), (0.2, blue), (0.13, white)):
        colour = blend(paint, colour, step(edge - 0.006, edge + 0.006, radius))
    opposite = math.hypot(1 - x, 1 - y)
    for edge, paint in ((0.26, ochre), (0.19, white), (0.12, blue)):
        colour = blend(paint, colour, step(edge - 0.006, edge + 0.006, opposite))
    glaze = 1.0 - 0.10 * (1 - step(0.0, 0.09, joint))
    return blend(rgb("8f8a80"), shade(colour, glaze), step(0.010, 0.018, joint))
