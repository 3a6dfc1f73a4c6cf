"""A grid that shows how a texture lies on a surface: where its corners are, and whether it is mirrored."""

import colorsys

from noise import blend, rgb

FIELDS = 8  # a side; the field at the bottom left is A1, at the bottom right H1, at the top left A8

# 5 x 7 dots, each row five bits from left to right.
GLYPHS = {
    "A": (0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001),
    "B": (0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110),
    "C": (0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110),
    "D": (0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110),
    "E": (0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111),
    "F": (0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000),
    "G": (0b01110, 0b10001, 0b10000, 0b10111, 0b10001, 0b10001, 0b01110),
    "H": (0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001),
    "1": (0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110),
    "2": (0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111),
    "3": (0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110),
    "4": (0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010),
    "5": (0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110),
    "6": (0b01110, 0b10000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110),
    "7": (0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000),
    "8": (0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110),
}


def uv_grid(u, v):
    """Meant for 512 x 512 pixels, where lines and letters fall on whole pixels."""
    x, y = u * FIELDS, v * FIELDS
    column, row = int(x), int(y)
    x, y = x - column, y - row
    light = (column + row) % 2
    # The hue goes with u, the lightness with v.
    field = colorsys.hls_to_rgb(column / FIELDS, 0.36 + 0.045 * row + 0.06 * light, 0.62)
    pixel = 1 / 64
    if min(x, y) < pixel or max(x, y) > 1 - pixel:
        return rgb("ffffff") if light else blend(field, rgb("ffffff"), 0.7)
    if lettered("ABCDEFGH"[column] + "12345678"[row], (x - 10 * pixel) / (4 * pixel), (y - 18 * pixel) / (4 * pixel)):
        return rgb("ffffff")
    if (column, row) == (0, 0) and arrows(x / pixel, y / pixel):
        return rgb("101010")
    return field


def lettered(text, x, y):
    """Whether the text covers (x, y), in dots from its lower left corner."""
    index, row = int(x // 6), int(y // 1)
    dot = int(x // 1) - 6 * index
    if not (0 <= index < len(text) and 0 <= row < 7 and dot < 5):
        return False
    return bool(GLYPHS[text[index]][6 - row] >> (4 - dot) & 1)


def arrows(x, y):
    """Along u and along v from the origin, in pixels of the first field."""

    def arrow(along, across):
        return (5 <= along < 46 and abs(across - 6) <= 1.5) or (46 <= along < 57 and abs(across - 6) <= (57 - along) / 2)

    return arrow(x, y) or arrow(y, x)
