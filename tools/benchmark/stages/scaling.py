"""How many times as fast two threads render a frame as one."""
from .. import goals, programs
from ..group import Group, Line

STAGE = "2 threads"
COURSE = ("polymesh/dragon", "polymesh/trimesh2", "polymesh/trimesh3", "sphere_box", "reflection2")


def groups(context):
    width = 16 if context.quick else 1024
    named = [] if context.quick else [context.scenes.course(name) for name in COURSE]
    for scene in filter(None, named or [context.scenes.own("showcase/glass_knot")]):
        def sample(build, scene=scene):
            one, two = (programs.statistics_of(build.trace, scene, context.picture, "-w", width, "-t", threads)["render"]
                        for threads in (1, 2))
            return {"scaling": max(one, 0.05) / max(two, 0.05), "one": one}

        yield Group(STAGE, sample, [
            Line("scaling", f"{scene.stem}, {width} px, frame", "times", goals.SCALING, True, 2),
            Line("one", f"{scene.stem}, {width} px, frame on 1 thread", "ms")], rounds=7, of_process=True)
