"""Smooth random functions and the small functions one shapes them with."""

import math
import random


class Noise:
    """Gradient noise after K. Perlin, "Improving noise" (2002): smooth, about -1..1, 0 at whole numbers."""

    GRADIENTS = [
        (1, 1, 0), (-1, 1, 0), (1, -1, 0), (-1, -1, 0), (1, 0, 1), (-1, 0, 1), (1, 0, -1), (-1, 0, -1),
        (0, 1, 1), (0, -1, 1), (0, 1, -1), (0, -1, -1), (1, 1, 0), (-1, 1, 0), (0, -1, 1), (0, -1, -1),
    ]  # fmt: skip

    def __init__(self, seed):
        numbers = list(range(256))
        random.Random(seed).shuffle(numbers)
        self.table = numbers * 2

    def __call__(self, x, y, z=0.5):
        fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
        x, y, z = x - fx, y - fy, z - fz
        i, j, k = fx & 255, fy & 255, fz & 255
        u, v, w = (t * t * t * (t * (t * 6 - 15) + 10) for t in (x, y, z))
        p = self.table
        a, b = p[i] + j, p[i + 1] + j
        aa, ab, ba, bb = p[a] + k, p[a + 1] + k, p[b] + k, p[b + 1] + k

        def corner(index, cx, cy, cz):
            g = self.GRADIENTS[p[index] & 15]
            return g[0] * cx + g[1] * cy + g[2] * cz

        def square(shift, cz):
            low = mix(corner(aa + shift, x, y, cz), corner(ba + shift, x - 1, y, cz), u)
            high = mix(corner(ab + shift, x, y - 1, cz), corner(bb + shift, x - 1, y - 1, cz), u)
            return mix(low, high, v)

        return mix(square(0, z), square(1, z - 1), w)

    def fractal(self, x, y, z=0.5, octaves=5):
        """Octaves of noise, each of double frequency and half weight; about -1..1."""
        total, weight, scale = 0.0, 0.5, 1.0
        for _ in range(octaves):
            total += weight * self(x * scale, y * scale, z * scale)
            weight /= 2
            scale *= 2
        return total * 1.6


def mix(a, b, t):
    return a + (b - a) * t


def blend(a, b, t):
    """The colour between the colours a (t = 0) and b (t = 1)."""
    return tuple(mix(x, y, t) for x, y in zip(a, b))


def shade(colour, factor):
    return tuple(channel * factor for channel in colour)


def clamp(value):
    return min(1.0, max(0.0, value))


def step(low, high, value):
    """0 below low, 1 above high, smooth between."""
    t = clamp((value - low) / (high - low))
    return t * t * (3 - 2 * t)


def ramp(stops, value):
    """The colour at `value` on a scale of (place, colour) stops in rising order."""
    if value <= stops[0][0]:
        return stops[0][1]
    for (low, first), (high, second) in zip(stops, stops[1:]):
        if value <= high:
            return blend(first, second, (value - low) / (high - low))
    return stops[-1][1]


def rgb(hexadecimal):
    """rgb("ff8000") is orange."""
    return tuple(int(hexadecimal[i : i + 2], 16) / 255 for i in (0, 2, 4))
