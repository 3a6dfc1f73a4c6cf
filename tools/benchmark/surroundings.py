"""The machine that figures belong to."""
import os
import pathlib
import platform

from build_matrix import machine

SETS = ("sse4_2", "avx", "avx2", "fma", "avx512f", "avx512dq", "avx512vl")
CACHES = pathlib.Path("/sys/devices/system/cpu/cpu0/cache")


def caches():
    """Of the first processor: "L1d 48K, L1i 32K, L2 1024K"."""
    found = []
    for folder in sorted(CACHES.glob("index*")):
        level, kind, size = ((folder / name).read_text().strip() for name in ("level", "type", "size"))
        found.append(f"L{level}{ {'Data': 'd', 'Instruction': 'i'}.get(kind, '')} {size}")
    return ", ".join(found) or "unknown"


def described(build, root):
    name, flags = machine.processor()
    return {"Processor": f"{name}, {os.cpu_count()} processors",
            "Instruction sets": ", ".join(flag for flag in SETS if flag in flags) or "unknown",
            "Caches": caches(),
            "System": f"{platform.system()} {platform.release()}, {' '.join(platform.libc_ver())}",
            "Program": machine.output(build.trace, "--version") or "unknown",
            "Commit": machine.commit(root)}
