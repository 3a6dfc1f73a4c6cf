"""Draws the project's textures: python3 tools/make-textures [DIRECTORY]

Needs nothing but Python's standard library. DIRECTORY is textures/ of the project if not given. It takes
two minutes; the same pictures come out every time.
"""

import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # no __pycache__ in the sources

from clouds import Clouds
from earth import Earth
from materials import Marble, Planks
from patterns import Bricks, checker, tiles
from picture import draw
from relief import Hills, studs
from sky import Sky
from stars import Stars
from uv_grid import uv_grid

# name: (width, height, what makes the function of (u, v), samples along a pixel's side)
TEXTURES = {
    "checker.png": (512, 512, lambda: checker, 1),
    "uv-grid.png": (512, 512, lambda: uv_grid, 1),
    "brick.png": (320, 320, Bricks, 2),
    "wood.png": (320, 320, Planks, 2),
    "marble.png": (320, 320, Marble, 1),
    "earth-like.png": (512, 256, Earth, 1),
    "clouds.png": (512, 256, Clouds, 1),
    "hills.png": (96, 96, Hills, 1),
    "studs-normal.png": (256, 256, lambda: studs, 1),
    "tiles.bmp": (256, 256, lambda: tiles, 3),
    "stars.png": (512, 512, Stars, 1),
}
SKY_SIZE = 256


def main():
    project = pathlib.Path(__file__).resolve().parent.parent.parent
    arguments = argparse.ArgumentParser(prog="make-textures", description="Draw the project's textures.")
    arguments.add_argument("directory", nargs="?", type=pathlib.Path, default=project / "textures")
    directory = arguments.parse_args().directory
    for name, (width, height, make, samples) in TEXTURES.items():
        draw(width, height, make(), samples).write(directory / name)
        print(name, flush=True)
    for name, picture in Sky().faces(SKY_SIZE):
        picture.write(directory / "sky" / f"{name}.png")
        print(f"sky/{name}.png", flush=True)


if __name__ == "__main__":
    main()
