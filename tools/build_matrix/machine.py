"""The machine: its compilers, and what it is to be called beside results."""
import os
import pathlib
import platform
import shutil
import subprocess
import sys

CLANG_PACKAGES = ("clang-14", "libclang-rt-14-dev")  # the second: the sanitizers' libraries


def output(*command, folder=None):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else ""


def install_clang():
    """On Debian as root; elsewhere nothing."""
    release = pathlib.Path("/etc/os-release")
    if os.geteuid() != 0 or not release.exists() or "ID=debian" not in release.read_text().splitlines():
        return
    print(f"Installing: {' '.join(CLANG_PACKAGES)}", flush=True)
    environment = dict(os.environ, DEBIAN_FRONTEND="noninteractive")
    for step in (["update", "-q"], ["install", "-q", "-y", "--no-install-recommends", *CLANG_PACKAGES]):
        subprocess.run(["apt-get", *step], env=environment, stdout=sys.stderr, check=False)


def compiler(name):
    """The program of g++ or clang++; None where there is none."""
    names = ("clang++-14", "clang++") if name == "clang++" else (name,)
    if name == "clang++" and not any(map(shutil.which, names)):
        install_clang()
    return next(filter(None, map(shutil.which, names)), None)


def processor():
    """Its name and its flags."""
    name, flags = platform.machine(), set()
    information = pathlib.Path("/proc/cpuinfo")
    for line in information.read_text().splitlines() if information.exists() else []:
        key, _, value = line.partition(":")
        if key.strip() == "model name":
            name = value.strip()
        elif key.strip() == "flags":
            flags = set(value.split())
    return name, flags


def missing(configuration, program):
    """Why a configuration cannot be built or run here; empty where it can."""
    if program is None:
        return f"{configuration.compiler} is not installed (Debian: {CLANG_PACKAGES[0]})"
    if platform.machine() != "x86_64":
        return f"this is {platform.machine()}, not x86-64" if "x86-64" in configuration.flags else ""
    absent = [flag for flag in configuration.needs if flag not in processor()[1]]
    return f"the processor has no {', '.join(absent)}" if absent else ""


def commit(root):
    changed = " with changes" if output("git", "status", "--porcelain", folder=root) else ""
    return (output("git", "rev-parse", "--short", "HEAD", folder=root) or "unknown") + changed


def description(root, compilers):
    versions = [output(program, "--version").splitlines()[0] for program in compilers if program]
    library = " ".join(platform.libc_ver())
    return f"{processor()[0]}, {os.cpu_count()} processors, {library}, {', '.join(versions)}, commit {commit(root)}"
