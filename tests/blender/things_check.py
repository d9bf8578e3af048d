"""Run by things_test.cpp in Blender: -- TEMPLATES FOLDER OUT. A slab and a lamp of a user's own.

Pictures of the landscape alone, with the slab's shadow, with the slab moved, with a lamp, and of a
second frame that clouds shade with and without the slab; nothing of the user's is seen. Then the
example with a hut.
"""

import os
import runpy
import sys

import bpy

templates, folder, out = sys.argv[sys.argv.index("--") + 1 :]
sys.path.insert(0, templates)

import wold_blender  # noqa: E402

wold_blender.register()
bpy.data.batch_remove(list(bpy.data.objects))
scene = bpy.context.scene


def unseen(thing, things):
    thing.visible_camera = False
    things.objects.link(thing)
    return thing


def slab(things):
    """0.6 m by 1.4 m, a metre above the ground."""
    mesh = bpy.data.meshes.new("slab")
    corners = [(x, y, z) for z in (0, 0.02) for y in (0.8, 2.2) for x in (0.9, 1.5)]
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    mesh.from_pydata(corners, (), faces)
    thing = bpy.data.objects.new("slab", mesh)
    thing.location.z = 1
    return unseen(thing, things)


def lamp(things):
    light = bpy.data.lights.new("lamp", "POINT")
    light.energy = 20000
    if hasattr(light, "exposure"):
        light.energy, light.exposure = 5000, 2
    light.color = (1, 0.5, 0.25)
    thing = bpy.data.objects.new("lamp", light)
    thing.location = (1.5, 1.5, 30)
    return unseen(thing, things)


def render(name):
    assert scene.wold.problem == "", scene.wold.problem
    scene.render.filepath = os.path.join(out, name + ".exr")
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    bpy.ops.render.render(write_still=True)


def made():
    """Groups of shader nodes and pictures that are not of files."""
    return len([tree for tree in bpy.data.node_groups if tree.type == "SHADER"]) + len(
        [
            picture
            for picture in bpy.data.images
            if picture.source == "GENERATED" or picture.packed_file
        ]
    )


shading, lighting = (bpy.data.collections.new(name) for name in ("shading", "lighting"))
for things in (shading, lighting):
    scene.collection.children.link(things)
roof, bulb = slab(shading), lamp(lighting)
assert bpy.ops.import_scene.wold(directory=folder) == {"FINISHED"}
before = made()
render("open")
scene.wold.things = shading
assert made() == before + 2
render("shaded")
scene.frame_set(1)
assert made() == before + 2, "traced twice"
for place in (0.3, -0.4):  # twice: the second tracing removes what the first has made
    roof.location.x = place
    scene.frame_set(1)
render("moved")
assert made() == before + 2
roof.scale.x, roof.location.x, roof.location.z = 20, -58, 30
scene.frame_set(1)
render("high")
roof.scale.x, roof.location.x, roof.location.z = 1, -0.4, 1
scene.frame_set(2)
render("cloudy")
scene.wold.things = lighting
render("lamp")
scene.wold.things = None
assert made() == before
render("cloudy_open")
scene.wold.things = shading
assert made() == before + 2
bpy.context.view_layer.update()
wold_blender.interface.forget_edits()
shading.objects.unlink(roof)
bpy.context.view_layer.update()
assert bpy.app.timers.is_registered(wold_blender.interface.light_anew), "not seen to go"
wold_blender.interface.light_anew()
assert made() == before, "what has gone keeps its shadow"
shading.objects.link(roof)
wold_blender.interface.light_anew()
assert made() == before + 2
assert bpy.ops.scene.wold_remove() == {"FINISHED"}
assert made() == 0

# The example for users runs on any landscape.
sys.argv = ["", "--", folder, os.path.join(out, "hut.png")]
scene.render.image_settings.file_format = "PNG"
example = os.path.join(os.path.dirname(__file__), "../../examples/blender/hut_and_lamp.py")
runpy.run_path(example, run_name="__main__")
assert scene.wold.problem == "" and made() == 2

# The package bpy 4.5 waits for a thread of its own when Python ends after such scenes.
sys.stdout.flush()
os._exit(0)
