"""Text to description, against std::from_chars over the numbers of the same text."""
from .. import goals, programs
from ..group import Group, Line

STAGE = "parsing"


def groups(context):
    size = "1 M"
    scene = context.scenes.mesh(size)

    def speed(kernels, first, *options):
        text = programs.output([kernels, "parse", scene, "--repetitions", context.rounds(3), *options])
        return {"speed": float(programs.lines(text, first)[0]["MB/s"])}

    megabytes = scene.stat().st_size / 1e6
    yield Group(STAGE, lambda build: speed(build.kernels, "parse"),
                [Line("speed", f"{megabytes:.0f} MB scene, one thread", "MB/s", goals.PARSING, more_is_better=True,
                      digits=0)],
                anchor=lambda: speed(context.build.kernels, "numbers", "--numbers-alone"))
