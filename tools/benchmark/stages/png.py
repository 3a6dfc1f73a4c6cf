"""Pictures to PNG files: a usual one, and one that is textured nearly everywhere."""
from .. import goals, programs
from ..group import Group, Line

STAGE = "PNG"


def groups(context):
    widths = (16,) if context.quick else (512, 2048)
    own = context.scenes.own
    usual = None if context.quick else context.scenes.course("polymesh/dragon")
    for scene in (usual or own("features/sphere"), own("features/square" if context.quick else "showcase/still_life")):
        yield of_picture(context, scene, widths)


def of_picture(context, scene, widths):
    def sample(build):
        text = programs.output([build.kernels, "png", scene, context.scratch / "out.png", "--widths",
                                ",".join(map(str, widths)), "--repetitions", context.rounds(5)])
        return {f"{line['what']} {line['width']}": float(line["median_ms"]) for line in programs.lines(text, "png")}

    lines = [Line(f"{what} {width}", f"{scene.stem}, {width} px, {what}", "ms",
                  goals.PNG.get(width, goals.NONE) if what == "write" else goals.NONE)
             for width in widths for what in ("encode", "write")]
    return Group(STAGE, sample, lines, rounds=3)
