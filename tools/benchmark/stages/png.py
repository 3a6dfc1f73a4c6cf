"""Pictures to PNG files."""
from .. import goals, programs
from ..group import Group, Line

STAGE = "PNG"


def groups(context):
    scene = context.scenes.own("features/sphere" if context.quick else "showcase/still_life")
    widths = (16,) if context.quick else (512, 2048)

    def sample(build):
        text = programs.output([build.kernels, "png", scene, context.scratch / "out.png", "--widths",
                                ",".join(map(str, widths)), "--repetitions", context.rounds(5)])
        return {f"{line['what']} {line['width']}": float(line["median_ms"]) for line in programs.lines(text, "png")}

    lines = [Line(f"{what} {width}", f"{scene.stem}, {width} px, {what}", "ms",
                  goals.PNG.get(width, goals.NONE) if what == "write" else goals.NONE)
             for width in widths for what in ("encode", "write")]
    yield Group(STAGE, sample, lines, rounds=3)
