"""Spheres, boxes, cylinders, cones and squares: pixels a second of whole processes with one thread, against the
reference's published times; and of frames of one primitive alone, which have no anchor."""
from .. import goals, picture_size, programs, published, samples
from ..group import Group, Line

STAGE = "primitives"
ALONE = ("sphere", "box", "cylinder", "cone", "square")


def groups(context):
    for name in () if context.quick else published.OF_PRIMITIVES:
        scene = context.scenes.course(name)
        if scene is None:
            continue
        pixels = picture_size.pixels(context.build.trace, scene, 512, context.picture)
        milliseconds = published.REFERENCE[name][0]

        def sample(build, scene=scene, pixels=pixels):
            command = [build.trace, "-q", "-r", "5", "-w", "512", "-t", "1", scene, context.picture]
            runs, = programs.process_runs(context.build.kernels, [command], 3)
            return {"speed": pixels / samples.median([run["wall_ms"] for run in runs]) / 1000}

        yield Group(STAGE, sample, [Line("speed", f"{scene.stem}, whole process, 1 thread", "Mpixels/s",
                                         goals.of_reference_speed(pixels, milliseconds), True, 2)],
                    of_process=True,
                    anchor=lambda speed=pixels / milliseconds / 1000: {"speed": speed})

    width = 16 if context.quick else 512
    for name in ALONE:
        scene = context.scenes.own(f"features/{name}")
        pixels = picture_size.pixels(context.build.trace, scene, width, context.picture)

        def sample(build, scene=scene, pixels=pixels):
            found = programs.statistics_of(build.trace, scene, context.picture, "-w", width, "-t", "1")
            return {"speed": pixels / max(found["render"], 0.05) / 1000}

        yield Group(STAGE, sample, [Line("speed", f"{name} alone, frame, 1 thread", "Mpixels/s", more_is_better=True,
                                         digits=2)], of_process=True)
