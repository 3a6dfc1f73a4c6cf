"""A night sky: stars of all brightnesses before a faint band of the galaxy."""

import math
import random

from noise import Noise, clamp

TINTS = [(0.72, 0.82, 1.0), (0.9, 0.94, 1.0), (1.0, 1.0, 1.0), (1.0, 0.95, 0.82), (1.0, 0.82, 0.62)]


class Stars:
    CELLS = 32  # a side, to find the stars near a point

    def __init__(self):
        self.noise = Noise(51)
        chance = random.Random(52)
        self.cells = {}
        while sum(len(stars) for stars in self.cells.values()) < 1500:
            u, v = chance.random(), chance.random()
            if chance.random() > 0.35 + 0.65 * self.band(u, v):
                continue
            brightness = 0.16 * chance.random() ** -0.42  # few bright ones, many faint ones
            star = (u, v, min(brightness, 2.2), chance.choice(TINTS))
            self.cells.setdefault((int(u * self.CELLS), int(v * self.CELLS)), []).append(star)

    def band(self, u, v):
        """How dense the galaxy is, 0..1."""
        across = (v - 0.42 - 0.42 * (u - 0.5)) + 0.05 * self.noise(u * 3, v * 3)
        return math.exp(-((across / 0.13) ** 2))

    def __call__(self, u, v):
        band = self.band(u, v)
        dust = clamp(0.5 + 0.9 * self.noise.fractal(u * 5, v * 5, 2.5, 5))
        glow = 0.30 * band * dust**1.5
        colour = [0.012 + glow * 0.95, 0.014 + glow * 0.88, 0.03 + glow]
        column, row = int(u * self.CELLS), int(v * self.CELLS)
        for i in range(column - 1, column + 2):
            for j in range(row - 1, row + 2):
                for x, y, brightness, tint in self.cells.get((i, j), ()):
                    squared = ((u - x) ** 2 + (v - y) ** 2) * 512**2
                    light = brightness * (math.exp(-squared / 0.7) + 0.10 * brightness**2 * math.exp(-squared / 9))
                    for channel in range(3):
                        colour[channel] += light * tint[channel]
        return colour
