"""A cube map of a summer evening: sun, clouds, and hills all around the horizon.

Every colour depends on the direction alone, and the outermost texels of a face lie exactly on the cube's edges
(u = 0 and u = 1 are the centres of the first and last texel), so neighbouring faces agree there to the bit.
"""

import math

from noise import Noise, blend, clamp, mix, ramp, rgb, shade, step
from picture import Picture, to_byte

# The direction of the texel (a, b), both in -1..1, b upwards. The face "posz" is what one sees looking along -z.
FACES = {
    "posx": lambda a, b: (1, b, a),
    "negx": lambda a, b: (-1, b, -a),
    "posy": lambda a, b: (a, 1, b),
    "negy": lambda a, b: (a, -1, -b),
    "posz": lambda a, b: (a, b, -1),
    "negz": lambda a, b: (-a, b, 1),
}

# By elevation, as the sine.
AIR = [(0.0, rgb("f6d9b0")), (0.07, rgb("e9d6c0")), (0.2, rgb("aecbe0")), (0.5, rgb("5f9bd3")), (1.0, rgb("2a62ae"))]
SUN = tuple(c / math.sqrt(0.45**2 + 0.26**2 + 0.8**2) for c in (0.45, 0.26, -0.8))

# Far to near: mean height and how much it varies (both as the tangent of the elevation), waviness, colour.
HILLS = [
    (0.090, 0.115, 2.6, rgb("a3b1bf")),
    (0.035, 0.085, 3.4, rgb("7b977f")),
    (-0.030, 0.060, 4.2, rgb("557a45")),
]
MEADOW = [(0.0, rgb("5f8743")), (0.25, rgb("567b38")), (1.0, rgb("3f5f2b"))]


class Sky:
    def __init__(self):
        self.noise = Noise(61)

    def faces(self, size):
        """The six faces as (name, picture)."""
        edge = [2 * i / (size - 1) - 1 for i in range(size)]
        for name, direction in FACES.items():
            rows = []
            for b in reversed(edge):
                row = bytearray()
                for a in edge:
                    row += bytes(map(to_byte, self.colour(*direction(a, b), 2.0 / size)))
                rows.append(bytes(row))
            yield name, Picture(size, size, rows)

    def colour(self, x, y, z, texel):
        """Of the direction (x, y, z) of any length; `texel` is about the angle between texels."""
        length = math.sqrt(x * x + y * y + z * z)
        x, y, z = x / length, y / length, z / length
        flat = math.hypot(x, z)
        if flat < 1e-9:
            return self.air(x, y, z) if y > 0 else self.meadow(x, y, z)
        elevation = y / flat
        colour = self.air(x, y, z) if elevation > -0.11 else (0, 0, 0)
        for layer, (mean, range_, waviness, tint) in enumerate(HILLS):
            if elevation > mean + 1.2 * range_:
                continue
            top = mean + range_ * self.ridge(x / flat, z / flat, waviness, layer)
            covered = clamp((top - elevation) / texel + 0.5)
            if covered > 0:
                colour = blend(colour, self.hill(x, y, z, layer, tint, top - elevation), covered)
        return colour

    def air(self, x, y, z):
        towards_sun = x * SUN[0] + y * SUN[1] + z * SUN[2]
        colour = ramp(AIR, max(y, 0.0))
        warm = step(-0.2, 1.0, towards_sun) * (1 - step(0.0, 0.5, y))
        colour = blend(colour, rgb("ffdfa6"), 0.45 * warm)
        colour = self.clouds(x, y, z, colour, towards_sun)
        glow = 0.5 * math.exp((towards_sun - 1) * 60) + 0.25 * math.exp((towards_sun - 1) * 9)
        colour = blend(colour, rgb("fff3d6"), clamp(glow))
        return blend(colour, (1, 1, 0.96), step(math.cos(0.036), math.cos(0.027), towards_sun))

    def clouds(self, x, y, z, sky, towards_sun):
        if y < 0.03:
            return sky
        # A layer of clouds overhead, flattened towards the horizon as perspective does.
        px, pz = x / (y + 0.12), z / (y + 0.12)
        density = self.noise.fractal(px * 0.9 + 4, pz * 0.9, 3.5, 5)
        cover = step(0.08, 0.5, density) * step(0.03, 0.16, y)
        light = blend(rgb("d8dbe3"), rgb("fffaf0"), step(0.7, 0.15, density) * 0.6 + 0.4 * step(-0.3, 0.9, towards_sun))
        return blend(sky, light, 0.88 * cover)

    def ridge(self, x, z, waviness, layer):
        """The height of a row of hills in the horizontal direction (x, z), about -1..1."""
        return 1.3 * self.noise.fractal(x * waviness + 20 * layer, 0.5 + layer, z * waviness, 4)

    def hill(self, x, y, z, layer, tint, below_top):
        if layer == len(HILLS) - 1:
            meadow = self.meadow(x, y, z)
            return blend(tint, meadow, step(0.0, 0.08, below_top))
        towards_sun = clamp(0.5 + 0.5 * (x * SUN[0] + z * SUN[2]))
        grain = self.noise(x * 30, y * 90, z * 30) * (0.03 + 0.03 * layer)
        lit = blend(tint, rgb("f0d9b4"), 0.25 * towards_sun**2 * (2 - layer) / 2)
        return shade(blend(lit, rgb("d9d4c6"), 0.35 * step(0.0, 0.12, below_top)), 1 + grain)

    def meadow(self, x, y, z):
        colour = ramp(MEADOW, max(-y, 0.0))
        px, pz = x / (0.06 - y), z / (0.06 - y)
        # Patterns finer than a texel are left out towards the horizon.
        near = step(0.0, 0.35, -y)
        patches = 0.16 * self.noise.fractal(px * 0.7, 5.5, pz * 0.7, 3) * mix(0.25, 1, near)
        blades = 0.14 * near * self.noise.fractal(px * 9, 8.5, pz * 9, 3)
        return shade(colour, 1 + patches + blades)
