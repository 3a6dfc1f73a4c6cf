"""What is built: compilers, build types and instruction sets."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Configuration:
    name: str
    compiler: str
    build_type: str
    flags: str = ""  # of the compiler
    sanitize: bool = False
    needs: tuple = ()  # flags of the processor, as /proc/cpuinfo calls them
    environment: tuple = ()  # pairs, for the programs while they run
    folder: str = ""  # of the build; its name if empty
    note: str = ""  # printed beside the flags

    def told(self):
        return " ".join(filter(None, [self.build_type, self.flags, "ASan + UBSan" if self.sanitize else "", self.note]))


# What x86-64-v3 has beyond x86-64-v2 (the System V ABI for x86-64, "micro-architecture levels"); lzcnt is abm here.
V3 = ("avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe")


def of_compiler(name):
    return [Configuration(f"{name}-x86-64", name, "Release", "-march=x86-64"),
            Configuration(f"{name}-x86-64-v3", name, "Release", "-march=x86-64-v3", needs=V3),
            Configuration(f"{name}-native", name, "Release", "-march=native"),
            Configuration(f"{name}-debug", name, "Debug", "-O0"),
            Configuration(f"{name}-sanitized", name, "Debug", "-O1", sanitize=True)]


# glibc chooses pow, tan and others by the processor when a program starts, whatever it was compiled for: with fused
# multiply-add or without, and the two round differently. What other machines would draw is seen by telling it that
# this one has none.
PLAIN_LIBRARY = Configuration("g++-libm-without-fma", "g++", "Release", "-march=x86-64",
                              environment=(("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2"),),
                              folder="g++-x86-64", note="libm: no FMA")

CONFIGURATIONS = [*of_compiler("g++"), *of_compiler("clang++"), PLAIN_LIBRARY]
REFERENCE = CONFIGURATIONS[0]
