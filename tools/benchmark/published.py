"""What is known of others without running them: the course's reference renderer, of which there is no program here,
and floors. Medians on a machine with two processors of the kind that the goals were set for, 512 pixels wide, `-r 5`.
"""

# Milliseconds of the whole process with one thread and with two.
REFERENCE = {
    "polymesh/dragon": (334, 276), "polymesh/trimesh1": (208, 188), "polymesh/trimesh2": (34700, 19100),
    "polymesh/trimesh3": (1150, 710), "polymesh/easy4": (396, 253), "sphere_box": (257, 139),
    "reflection2": (232, 141), "hitchcock": (128, 73), "simple/cylinder_refract": (81, 78),
    "simple/box_cyl_reflect": (47, 51)}

# Milliseconds with two threads: parsing at the speed of a hand-made reader, Embree's hierarchy and packets, and PNG.
FLOORS = {"polymesh/dragon": 19, "polymesh/trimesh1": 19, "polymesh/trimesh2": 66, "polymesh/trimesh3": 53}

# Their scenes are of spheres, boxes, cylinders and squares.
OF_PRIMITIVES = ("sphere_box", "reflection2", "hitchcock", "simple/cylinder_refract", "simple/box_cyl_reflect")
