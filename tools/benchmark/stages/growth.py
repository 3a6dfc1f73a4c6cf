"""How time and memory grow with triangles, lights, depth and pixels, one of them at a time. No goals: tables."""
from .. import programs
from ..group import Group, Line, Place

STAGE = "growth"
LIGHTS = (1, 4, 16, 64)
DEPTHS = (0, 1, 2, 4, 8, 16, 32)
WIDTHS = (64, 128, 256, 512, 1024, 2048, 4096)
TIMES = ("load", "build", "render", "write")


def series(context):
    """Axis, and of each of its points: label, amount, scene, arguments."""
    scenes, quick = context.scenes, context.quick
    width = "16" if quick else "512"
    sizes = ("10 k", "100 k", "1 M", "4 M")
    yield "triangles", [(size, None, scenes.mesh(size), ("-w", width)) for size in (sizes[:2] if quick else sizes)]
    yield "lights", [(n, n, scenes.lights(n), ("-w", width)) for n in (LIGHTS[:2] if quick else LIGHTS)]
    # A ray that is reflected n times has n + 1 parts.
    yield "depth", [(n, n + 1, scenes.mirrors(), ("-w", width, "-r", n)) for n in (DEPTHS[:3] if quick else DEPTHS)]
    scene = scenes.course("polymesh/dragon") or scenes.mesh("10 k")
    yield "pixels", [(f"{n} px", n * n, scenes.mesh("10 k") if quick else scene, ("-w", n))
                     for n in ((8, 16) if quick else WIDTHS)]


def groups(context):
    for axis, points in series(context):
        for label, amount, scene, arguments in points:
            if amount is None:
                found = programs.statistics_of(context.build.trace, scene, context.picture, "-w", "16")
                amount = found["triangles"]

            def sample(build, scene=scene, arguments=arguments):
                found = programs.statistics_of(build.trace, scene, context.picture, *map(str, arguments))
                return {name: found.get(name, 0.0) for name in (*TIMES, "memory")}

            yield Group(STAGE, sample, [
                Line(name, f"{axis}: {label}, {name}", "MB" if name == "memory" else "ms",
                     place=Place(axis, amount, str(label), name)) for name in (*TIMES, "memory")],
                        rounds=3, of_process=True)
