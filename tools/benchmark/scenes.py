"""The scenes: the course's where they are, made ones, and our own."""
import math

from . import building, programs

COURSE = building.SHARED / "corpus" / "scenes" / "utexas"
OWN = building.ROOT / "scenes"
SIZES = {"10 k": 10_000, "100 k": 100_000, "1 M": 1_000_000, "4 M": 4_000_000}

HEADER = "SBT-raytracer 1.0\n\n"
MATERIAL = "{ diffuse = (0.8, 0.5, 0.2); ambient = (0.2, 0.2, 0.2); specular = (0.2, 0.1, 0.1); shininess = 0.2; }"
CAMERA = "camera { position = (0, 0, 3); viewdir = (0, 0, -1); updir = (0, 1, 0); fov = 45; }\n"
LIGHT = "point_light { position = (3, 4, 5); color = (1, 1, 1); }\n"


class Scenes:
    """Made ones are kept in `folder`."""

    def __init__(self, folder, anchors, quick):
        self.folder = folder
        self.anchors = anchors
        self.quick = quick
        folder.mkdir(parents=True, exist_ok=True)

    @staticmethod
    def course(name):
        """None where the course's scenes are not there."""
        file = COURSE / f"{name}.ray"
        return file if file.exists() else None

    @staticmethod
    def own(name):
        return OWN / f"{name}.ray"

    def mesh(self, size):
        """A bumpy sphere of about so many triangles."""
        count = 320 if self.quick else SIZES[size]
        generator = None if self.quick else self.anchors.mesh_generator()
        file = self.folder / f"{'mesh' if generator else 'bumpy'}_{count}.ray"
        if not file.exists():
            if generator:
                programs.output([generator, count, file])
            else:
                self._write(file, bumpy_sphere(count))
        return file

    def lights(self, count):
        """A sphere on a square under so many lights in a circle."""
        angles = [2 * math.pi * i / count for i in range(count)]
        color = ", ".join([f"{1 / count:.6f}"] * 3)
        circle = "".join(f"point_light {{ position = ({4 * math.cos(angle):.6f}, 4, {4 * math.sin(angle):.6f}); "
                         f"color = ({color}); }}\n" for angle in angles)
        return self._made(f"lights_{count}.ray", HEADER + CAMERA + circle + OBJECTS)

    def mirrors(self):
        """Two mirrors that face each other, and the eye between them."""
        return self._made("mirrors.ray", HEADER + MIRRORS)

    def _made(self, name, text):
        file = self.folder / name
        if not file.exists():
            self._write(file, [text])
        return file

    def _write(self, file, parts):
        """Under its name only once it is whole."""
        half = file.with_suffix(".part")
        with open(half, "w", encoding="ascii") as out:
            out.writelines(parts)
        half.rename(file)


OBJECTS = f"""translate(0, -1, 0, rotate(1, 0, 0, -1.570796, scale(8, 8, 1, square {{ material = {MATERIAL}; }})))
sphere {{ material = {MATERIAL}; }}
translate(1.2, -0.5, 0.5, scale(0.5, box {{ material = {MATERIAL}; }}))
"""

MIRROR = "scale(400, 400, 1, square { material = { diffuse = (0.1, 0.1, 0.1); reflective = (0.9, 0.9, 0.9); }; })"
MIRRORS = f"""camera {{ position = (0, 0, 0.5); viewdir = (0.1, 0.05, -1); updir = (0, 1, 0); fov = 60; }}
point_light {{ position = (0.5, 0.8, 0); color = (1, 1, 1); }}
translate(0, 0, -2, {MIRROR})
translate(0, 0, 2, {MIRROR})
translate(0.6, 0, -0.8, scale(0.25, sphere {{ material = {{ diffuse = (0.7, 0.3, 0.2); }}; }}))
"""


def bumpy_sphere(count):
    """The text, in parts: rings of triangles around the poles, as many as make about `count`."""
    rings = max(4, round(math.sqrt(count) / 2))
    columns = 2 * rings
    yield HEADER + CAMERA + LIGHT + f"polymesh {{ material = {MATERIAL};\n points = ("
    for ring in range(rings + 1):
        polar = math.pi * ring / rings
        for column in range(columns):
            around = 2 * math.pi * column / columns
            x, y, z = math.sin(polar) * math.cos(around), math.cos(polar), math.sin(polar) * math.sin(around)
            r = 1 + 0.06 * math.sin(9 * x + 2 * y) * math.sin(8 * y - 3 * z)
            r += 0.006 * math.sin(91 * x) * math.sin(87 * y)
            comma = "," if ring or column else ""
            yield f"{comma}\n( {x * r:.6g}, {y * r:.6g}, {z * r:.6g} )"
    yield " );\n faces = ("
    for ring in range(rings):
        for column in range(columns):
            a, b = ring * columns + column, ring * columns + (column + 1) % columns
            comma = "," if ring or column else ""
            yield f"{comma}\n( {a}, {b}, {b + columns} ),\n( {a}, {b + columns}, {a + columns} )"
    yield " );\n gennormals;\n}\n"
