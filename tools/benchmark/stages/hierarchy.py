"""Hierarchies over meshes, against Embree's of medium quality."""
from .. import embree, goals, programs
from ..group import Group, Line

STAGE = "hierarchy"
THREADS = (1, 2)


def costs(text):
    """Surface-area costs by whose hierarchy it is: of single triangles, and of blocks of them tested at once."""
    return {line["of"]: {"cost": float(line["surface_area_cost"]), "blocks": float(line["cost_in_blocks"])}
            for line in programs.lines(text, "quality")}


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
            return found | costs(text)["ours"]

        def anchor(scene=scene):
            built = programs.output([context.build.kernels, "build", scene, "--threads", "1", "--repetitions", 1])
            speeds = embree.figures(program, scene, 16, repetitions, THREADS, rays=False) if program else {}
            return speeds | costs(built).get("embree", {})

        lines = [Line(f"{n} threads", f"{name}, {n} thread{'s' * (n > 1)}", "Mtriangles/s", goals.BUILDING,
                      more_is_better=True, digits=2) for n in THREADS]
        lines.append(Line("blocks", f"{name}, surface-area cost", "nodes and blocks", goals.SURFACE_AREA_COST))
        lines.append(Line("cost", f"{name}, the same by triangles", "nodes and triangles"))
        yield Group(STAGE, sample, lines, anchor=anchor, rounds=3,
                    missing=context.anchors.why.get("embree", ""))
