"""Reliefs: heights in grey, and the normals of studs as colours. Both can be repeated side by side."""

import math

from noise import Noise, step


class Hills:
    """White is high. Flat towards the edges."""

    def __init__(self):
        self.noise = Noise(23)

    def __call__(self, u, v):
        shore = step(0.0, 0.25, min(u, 1 - u, v, 1 - v))
        height = shore * (0.45 + 0.55 * self.noise.fractal(u * 3.5 + 7, v * 3.5, 0.3, 4))
        height = max(0.0, min(1.0, height))
        return (height, height, height)


def studs(u, v):
    """4 x 4 round studs as a map of normals: r, g, b are (x, y, z + 1) / 2 of a normal over the picture, y up."""
    x, y = u * 4 % 1 - 0.5, v * 4 % 1 - 0.5
    radius, across = 0.36, math.hypot(x, y)
    # A cap of a sphere that meets the ground at 60 degrees.
    tilt = math.sin(math.pi / 3) * across / radius if across < radius else 0.0
    nx, ny = (tilt * x / across, tilt * y / across) if across > 0 else (0.0, 0.0)
    nz = math.sqrt(max(0.0, 1 - nx * nx - ny * ny))
    return ((nx + 1) / 2, (ny + 1) / 2, (nz + 1) / 2)
