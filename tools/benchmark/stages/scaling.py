"""How many times as fast two threads render a frame as one, beside what they are for arithmetic alone."""
from .. import goals, programs
from ..group import Group, Line

STAGE = "2 threads"
COURSE = ("polymesh/dragon", "polymesh/trimesh2", "polymesh/trimesh3", "sphere_box", "reflection2")
WIDTHS = (512, 1024, 2048, 4096)


def frame_ms(context, build, scene, width, threads):
    found = programs.statistics_of(build.trace, scene, context.picture, "-w", width, "-t", threads)
    return max(found["render"], 0.05)  # to which the figures are rounded


def width_for(context, scene):
    """The least at which a frame is long enough to count."""
    long_enough = (width for width in WIDTHS
                   if frame_ms(context, context.build, scene, width, 2) >= goals.LEAST_FRAME_MS)
    return 16 if context.quick else next(long_enough, WIDTHS[-1])


def groups(context):
    course = [] if context.quick else filter(None, map(context.scenes.course, COURSE))
    for scene in list(course) or [context.scenes.own("showcase/glass_knot")]:
        width = width_for(context, scene)

        def sample(build, scene=scene, width=width):
            one, two = (frame_ms(context, build, scene, width, threads) for threads in (1, 2))
            return {"scaling": one / two, "one": one}

        def machine():
            kernels = (context.build.kernels, "threads", "--repetitions", context.rounds(5))
            return {"scaling": float(programs.lines(programs.output(kernels), "threads")[0]["speedup"])}

        yield Group(STAGE, sample, [
            Line("scaling", f"{scene.stem}, {width} px, frame", "times", goals.SCALING, True, 2),
            Line("one", f"{scene.stem}, {width} px, frame on 1 thread", "ms")],
                    anchor=machine, rounds=7, of_process=True)
