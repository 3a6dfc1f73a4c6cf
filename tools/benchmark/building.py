"""Our programs, of the checkout as it is or of an earlier commit, and those to compare them with."""
import dataclasses
import os
import pathlib
import shutil
import subprocess
import tempfile

from build_matrix import machine

from . import programs

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SHARED = ROOT.parent / "shared"
HELLO = '#include <iostream>\nint main() { std::cout << "hello\\n"; }\n'


@dataclasses.dataclass(frozen=True)
class Build:
    name: str
    trace: pathlib.Path
    kernels: pathlib.Path | None  # None where it has no bench_kernels


def in_folder(folder):
    kernels = folder / "bench_kernels"
    return Build(str(folder), folder / "trace", kernels if kernels.exists() else None)


def built(source, folder, jobs):
    """Release, of the sources in `source`."""
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    generator = ["-G", "Ninja"] if shutil.which("ninja") and not (folder / "CMakeCache.txt").exists() else []
    programs.output(["cmake", "-S", source, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DTRACE_TESTS=OFF", *launcher,
                     *generator], streams="both")
    targets = ["trace"] + ["bench_kernels"] * (source / "tools" / "benchmark" / "CMakeLists.txt").exists()
    programs.output(["cmake", "--build", folder, "-j", jobs, "--target", *targets], streams="both")
    return in_folder(folder)


def of_commit(revision, build_root, jobs):
    """The sources are there only while they are compiled; the programs stay in `build_root`."""
    commit = machine.output("git", "rev-parse", "--verify", "--short", f"{revision}^{{commit}}", folder=ROOT)
    if not commit:
        raise programs.Failure(f"{revision} is neither a build, nor a program, nor a commit of this repository")
    kept = build_root / commit
    if not (kept / "trace").exists():
        with tempfile.TemporaryDirectory() as folder:
            sources = pathlib.Path(folder) / "sources"
            programs.output(["git", "-C", ROOT, "worktree", "add", "--detach", sources, commit])
            try:
                build = built(sources, pathlib.Path(folder) / "build", jobs)
                kept.mkdir(parents=True, exist_ok=True)
                dynamic = build.trace.with_name("trace_dynamic")  # the other form of the program, where there are two
                for program in filter(pathlib.Path.exists, filter(None, (build.kernels, dynamic, build.trace))):
                    shutil.copy2(program, kept)
            finally:
                subprocess.run(["git", "-C", ROOT, "worktree", "remove", "--force", sources], check=False)
    return dataclasses.replace(in_folder(kept), name=commit)


def named(text, build_root, jobs):
    """A build folder, a program, or a commit."""
    path = pathlib.Path(text)
    if (path / "trace").is_file():
        return in_folder(path.resolve())
    if path.is_file():
        return Build(text, path.resolve(), None)
    return of_commit(text, build_root, jobs)


class Anchors:
    """Compiled into a folder when they are first asked for. A member is None where it cannot be had; `why` says it."""

    def __init__(self, folder):
        self.folder = folder
        self.why = {}
        self._made = {}

    def _compiled(self, name, make):
        if name not in self._made:
            try:
                self._made[name] = make()
            except (programs.Failure, OSError) as problem:
                self.why[name] = str(problem).splitlines()[-1]
                self._made[name] = None
        return self._made[name]

    def _shared(self, *parts):
        path = SHARED.joinpath("tools", *parts)
        if not path.exists():
            raise OSError(f"{os.path.relpath(path, ROOT)} is not there")
        return path

    def hello(self):
        """A program that prints a line with the C++ library."""
        def make():
            source, program = self.folder / "hello.cpp", self.folder / "hello"
            source.write_text(HELLO)
            programs.output(["c++", "-O2", source, "-o", program])
            return program
        return self._compiled("hello", make)

    def embree(self):
        """embree_bench, by the build line beside it, in a copy of its folder."""
        def make():
            copy = self.folder / "embree_bench"
            shutil.copytree(self._shared("embree_bench"), copy, dirs_exist_ok=True)
            programs.output(["sh", copy / "build.sh"], streams="both")
            return copy / "embree_bench"
        return self._compiled("embree", make)

    def mesh_generator(self):
        def make():
            program = self.folder / "genmesh"
            programs.output(["c++", "-O2", "-std=c++20", self._shared("genmesh.cpp"), "-o", program], streams="both")
            return program
        return self._compiled("mesh_generator", make)
