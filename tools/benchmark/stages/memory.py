"""Resident memory a triangle, all told: text, scene, hierarchies, picture, program."""
from .. import goals, programs, samples
from ..group import Group, Line

STAGE = "memory"


def groups(context):
    for size in ("1 M",) if context.quick else ("1 M", "4 M"):
        scene = context.scenes.mesh(size)
        triangles = programs.statistics_of(context.build.trace, scene, context.picture, "-w", "16")["triangles"]

        def sample(build, scene=scene, triangles=triangles):
            command = [build.trace, "-q", "-w", "16" if context.quick else "512", scene, context.picture]
            runs, = programs.process_runs(context.build.kernels, [command], 1)
            return {"bytes": samples.median([run["peak_kilobytes"] for run in runs]) * 1024 / triangles}

        yield Group(STAGE, sample, [Line("bytes", f"{size} triangles, most at any time", "bytes a triangle",
                                         goals.MEMORY, digits=0)], rounds=3, of_process=True)
