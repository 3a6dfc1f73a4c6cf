"""Whole processes, 512 pixels wide, two threads: meshes against the floor, the rest against the reference."""
from .. import goals, programs, published, samples
from ..group import Group, Line

STAGE = "whole process"


def groups(context):
    width = 16 if context.quick else 512
    named = {} if context.quick else {name: context.scenes.course(name) for name in published.REFERENCE}
    if not any(named.values()):
        named = {name: context.scenes.own(name) for name in ("showcase/glass_knot", "features/sphere")}
    for name, scene in named.items():
        if scene is None:
            continue

        def sample(build, scene=scene):
            command = [build.trace, "-q", "-r", "5", "-w", width, "-t", "2", scene, context.picture]
            runs, = programs.process_runs(context.build.kernels, [command], context.rounds(3))
            return {"wall": samples.median([run["wall_ms"] for run in runs])}

        anchor, goal, what = None, goals.NONE, scene.stem
        if name in published.FLOORS:
            anchor, goal, what = published.FLOORS[name], goals.MESH_SCENE, f"{scene.stem} (floor)"
        elif name in published.REFERENCE:
            anchor = published.REFERENCE[name][1]
            goal, what = goals.of_reference(anchor), f"{scene.stem} (reference)"
        yield Group(STAGE, sample, [Line("wall", what, "ms", goal)], rounds=7, of_process=True,
                    anchor=(lambda anchor=anchor: {"wall": anchor}) if anchor else None)
