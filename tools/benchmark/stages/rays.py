"""Rays a second through meshes on one thread, the very rays that embree_bench traces: one at a time, in packets."""
from .. import embree, goals, programs
from ..group import Group, Line

STAGE = "rays"
COHERENT = ("primary", "prim+1shadow", "prim+allshadows")
MIRRORED = "prim+1reflect"
MODES = (*COHERENT, MIRRORED)
MESHES = ("100 k", "1 M", "4 M")
COURSE = ("dragon", "trimesh1", "trimesh2", "trimesh3")


def groups(context):
    program = context.anchors.embree()
    width = 48 if context.quick else 1024
    named = {} if context.quick else {name: context.scenes.course(f"polymesh/{name}") for name in COURSE}
    named.update({size: context.scenes.mesh(size) for size in (("100 k",) if context.quick else MESHES)})
    for name, scene in named.items():
        if scene is None:
            continue

        def sample(build, scene=scene):
            text = programs.output([build.kernels, "rays", scene, "--width", width, "--repetitions", context.rounds(3)])
            return {f"{line['mode']} {line['interface']}": float(line["Mrays/s"])
                    for line in programs.lines(text, "rays")}

        def anchor(scene=scene):
            found = embree.figures(program, scene, width, context.rounds(3), (1,))
            # Mirrored rays are not coherent: Embree is asked for them one at a time.
            if f"{MIRRORED} single" in found:
                found[f"{MIRRORED} coherent"] = found[f"{MIRRORED} single"]
            return found

        lines = [Line(f"{mode} single", f"{name}, {mode}", "Mrays/s", goals.SINGLE_RAYS, True, 2) for mode in MODES]
        lines += [Line(f"{mode} coherent", f"{name}, {mode}, packets", "Mrays/s", goals.COHERENT_RAYS, True, 2)
                  for mode in COHERENT]
        lines.append(Line(f"{MIRRORED} coherent", f"{name}, {MIRRORED}, ours in packets", "Mrays/s",
                          goals.INCOHERENT_RAYS, True, 2))
        yield Group(STAGE, sample, lines, anchor=anchor if program else None, rounds=2 if name == "4 M" else 3,
                    missing=context.anchors.why.get("embree", ""))
