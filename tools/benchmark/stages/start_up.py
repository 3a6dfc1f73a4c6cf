"""The whole process for one pixel of a small scene, against a program that only prints a line."""
from .. import goals, programs, samples
from ..group import Group, Line

STAGE = "start-up"


def groups(context):
    scene = context.scenes.course("simple/box_cyl_reflect") or context.scenes.own("features/box")
    runs = context.rounds(60)

    def median_of(command):
        timed, = programs.process_runs(context.build.kernels, [command], runs)
        return {"wall": samples.median([run["wall_ms"] for run in timed])}

    hello = context.anchors.hello()
    yield Group(STAGE, lambda build: median_of([build.trace, "-q", "-w", "1", scene, context.picture]),
                [Line("wall", f"whole process, {scene.stem}, 1 pixel", "ms", goals.START_UP, digits=2)],
                anchor=(lambda: median_of([hello])) if hello else None, rounds=9, of_process=True,
                missing=context.anchors.why.get("hello", ""))
