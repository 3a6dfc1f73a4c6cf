"""What embree_bench prints."""
from . import programs


def figures(program, scene, width, repetitions, threads, rays=True):
    """By key: "primary single" and the like in millions of rays a second, "1 threads" in millions of triangles
    a second (hierarchies of medium quality)."""
    command = [program, "--threads", ",".join(map(str, threads)), "--res", width, "--reps", repetitions]
    text = programs.output([*command, *([] if rays else ["--build-only"]), scene])
    found = {f"{line['threads']} threads": float(line["Mtris/s"]) for line in programs.lines(text, "build")
             if line["quality"] == "medium"}
    for line in programs.lines(text, "trace"):
        interface = {"1": "single", "16": "coherent"}.get(line["api"])
        if line["robust"] == "0" and interface:
            found[f"{line['mode']} {interface}"] = float(line["Mrays/s"])
    return found
