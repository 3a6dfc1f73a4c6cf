"""The pictures of every scene with its arguments, as digests."""
import concurrent.futures
import dataclasses
import hashlib
import pathlib
import subprocess
import tempfile

TABLES = ("scenes", "tests/picture_cases", "../shared/corpus")  # folders with a manifest.tsv
TIMEOUT = 3600  # seconds for one scene, which only a program that hangs needs


@dataclasses.dataclass(frozen=True)
class Scene:
    folder: pathlib.Path  # names in the arguments are relative to it
    file: str
    arguments: tuple

    @property
    def name(self):
        return f"{self.folder.name}/{self.file} ({' '.join(self.arguments)})"


@dataclasses.dataclass
class Drawn:
    build: object
    digests: dict  # by Scene
    complaints: list

    @property
    def told(self):
        whole = hashlib.sha256("".join(self.digests.values()).encode()).hexdigest()
        return f"{len(self.digests)} {whole[:16]}"


def scenes(root, width):
    """In the order of the tables. Those that the reference refuses too: what they print is compared."""
    found = {}
    for folder in (root / table for table in TABLES):
        if not (folder / "manifest.tsv").exists():
            continue
        for line in (folder / "manifest.tsv").read_text().splitlines()[1:]:
            file, arguments = line.split("\t")[:2]
            found[Scene(folder.resolve(), file, tuple(narrowed(arguments.split(), width)))] = None
    return list(found)


def narrowed(words, width):
    if width and "-w" in words:
        at = words.index("-w") + 1
        words[at] = str(min(width, int(words[at])))
    return words


def render(build, scene, output):
    """The exit status, the messages and the picture's bytes; a BMP, so that no compression comes between."""
    try:
        done = subprocess.run([build.trace, *scene.arguments, "-t", "1", scene.file, output], cwd=scene.folder,
                              env=build.environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=TIMEOUT,
                              check=False)
    except subprocess.TimeoutExpired:
        return -1, b"timeout", b""
    picture = output.read_bytes() if output.exists() else b""
    output.unlink(missing_ok=True)
    return done.returncode, done.stderr.replace(bytes(output), b"OUTPUT"), picture


def drawn(root, build, width, jobs):
    todo = scenes(root, width)
    complaints = []
    with tempfile.TemporaryDirectory() as scratch:

        def digest(numbered):
            number, scene = numbered
            status, messages, picture = render(build, scene, pathlib.Path(scratch) / f"{number}.bmp")
            if status not in (0, 1):
                text = messages.decode(errors="replace").strip().splitlines()
                telling = [line for line in text if "runtime error" in line or "ERROR: " in line] or text[-1:]
                complaints.append(f"{scene.name}: trace ended with status {status}: {' '.join(telling[:1])}")
            return hashlib.sha256(b"%d\n%s\n" % (status, messages) + picture).hexdigest()

        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            digests = dict(zip(todo, pool.map(digest, enumerate(todo))))
    return Drawn(build, digests, complaints)


def difference(first, other):
    """Names the first scene that differs, and by how much; None where there is none."""
    differing = [scene for scene, digest in first.digests.items() if other.digests[scene] != digest]
    if not differing:
        return None
    scene = differing[0]
    with tempfile.TemporaryDirectory() as scratch:
        results = [render(drawn.build, scene, pathlib.Path(scratch) / "out.bmp") for drawn in (first, other)]
    (status, messages, a), (other_status, other_messages, b) = results
    if status != other_status:
        how = f"exit status {status} and {other_status}"
    elif a == b:
        how = "other messages" if messages != other_messages else "not again when drawn once more"
    elif len(a) != len(b):
        how = "another size"
    else:
        levels = [abs(one - two) for one, two in zip(a, b) if one != two]
        how = f"{len(levels)} of {len(a)} bytes, by {max(levels)} levels at most"
    return f"{len(differing)} pictures differ, the first: {scene.name}: {how}"
