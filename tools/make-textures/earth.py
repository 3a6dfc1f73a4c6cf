"""A map of a planet that does not exist: u is the longitude, v the latitude, both linear."""

import math

from noise import Noise, blend, ramp, rgb, shade, step

SEA = [(-0.55, rgb("0b2a52")), (-0.18, rgb("14467c")), (-0.04, rgb("2a72a5")), (0.0, rgb("4f9fbe"))]
LOW, HIGH, SNOW = rgb("6b8f47"), rgb("8a7a5c"), rgb("f4f7fa")
FOREST, DESERT, TUNDRA = rgb("3f6f3a"), rgb("cdb27a"), rgb("8d9078")


class Earth:
    def __init__(self):
        self.noise = Noise(46)

    def __call__(self, u, v):
        longitude, latitude = 2 * math.pi * u, math.pi * (v - 0.5)
        ring = math.cos(latitude)
        # Noise on the sphere itself: no seam at the date line, no pinch at the poles.
        x, y, z = ring * math.cos(longitude), math.sin(latitude), ring * math.sin(longitude)
        height = self.height(x, y, z)
        warmth = 1 - abs(latitude) / (math.pi / 2) + 0.12 * self.noise(x * 4, y * 4, z * 4)
        ice = step(0.16, 0.09, warmth - 0.25 * max(height, 0))
        if height < 0:
            return blend(ramp(SEA, height), SNOW, ice)
        return blend(self.land(x, y, z, height, warmth), SNOW, ice)

    def height(self, x, y, z):
        continents = self.noise.fractal(x * 1.6 + 5.2, y * 1.6, z * 1.6 + 1.3, 7)
        ridges = 1 - abs(self.noise.fractal(x * 3, y * 3 + 9, z * 3, 5)) * 2.4
        height = continents * 1.3 - 0.06
        return height + 0.3 * max(ridges, 0) ** 3 * step(0.02, 0.3, height)

    def land(self, x, y, z, height, warmth):
        rain = self.noise.fractal(x * 2.5 + 30, y * 2.5, z * 2.5, 4)
        dry = step(-0.08, 0.22, rain + 0.35 - abs(warmth - 0.72) * 1.6 - 0.1)
        green = blend(FOREST, LOW, step(-0.2, 0.2, self.noise.fractal(x * 7, y * 7, z * 7, 3)))
        colour = blend(blend(green, DESERT, dry), TUNDRA, step(0.36, 0.2, warmth))
        colour = blend(colour, HIGH, step(0.22, 0.45, height))
        colour = blend(colour, SNOW, step(0.62, 0.85, height - 0.5 * (1 - warmth) + 0.2))
        return shade(colour, 1 + 0.18 * self.noise(x * 24, y * 24, z * 24))
