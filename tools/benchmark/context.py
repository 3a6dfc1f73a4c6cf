"""What the stages need to know."""
import dataclasses
import pathlib

from . import building, scenes


@dataclasses.dataclass
class Context:
    build: building.Build       # what is measured; its bench_kernels also starts the processes of all others
    anchors: building.Anchors
    scenes: scenes.Scenes
    scratch: pathlib.Path       # for pictures
    quick: bool

    @property
    def picture(self):
        return self.scratch / "picture.png"

    def rounds(self, count):
        return 1 if self.quick else count
