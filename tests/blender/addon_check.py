"""Run by addon_test.cpp in Blender: -- ADDON FOLDER ADDONS_FOLDER PICTURE."""

import os
import shutil
import sys

import addon_utils
import bpy

addon, folder, elsewhere, picture = sys.argv[sys.argv.index("--") + 1:]


def marked(kind):
    return [thing for thing in getattr(bpy.data, kind) if thing.get("wold_landscape")]


def instances():
    """Volumes that the geometry nodes place."""
    graph = bpy.context.evaluated_depsgraph_get()
    return sum(each.is_instance and each.object.type == "VOLUME" for each in graph.object_instances)


# Installed by itself, far from scene.py.
shutil.copy(addon, elsewhere)
sys.path.insert(0, elsewhere)
name = os.path.splitext(os.path.basename(addon))[0]
assert addon_utils.enable(name) is not None
scene = bpy.context.scene
own = bpy.data.objects["Cube"]

# What is no landscape changes nothing.
things = len(bpy.data.objects)
try:
    bpy.ops.import_scene.wold(directory=elsewhere)
    raise SystemExit("a folder without a landscape was imported")
except RuntimeError as error:
    assert "has no scene.py" in str(error), error
assert len(bpy.data.objects) == things and scene.wold.folder == ""

assert bpy.ops.import_scene.wold(directory=folder) == {"FINISHED"}
assert scene.wold.frame == 1 and scene.wold.problem == ""
assert instances() == 35, instances()  # 36 cells, one of blades
lamp = marked("lights")[0]
assert abs(lamp.energy - 0.9) < 1e-6, lamp.energy
bpy.context.view_layer.update()
sun = next(thing for thing in marked("objects") if thing.data == lamp)
assert abs(sun.matrix_world.col[2][0] + 0.6) < 1e-5 and abs(sun.matrix_world.col[2][2] - 0.8) < 1e-5

# The panel: detail, sun, degree.
steps = {material.name: material.cycles.volume_step_rate for material in marked("materials")}
scene.wold.detail = 0.5
scene.wold.sun = 2
for material in marked("materials"):
    assert abs(material.cycles.volume_step_rate - 2 * steps[material.name]) < 1e-5
assert abs(lamp.energy - 1.8) < 1e-6
kinds = ("objects", "collections", "meshes", "volumes", "node_groups", "worlds", "images", "lights")
counts = [len(getattr(bpy.data, kind)) for kind in kinds]
scene.wold.degree = 0.35  # still nearer to the first
assert scene.wold.frame == 1 and sun.name in bpy.data.objects
scene.wold.degree = 0.5
assert scene.wold.frame == 2 and scene.wold.problem == "", scene.wold.problem
assert instances() == 36 - 1 - 6, instances()
assert counts == [len(getattr(bpy.data, kind)) for kind in kinds]  # nothing piles up
assert abs(marked("lights")[0].energy - 1.8) < 1e-6
assert own.name in scene.collection.all_objects

# The picture is scene.py's.
scene.wold.detail = 1
own.hide_render = True
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)

# A frame whose data are damaged leaves the one that is shown.
os.truncate(os.path.join(folder, "data", "frame_0001", "heights_m.f32"), 10)
scene.wold.degree = 0
assert scene.wold.frame == 2 and "is damaged" in scene.wold.problem, scene.wold.problem
assert instances() == 36 - 1 - 6

addon_utils.disable(name)
assert not hasattr(bpy.types.Scene, "wold") and not hasattr(bpy.types, "VIEW3D_PT_wold")
assert addon_utils.enable(name) is not None  # and again
