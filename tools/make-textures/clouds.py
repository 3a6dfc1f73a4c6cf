"""Clouds over black: a second layer for the map of a planet; u is the longitude, v the latitude, both linear."""

import math

from noise import Noise, step


class Clouds:
    def __init__(self):
        self.noise = Noise(71)

    def __call__(self, u, v):
        longitude, latitude = 2 * math.pi * u, math.pi * (v - 0.5)
        ring = math.cos(latitude)
        x, y, z = ring * math.cos(longitude), math.sin(latitude), ring * math.sin(longitude)
        # Bands along the latitudes, bent by a slower noise.
        bend = 0.5 * self.noise.fractal(x * 2, y * 2, z * 2, 3)
        cover = self.noise.fractal(x * 2.2 + bend, y * 5.5 + bend, z * 2.2 - bend, 7)
        white = step(-0.1, 0.75, cover)
        return (white, white, white)
