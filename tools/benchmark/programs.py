"""Programs that are run, and what they print."""
import re
import subprocess


class Failure(Exception):
    pass


def output(command, text="", streams="stdout"):
    """Of a command that has to succeed: its standard output, or both where `streams` says so."""
    errors = subprocess.STDOUT if streams == "both" else subprocess.PIPE
    done = subprocess.run([str(word) for word in command], input=text, stdout=subprocess.PIPE, stderr=errors, text=True,
                          check=False)
    if done.returncode != 0:
        said = (done.stdout if streams == "both" else done.stderr) or ""
        tail = "\n".join(said.splitlines()[-12:])
        raise Failure(f"{' '.join(map(str, command))} ended with status {done.returncode}:\n{tail}")
    return done.stdout


def lines(text, first):
    """The lines of words key=value that begin with the word `first`, each as a dictionary."""
    return [dict(word.split("=", 1) for word in line.split() if "=" in word)
            for line in text.splitlines() if line.split(" ", 1)[0] == first]


def statistics_of(trace, scene, output_file, *arguments):
    """What `trace --stats` reports of a picture: milliseconds of each stage by name, and "memory" in MB."""
    # By way of a shell that starts it from its own small self: the most memory that the system counts for a process
    # includes that of the process it was started from.
    text = output(["sh", "-c", '"$@"; exit $?', "sh", trace, "--stats", "-q", *arguments, scene, output_file],
                  streams="both")
    found = {name: float(value) for value, name in re.findall(r"([\d.]+) ms (\w+)", text)}
    memory = re.search(r"memory +([\d.]+) MB", text)
    triangles = re.search(r"(\d+) triangles", text)
    if not found or not memory:
        raise Failure(f"{trace} --stats says nothing of times and memory:\n{text}")
    return dict(found, memory=float(memory.group(1)), triangles=int(triangles.group(1)) if triangles else 0)


def process_runs(kernels, commands, rounds):
    """Runs of whole processes in turns, by command: lists of dictionaries of wall_ms, user_ms, peak_kilobytes."""
    text = "".join("\t".join(map(str, command)) + "\n" for command in commands)
    runs = [[] for _ in commands]
    for line in lines(output([kernels, "processes", "--rounds", rounds], text), "process"):
        if line["status"] != "0":
            failed = " ".join(map(str, commands[int(line["command"])]))
            raise Failure(f"{failed} ended with status {line['status']}")
        runs[int(line["command"])].append({key: float(line[key]) for key in ("wall_ms", "user_ms", "peak_kilobytes")})
    return runs
