"""Writes the parts of a .ray scene as text: numbers, vectors, cameras, lights, meshes. Lengths are in scene units."""
import math


def number(x):
    text = ("%.3f" % x).rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def vector(values):
    return "(" + ",".join(number(x) for x in values) + ")"


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def header(comment, generator):
    """The comment, one `//` a line, then which script drew the scene, then the language's first line."""
    lines = comment.strip().split("\n") + ["Drawn by tools/scene-generators/" + generator + "."]
    return "".join("// " + line + "\n" for line in lines) + "SBT-raytracer 1.0\n\n"


def camera(eye, target, fov, aspect):
    """A camera whose up vector is perpendicular to its view; `fov` is the angle of the height in degrees."""
    view = unit([b - a for a, b in zip(eye, target)])
    up = cross(unit(cross(view, (0, 1, 0))), view)
    precise = lambda a: "(" + ", ".join("%.5f" % x for x in a) + ")"
    return "camera {\n  position = %s;\n  viewdir = %s;\n  updir = %s;\n  fov = %s;\n  aspectratio = %s;\n}\n" % (
        precise(eye), precise(view), precise(up), number(fov), number(aspect))


def soft_light(centre, color, side, count, constant, linear, quadratic):
    """A square lamp facing down: count x count point lights that share the colour, for soft shadows."""
    share = [c / count**2 for c in color]
    text = ""
    for i in range(count):
        for k in range(count):
            x, z = (((j + 0.5) / count - 0.5) * side for j in (i, k))
            text += ("point_light { position = (%s, %s, %s); color = (%s); constant_attenuation_coeff = %s; "
                     "linear_attenuation_coeff = %s; quadratic_attenuation_coeff = %s; }\n") % (
                number(centre[0] + x), number(centre[1]), number(centre[2] + z),
                ", ".join("%.4f" % s for s in share), constant, linear, quadratic)
    return text


def rows(items, width=150):
    """Joins `items` by commas into lines of at most `width` characters."""
    lines, line = [], ""
    for item in items:
        if line and len(line) + len(item) + 1 > width:
            lines.append(line)
            line = ""
        line += item + ","
    return "\n".join(lines + [line[:-1]])


def trimesh(points, faces, attributes="", normals=None, materials=None):
    """A mesh of polygons; `materials` are the bodies of one material a point, without braces."""
    text = "trimesh {\n"
    if attributes:
        text += attributes + "\n"
    text += "points = (\n" + rows([vector(p) for p in points]) + ");\n"
    if normals:
        text += "normals = (\n" + rows([vector(n) for n in normals]) + ");\n"
    if materials:
        text += "materials = (\n" + rows(["{" + m + "}" for m in materials]) + ");\n"
    return text + "faces = (\n" + rows(["(" + ",".join(map(str, f)) + ")" for f in faces]) + ");\n}"


def hue(turn, value=0.5, spread=0.4):
    """A colour of the circle, `turn` from 0 to 1."""
    return tuple(value + spread * math.cos(2 * math.pi * (turn - k / 3)) for k in range(3))
