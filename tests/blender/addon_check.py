"""Run by addon_test.cpp in Blender: -- ARCHIVE FOLDER PICTURE. Uses the add-on as a user would."""

import os
import sys

import bpy

# isort: split
import addon_utils  # found only when bpy is loaded, where that is a package of Python

archive, folder, picture = sys.argv[sys.argv.index("--") + 1 :]


def install():
    """As Preferences do; the name of the module that is enabled."""
    if bpy.app.version >= (4, 2):
        bpy.ops.extensions.package_install_files(
            filepath=archive, repo="user_default", enable_on_install=True
        )
        return "bl_ext.user_default.wold_blender"
    bpy.ops.preferences.addon_install(filepath=archive)
    bpy.ops.preferences.addon_enable(module="wold_blender")
    return "wold_blender"


def marked(kind):
    return [thing for thing in getattr(bpy.data, kind) if thing.get("wold_landscape")]


def instances():
    """Volumes that the geometry nodes place."""
    graph = bpy.context.evaluated_depsgraph_get()
    return sum(each.is_instance and each.object.type == "VOLUME" for each in graph.object_instances)


def counts():
    kinds = ("objects", "collections", "meshes", "volumes", "node_groups", "worlds", "images")
    return [len(getattr(bpy.data, kind)) for kind in kinds]


def only(things):
    (thing,) = things
    return thing


FIRST, SECOND = 35, 36 - 1 - 6  # cells that are volumes

module = install()
scene = bpy.context.scene
own = bpy.data.objects["Cube"]

# What is no landscape changes nothing.
things = len(bpy.data.objects)
try:
    bpy.ops.import_scene.wold(directory=os.path.dirname(archive))
    raise SystemExit("a folder without a landscape was imported")
except RuntimeError as error:
    assert "has no frames" in str(error), error
assert len(bpy.data.objects) == things and scene.wold.folder == ""

# An import is one step of undo. A step back and forth builds nothing: it is there again.
bpy.ops.ed.undo_push(message="before")
assert bpy.ops.import_scene.wold(directory=folder) == {"FINISHED"}
assert scene.wold.frame == 1 and scene.wold.problem == ""
bpy.ops.ed.undo_push(message="imported")
bpy.ops.ed.undo()
scene = bpy.context.scene
assert scene.wold.folder == "" and instances() == 0 and not marked("objects")
bpy.ops.ed.redo()
scene = bpy.context.scene
own = bpy.data.objects["Cube"]
assert scene.wold.frame == 1
assert instances() == FIRST, instances()
lamp = only(marked("lights"))
assert abs(lamp.energy - 0.9) < 1e-6, lamp.energy
bpy.context.view_layer.update()
sun = next(thing for thing in marked("objects") if thing.data == lamp)
assert abs(sun.matrix_world.col[2][0] + 0.6) < 1e-5 and abs(sun.matrix_world.col[2][2] - 0.8) < 1e-5

# The timeline: frames follow, the ends are held, nothing is built anew without need.
camera = scene.camera
at_first = tuple(camera.location)
there = counts()
scene.frame_set(2)
assert scene.wold.frame == 2 and instances() == SECOND, (scene.wold.frame, instances())
assert abs(camera.location[1] - at_first[1] + 1.0) < 1e-5, "the camera did not follow"
at_second = tuple(camera.location), tuple(camera.rotation_euler)
assert counts() == there, ("things pile up", counts(), there)
terrain = next(thing for thing in marked("objects") if thing.name.startswith("terrain"))
for number in (3, 250, 2):
    scene.frame_set(number)
    assert scene.wold.frame == 2
assert terrain == next(t for t in marked("objects") if t.name.startswith("terrain")), "rebuilt"
scene.frame_set(-5)
assert scene.wold.frame == 1 and instances() == FIRST
scene.wold.start = 11
scene.frame_set(12)
assert scene.wold.frame == 2
scene.frame_set(1)

# What the user has moved stays.
camera.location[0] += 1.0
scene.wold.start = 1
scene.frame_set(2)
assert abs(camera.location[0] - at_first[0] - 1.0) < 1e-5, "the user's camera was moved"
scene.frame_set(1)

# The panel: detail, sun, degree.
steps = {material.name: material.cycles.volume_step_rate for material in marked("materials")}
scene.wold.detail = 0.5
scene.wold.sun = 2
for material in marked("materials"):
    assert abs(material.cycles.volume_step_rate - 2 * steps[material.name]) < 1e-5
assert abs(only(marked("lights")).energy - 1.8) < 1e-6
scene.wold.degree = 0.35  # still nearer to the first
assert scene.wold.frame == 1 and scene.wold.picked_by == "DEGREE"
scene.wold.degree = 0.5
assert scene.wold.frame == 2 and scene.wold.problem == "", scene.wold.problem
scene.frame_set(1)
assert scene.wold.frame == 2, "the degree picks now"
assert instances() == SECOND, instances()
assert counts() == there, ("things pile up", counts(), there)
assert abs(only(marked("lights")).energy - 1.8) < 1e-6
assert own.name in scene.collection.all_objects

# The picture is that of the command line.
scene.wold.detail = 1
camera.location, camera.rotation_euler = at_second
own.hide_render = True
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)

# A frame whose data are damaged leaves the one that is shown.
os.truncate(os.path.join(folder, "data", "frame_0001", "heights_m.f32"), 10)
scene.wold.degree = 0
assert scene.wold.frame == 2 and "is damaged" in scene.wold.problem, scene.wold.problem
assert instances() == SECOND

assert bpy.ops.scene.wold_remove() == {"FINISHED"}
assert not any(marked(kind) for kind in ("objects", "volumes", "meshes", "materials", "images"))
assert own.name in scene.collection.all_objects and camera.name in scene.collection.all_objects

addon_utils.disable(module)
assert not hasattr(bpy.types.Scene, "wold") and not hasattr(bpy.types, "VIEW3D_PT_wold")
handlers = bpy.app.handlers.frame_change_pre
assert not [each for each in handlers if "wold" in each.__module__], handlers[:]
assert addon_utils.enable(module) is not None  # and again
