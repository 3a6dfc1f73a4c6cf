"""Wood and marble: colours that follow a distorted wave."""

import math
import random

from noise import Noise, blend, clamp, mix, ramp, rgb, shade, step


class Planks:
    """Four planks of a floor, along u, each cut from its own place in the log."""

    COUNT = 4
    RINGS = [(0.0, rgb("b98450")), (0.55, rgb("a9713f")), (0.85, rgb("8a5629")), (1.0, rgb("7a4a23"))]

    def __init__(self):
        self.noise = Noise(21)
        chance = random.Random(22)
        self.places = [(chance.uniform(0, 50), chance.uniform(-0.1, 0.3), chance.uniform(0.9, 1.1), chance.random())
                       for _ in range(self.COUNT)]  # fmt: skip

    def __call__(self, u, v):
        plank = min(int(v * self.COUNT), self.COUNT - 1)
        across = v * self.COUNT - plank
        shift, depth, tone, end = self.places[plank]
        # The log's axis wanders slowly; rings are the whole numbers of the distance from it.
        axis = 0.5 + 0.5 * self.noise(u * 1.3 + shift, 3.5)
        distance = math.hypot((across - axis) * 1.5, 0.25 + depth + 0.22 * self.noise(u * 0.9 + shift, 7.5))
        ring = distance * 9 + 0.35 * self.noise(u * 5 + shift, across * 6, plank + 0.5)
        colour = ramp(self.RINGS, ring % 1 if ring % 1 < 0.9 else (1 - ring % 1) * 9)
        fibre = self.noise(u * 12 + shift, across * 90, 1.5) + 0.6 * self.noise(u * 30 + shift, across * 190, 4.5)
        pores = step(0.35, 0.7, self.noise(u * 22 + shift, across * 120, 9.5))
        colour = shade(colour, tone * (1 + 0.07 * fibre - 0.16 * pores))
        joint = min(min(across, 1 - across) / self.COUNT, abs((u - end + 0.5) % 1 - 0.5))
        return shade(colour, mix(0.35, 1.0, step(0.0008, 0.004, joint)))


class Marble:
    """White marble with veins where a twisted noise passes through zero."""

    def __init__(self):
        self.noise = Noise(31)

    def __call__(self, u, v):
        x, y = u * 3, v * 3
        wx = x + 0.9 * self.noise.fractal(x, y, 1.5, 5)
        wy = y + 0.9 * self.noise.fractal(x + 7.3, y + 2.8, 5.5, 5)
        clouds = self.noise.fractal(wx * 0.8, wy * 0.8, 3.5, 5)
        base = blend(rgb("f3f1ec"), rgb("cfd0d2"), clamp(0.45 + 0.9 * clouds))
        strong = 1 - abs(self.noise.fractal(wx * 0.55 + 9, wy * 0.55 - wx * 0.35, 8.5, 4)) * 9
        fine = 1 - abs(self.noise.fractal(x * 1.1 + wx * 0.3, y * 0.8 - x * 0.5 + wy * 0.25, 11.5, 4)) * 14
        base = blend(base, rgb("8d9299"), 0.4 * clamp(fine) ** 2 * step(-0.3, 0.4, clouds))
        return blend(base, rgb("4d535c"), 0.8 * clamp(strong) ** 2.2)
