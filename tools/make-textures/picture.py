"""Pictures of 8-bit RGB, and writing them as PNG or BMP with nothing but the standard library."""

import struct
import zlib


class Picture:
    """Rows from top to bottom, 3 bytes a pixel."""

    def __init__(self, width, height, rows):
        self.width = width
        self.height = height
        self.rows = rows

    def write(self, path):
        encode = {".png": png_bytes, ".bmp": bmp_bytes}[path.suffix]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(encode(self))


def draw(width, height, colour, samples=1):
    """A picture of colour(u, v) -> (r, g, b) in 0..1, where u goes right and v up, both in 0..1.

    Each pixel is the mean of samples x samples points spread over it.
    """
    offsets = [(i + 0.5) / samples for i in range(samples)]
    rows = []
    for y in range(height):
        row = bytearray()
        for x in range(width):
            sums = [0.0, 0.0, 0.0]
            for dy in offsets:
                for dx in offsets:
                    rgb = colour((x + dx) / width, 1 - (y + dy) / height)
                    for channel in range(3):
                        sums[channel] += rgb[channel]
            row += bytes(to_byte(value / samples**2) for value in sums)
        rows.append(bytes(row))
    return Picture(width, height, rows)


def to_byte(value):
    return min(255, max(0, int(value * 255 + 0.5)))


def png_bytes(picture):
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    data = min((zlib.compress(filtered(picture, kind), 9) for kind in (0, 1, 2, 4)), key=len)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def filtered(picture, kind):
    """The rows with PNG's filter `kind` for each: 0 none, 1 sub, 2 up, 4 Paeth."""
    result = bytearray()
    above = bytes(3 * picture.width)
    for row in picture.rows:
        result.append(kind)
        if kind == 0:
            result += row
        elif kind == 1:
            result += bytes((a - b) & 255 for a, b in zip(row, b"\0\0\0" + row))
        elif kind == 2:
            result += bytes((a - b) & 255 for a, b in zip(row, above))
        else:
            corners = zip(row, b"\0\0\0" + row, above, b"\0\0\0" + above)
            result += bytes((value - paeth(left, up, corner)) & 255 for value, left, up, corner in corners)
        above = row
    return bytes(result)


def paeth(left, up, corner):
    """Whichever of the three neighbours is nearest to left + up - corner (PNG specification, 9.4)."""
    to_left, to_up, to_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
    if to_left <= to_up and to_left <= to_corner:
        return left
    return up if to_up <= to_corner else corner


def bmp_bytes(picture):
    padding = bytes(-3 * picture.width % 4)
    data = b"".join(blue_first(row) + padding for row in reversed(picture.rows))
    header = struct.pack("<IiiHHIIiiII", 40, picture.width, picture.height, 1, 24, 0, len(data), 2835, 2835, 0, 0)
    return struct.pack("<2sIHHI", b"BM", 54 + len(data), 0, 0, 54) + header + data


def blue_first(row):
    swapped = bytearray(row)
    swapped[0::3], swapped[2::3] = row[2::3], row[0::3]
    return bytes(swapped)
