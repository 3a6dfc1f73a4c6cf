"""How large a picture is."""
from . import programs


def pixels(trace, scene, width, picture):
    """Of the picture that is drawn of a scene; it is drawn for this."""
    programs.output([trace, "-q", "-w", width, scene, picture])
    with open(picture, "rb") as file:
        header = file.read(24)  # signature, length and name of IHDR, width, height
    return int.from_bytes(header[16:20], "big") * int.from_bytes(header[20:24], "big")
