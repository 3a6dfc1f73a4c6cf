"""Hierarchies over meshes, against Embree's of medium quality."""
from .. import embree, goals, programs
from ..group import Group, Line

STAGE = "hierarchy"
THREADS = (1, 2)


def costs(text):
    """Surface-area costs by whose hierarchy it is."""
    return {line["of"]: float(line["surface_area_cost"]) for line in programs.lines(text, "quality")}


def groups(context):
    program = context.anchors.embree()
    repetitions = context.rounds(5)
    named = {"dragon": context.scenes.course("polymesh/dragon"),
             **{size: context.scenes.mesh(size) for size in (("1 M",) if context.quick else ("100 k", "1 M"))}}
    for name, scene in named.items():
        if scene is None or (context.quick and name == "dragon"):
            continue

        def sample(build, scene=scene):
            text = programs.output([build.kernels, "build", scene, "--repetitions", repetitions])
            found = {f"{line['threads']} threads": float(line["Mtris/s"]) for line in programs.lines(text, "build")}
            found["cost"] = costs(text)["ours"]
            return found

        def anchor(scene=scene):
            built = programs.output([context.build.kernels, "build", scene, "--threads", "1", "--repetitions", 1])
            cost = costs(built).get("embree")
            return {**(embree.figures(program, scene, 16, repetitions, THREADS, rays=False) if program else {}),
                    **({"cost": cost} if cost else {})}

        lines = [Line(f"{n} threads", f"{name}, {n} thread{'s' * (n > 1)}", "Mtriangles/s", goals.BUILDING,
                      more_is_better=True, digits=2) for n in THREADS]
        lines.append(Line("cost", f"{name}, surface-area cost", "boxes and triangles", goals.SURFACE_AREA_COST))
        yield Group(STAGE, sample, lines, anchor=anchor, rounds=3,
                    missing=context.anchors.why.get("embree", ""))
