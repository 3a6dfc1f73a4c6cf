"""The stages in the order of the table. Each module has its name, STAGE, and groups(context), which gives what is
measured (group.Group)."""
from . import start_up, parsing, hierarchy, rays, primitives, whole, scaling, memory, png, growth

ALL = (start_up, parsing, hierarchy, rays, primitives, whole, scaling, memory, png, growth)
