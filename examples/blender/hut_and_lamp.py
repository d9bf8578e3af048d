"""A hut and a lamp of your own in the meadow of examples/hillside.toml.

    wold generate examples/hillside.toml --renderer blender
    blender -b -P examples/blender/hut_and_lamp.py -- out/hillside/blender hut.png

The add-on "Wold landscape" has to be installed (docs/for_blender_users.md). The hut shades grass
and ground, and grass hides its foot. The lamp is for dusk: generate with --set sun.elevation=-2.
"""

import os
import sys

import bpy
from mathutils import Matrix, Vector

folder, picture = (os.path.abspath(each) for each in sys.argv[sys.argv.index("--") + 1 :])
# The walls' corners below and above, and the ridge of the roof, metres.
LENGTH, WIDTH, WALL, RIDGE, EAVES = 2.6, 1.8, 1.3, 2.1, 0.25


def paint(name, colour):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree
    nodes.nodes.clear()
    surface = nodes.nodes.new("ShaderNodeBsdfDiffuse")
    surface.inputs["Color"].default_value = (*colour, 1)
    nodes.links.new(surface.outputs[0], nodes.nodes.new("ShaderNodeOutputMaterial").inputs[0])
    return material


def add(things, name, points, faces, colour):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, (), faces)
    mesh.materials.append(paint(name, colour))
    thing = bpy.data.objects.new(name, mesh)
    things.objects.link(thing)
    return thing


def walls(things):
    """Four, two of which are gables; they reach into the ground."""
    x, y = LENGTH / 2, WIDTH / 2
    foot = [(-x, -y, -0.6), (x, -y, -0.6), (x, y, -0.6), (-x, y, -0.6)]
    top = [(px, py, WALL) for px, py, _ in foot]
    ridge = [(-x, 0, RIDGE), (x, 0, RIDGE)]
    faces = ((0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 9, 5), (3, 0, 4, 8, 7))
    return add(things, "walls", foot + top + ridge, faces, (0.23, 0.15, 0.09))


def roof(things):
    """Two slopes that reach beyond the walls."""
    x, rise = LENGTH / 2 + EAVES, (RIDGE - WALL) / (WIDTH / 2)
    y, low = WIDTH / 2 + EAVES, WALL - EAVES * rise
    points = [
        (side * x, across, height + 0.03)
        for across, height in ((-y, low), (0, RIDGE), (y, low))
        for side in (-1, 1)
    ]
    return add(things, "roof", points, ((0, 1, 3, 2), (2, 3, 5, 4)), (0.30, 0.10, 0.07))


def lamp(things):
    light = bpy.data.lights.new("lamp", "POINT")
    light.energy = 60  # by eye: the landscape's light is in units of its own
    light.color = (1.0, 0.65, 0.3)
    light.shadow_soft_size = 0.05
    thing = bpy.data.objects.new("lamp", light)
    things.objects.link(thing)
    return thing


def ground_height(x, y):
    terrain = next(thing for thing in bpy.data.objects if thing.name.startswith("terrain"))
    found, place, _, _ = terrain.ray_cast(Vector((x, y, 10000)), Vector((0, 0, -1)))
    return place.z if found else 0.0


for thing in ("Cube", "Light"):  # of a new file
    if thing in bpy.data.objects:
        bpy.data.objects.remove(bpy.data.objects[thing])
scene = bpy.context.scene
bpy.ops.import_scene.wold(directory=folder)
things = bpy.data.collections.new("things")
scene.collection.children.link(things)
hut = Matrix.Translation((19.6, 11.5, ground_height(19.6, 11.5))) @ Matrix.Rotation(0.5, 4, "Z")
for part in (walls(things), roof(things)):
    part.matrix_world = hut
lamp(things).location = (22.2, 9.6, ground_height(22.2, 9.6) + 1.4)
bpy.context.view_layer.update()
scene.wold.things = things
scene.render.filepath = picture
scene.cycles.samples = 16
bpy.ops.render.render(write_still=True)
