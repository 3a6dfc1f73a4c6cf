"""The tests of a build."""
import dataclasses
import re
import subprocess

# The folders of tests/ where arithmetic decides. What else there is (reports, processes, the parser) is the business of
# tools/test.
FOLDERS = ("geometry", "acceleration", "scene", "shading", "rendering", "hard", "properties", "metamorphic")


@dataclasses.dataclass
class Outcome:
    told: str
    complaints: list


NONE = Outcome("-", [])


def selection(root):
    """Catch2's -# gives each test its file's name as a tag: all files of the folders, one of them suffices."""
    files = sorted(file.stem for folder in FOLDERS for file in (root / "tests" / folder).glob("*.cpp"))
    return ["-#", ",".join(f"[#{stem}]" for stem in files)]


def outcome(root, build, every):
    """Runs all tests if `every`, else those of FOLDERS."""
    done = subprocess.run([build.tests, *([] if every else selection(root))], env=build.environment,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    counts = re.search(r"in (\d+) test case", done.stdout) or re.search(r"test cases: +(\d+)", done.stdout)
    count = counts.group(1) if counts else "?"
    if done.returncode == 0 and counts and int(count) > 0:
        return Outcome(f"{count} passed", [])
    failed = re.search(r"test cases:.*?(\d+) failed", done.stdout)
    # Catch2 heads each failure with the test's name between two lines of dashes.
    name = re.search(r"^-{20,}\n(.+?)\n-{20,}$", done.stdout, re.M | re.S)
    lines = (done.stderr.strip() or done.stdout.strip() or "nothing said").splitlines()
    said = name.group(1).splitlines()[0] if name else lines[-1]
    return Outcome(f"{failed.group(1) if failed else '?'} of {count} failed",
                   [f"trace_tests ended with status {done.returncode}; the first failure: {said}"])
