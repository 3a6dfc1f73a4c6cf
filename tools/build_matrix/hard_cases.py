"""The digests of the hard cases (tests/hard): everything that their rays hit, to the last bit."""
import dataclasses
import hashlib
import subprocess


@dataclasses.dataclass
class HardCases:
    lines: list  # as the program prints them, one a case and form
    complaints: list
    told: str


def digests(build, rays_scale):
    if build.hard_cases is None:
        return HardCases([], [], "skipped: no target")
    done = subprocess.run([build.hard_cases, "--digest", "--rays-scale", rays_scale], env=build.environment,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    complaints = []
    if done.returncode != 0:
        said = (done.stderr.strip() or done.stdout.strip() or "nothing said").splitlines()
        complaints.append(f"hard_cases ended with status {done.returncode}: {said[0]}")
    lines = done.stdout.splitlines()
    whole = hashlib.sha256(done.stdout.encode()).hexdigest()
    return HardCases(lines, complaints, f"{len(lines)} {whole[:16]}")


def difference(first, other):
    """Names the first case that differs; None where there is none."""
    if first.lines == other.lines:
        return None
    for one, two in zip(first.lines, other.lines):
        if one != two:
            return f"a hard case differs: {two}\n    where the first has: {one}"
    return f"{len(other.lines)} hard cases, where the first has {len(first.lines)}"
