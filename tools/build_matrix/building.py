"""Configuring and building one configuration in a folder of its own."""
import dataclasses
import os
import pathlib
import shutil
import subprocess

SHOWN = 20  # lines of what a failing build says


@dataclasses.dataclass
class Build:
    trace: pathlib.Path
    hard_cases: pathlib.Path | None  # None where the project has no such target
    tests: pathlib.Path | None       # None where they are not asked for
    environment: dict


def environment(configuration):
    """For the programs. A sanitizer ends them with a status that `trace` does not know."""
    return dict(os.environ, ASAN_OPTIONS="exitcode=99", UBSAN_OPTIONS="exitcode=99:print_stacktrace=1",
                **dict(configuration.environment))


def configure_command(configuration, compiler, folder):
    source = pathlib.Path(__file__).resolve().parent.parent.parent
    command = ["cmake", "-S", source, "-B", folder, f"-DCMAKE_CXX_COMPILER={compiler}",
               f"-DCMAKE_BUILD_TYPE={configuration.build_type}", f"-DCMAKE_CXX_FLAGS={configuration.flags}",
               "-DCMAKE_CXX_FLAGS_DEBUG=-g", "-DTRACE_TESTS=ON",
               f"-DTRACE_SANITIZE={'ON' if configuration.sanitize else 'OFF'}"]
    if shutil.which("ccache"):
        command.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    if shutil.which("ninja"):
        command += ["-G", "Ninja"]
    return command


def built(configuration, compiler, build_root, jobs, with_tests):
    """A Build, or the text of what went wrong."""
    folder = build_root / (configuration.folder or configuration.name)
    # Precompiled headers are cached only with these.
    cache = {"CCACHE_SLOPPINESS": "pch_defines,time_macros,include_file_mtime,include_file_ctime"}
    build_environment = {**cache, **os.environ}

    def run(command):
        done = subprocess.run(command, env=build_environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)
        return done.returncode == 0, done.stdout

    fine, text = run(configure_command(configuration, compiler, folder))
    if not fine:
        return tail(text)
    # Written by every generator: one folder a target.
    has_hard_cases = "/hard_cases.dir\n" in (folder / "CMakeFiles" / "TargetDirectories.txt").read_text()
    targets = ["trace"] + has_hard_cases * ["hard_cases"] + with_tests * ["trace_tests"]
    fine, text = run(["cmake", "--build", folder, "-j", str(jobs), "--target", *targets])
    if not fine:
        return tail("\n".join(line for line in text.splitlines() if "error" in line or "FAILED" in line) or text)
    return Build(folder / "trace", folder / "hard_cases" if has_hard_cases else None,
                 folder / "trace_tests" if with_tests else None, environment(configuration))


def tail(text):
    return "\n".join(f"    {line[:300]}" for line in text.splitlines()[-SHOWN:])
