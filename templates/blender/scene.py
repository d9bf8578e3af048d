"""Renders one frame of the meadow with Blender 3.4 (Cycles on the CPU).

    blender -b --python-exit-code 1 -P scene.py -- 1
    blender -b --python-exit-code 1 -P scene.py -- 3 --size 1920x1080 --samples 16 --out third.png
    blender -P scene.py -- 1 --look            opens the scene in the window instead

Needs nothing but Blender and the folder `data` beside this file. All light is baked: the grass
volumes, the ground and the sky emit what reaches the eye, so there are no lamps, no bounces and no
noise but the steps along a ray, and a few samples per pixel are enough.

Lengths are metres; x points east, y north, z up.
"""

import argparse
import array
import contextlib
import itertools
import json
import math
import os
import re
import sys
import threading

import bpy
from mathutils import Vector

HERE = os.path.dirname(os.path.abspath(__file__))


class DataError(Exception):
    """A file of the frame is missing or damaged."""


# The frame's data ---------------------------------------------------------------------------


class Frame:
    """frame.json and the files it names."""

    def __init__(self, number, folder=HERE):
        self.folder = os.path.join(folder, "data", f"frame_{number:04d}")
        self.images = {}
        try:
            with open(self.path("frame.json"), encoding="utf-8") as file:
                self.data = json.load(file)
        except (OSError, ValueError) as error:
            raise DataError(f"cannot read {self.path('frame.json')}: {error}") from error

    def __getitem__(self, key):
        return self.data[key]

    def path(self, name):
        return os.path.normpath(os.path.join(self.folder, name))

    def numbers(self, name, typecode, count):
        """A raw little-endian array ('f' float32, 'i' int32) of `count` numbers."""
        values = array.array(typecode)
        check_size(self.path(name), count * values.itemsize)
        with open(self.path(name), "rb") as file:
            values.frombytes(file.read())
        if sys.byteorder == "big":
            values.byteswap()
        return values

    def image(self, name):
        """A picture of linear light, taken as it is. Materials share it: to look at its size is to
        read all of it."""
        if name not in self.images:
            self.images[name] = load_image(self.path(name))
        return self.images[name]


def load_image(path):
    try:
        image = bpy.data.images.load(path, check_existing=True)
    except RuntimeError as error:
        raise DataError(f"cannot read {path}: {error}") from error
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"  # four numbers, not a colour and how opaque it is
    if min(image.size) == 0:
        raise DataError(f"{path} is damaged")
    return image


def check_size(path, expected):
    found = os.path.getsize(path) if os.path.exists(path) else None
    if found is None:
        raise DataError(f"{path} is missing")
    if found != expected:
        raise DataError(f"{path} is damaged: it has {found} bytes, {expected} were expected")


# Materials ----------------------------------------------------------------------------------


class Nodes:
    """A node tree that is being filled: nodes by type, links by the sockets' names."""

    def __init__(self, tree):
        tree.nodes.clear()
        self.tree = tree

    def add(self, kind, **settings):
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        return node

    def link(self, source, target):
        self.tree.links.new(source, target)


def constant(nodes, colour):
    """An output socket: the same three numbers everywhere."""
    output = nodes.add("ShaderNodeRGB").outputs["Color"]
    output.default_value = (*colour, 1.0)
    return output


def map_outputs(nodes, frame, ground_map, extension="EXTEND"):
    """Colour and Alpha of a map of the ground at the shaded point, as output sockets.

    The map's values lie on the corners of its grid, the first and last on its border, which is the
    terrain's unless it has a corner of its own; a picture's lie in the middle of its pixels."""
    corner_m = ground_map.get("corner_m", (0, 0))
    samples, size_m = ground_map["samples"], ground_map["size_m"]
    scale = (samples - 1) / (samples * size_m)
    position = nodes.add("ShaderNodeNewGeometry").outputs["Position"]
    # Not a Mapping node: it works out its rotation anew at every step of every ray.
    place = nodes.add("ShaderNodeVectorMath", operation="MULTIPLY_ADD")
    place.inputs[1].default_value = (scale, scale, 0)
    place.inputs[2].default_value = (*(0.5 / samples - scale * edge for edge in corner_m), 0)
    picture = nodes.add("ShaderNodeTexImage", image=frame.image(ground_map["file"]),
                        extension=extension)
    nodes.link(position, place.inputs[0])
    nodes.link(place.outputs["Vector"], picture.inputs["Vector"])
    return picture.outputs


def new_material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.cycles.sample_as_light = False  # nothing here is lit by anything else
    return material, Nodes(material.node_tree)


def glow(nodes, colour):
    """The surface's radiance is `colour`, an output socket."""
    emission = nodes.add("ShaderNodeEmission")
    nodes.link(colour, emission.inputs["Color"])
    nodes.link(emission.outputs["Emission"], nodes.add("ShaderNodeOutputMaterial").inputs["Surface"])


def medium(nodes, extinction, radiance, strength=1.0):
    """A volume shader that absorbs by `extinction` (1/m) and adds `radiance` times `strength` (per
    m); the first two are sockets."""
    absorption = nodes.add("ShaderNodeVolumeAbsorption")
    absorption.inputs["Color"].default_value = (0, 0, 0, 1)
    emission = nodes.add("ShaderNodeEmission")
    emission.inputs["Strength"].default_value = strength
    both = nodes.add("ShaderNodeAddShader")
    nodes.link(extinction, absorption.inputs["Density"])
    nodes.link(radiance, emission.inputs["Color"])
    nodes.link(absorption.outputs["Volume"], both.inputs[0])
    nodes.link(emission.outputs["Emission"], both.inputs[1])
    return both.outputs["Shader"]


def ground_material(frame):
    """The whole ground's picture, and over it the finer ones as far as they are seen."""
    material, nodes = new_material("ground")
    colour = map_outputs(nodes, frame, frame["ground"])["Color"]
    for detail in frame["ground_details"]:
        finer = map_outputs(nodes, frame, detail, "CLIP")
        seen = nodes.add("ShaderNodeMixRGB")
        nodes.link(finer["Alpha"], seen.inputs["Fac"])
        nodes.link(colour, seen.inputs["Color1"])
        nodes.link(finer["Color"], seen.inputs["Color2"])
        colour = seen.outputs["Color"]
    glow(nodes, colour)
    return material


def mixed(nodes, share, first, second):
    """A shader: the second one's share, an output socket, is `share`. Cycles passes over the side of
    a mix that is not used with all that leads to it. Nothing is where a shader is None."""
    both = nodes.add("ShaderNodeMixShader")
    nodes.link(share, both.inputs["Fac"])
    for shader, socket in ((first, both.inputs[1]), (second, both.inputs[2])):
        if shader:
            nodes.link(shader, socket)
    return both.outputs["Shader"]


def compared(nodes, value, operation, number):
    """An output socket: 1 where it holds of `value`, another, else 0."""
    comparison = nodes.add("ShaderNodeMath", operation=operation)
    comparison.inputs[1].default_value = number
    nodes.link(value, comparison.inputs[0])
    return comparison.outputs["Value"]


def grass_medium(nodes, frame, density):
    """Grid `density` absorbs, grid `emission` adds, both in `density_unit_per_m`; the map
    `standing_light` multiplies them, its alpha the first and its colour the second."""
    unit_per_m = frame["density_unit_per_m"]
    radiance = nodes.add("ShaderNodeAttribute", attribute_name="emission")
    ground = map_outputs(nodes, frame, frame["standing_light"])
    extinction = nodes.add("ShaderNodeMath", operation="MULTIPLY")
    extinction.inputs[1].default_value = unit_per_m
    standing = nodes.add("ShaderNodeMath", operation="MULTIPLY")
    lit = nodes.add("ShaderNodeVectorMath", operation="MULTIPLY")
    nodes.link(density, extinction.inputs[0])
    nodes.link(extinction.outputs["Value"], standing.inputs[0])
    nodes.link(ground["Alpha"], standing.inputs[1])
    nodes.link(radiance.outputs["Vector"], lit.inputs[0])
    nodes.link(ground["Color"], lit.inputs[1])
    return medium(nodes, standing.outputs["Value"], lit.outputs["Vector"], unit_per_m)


def inside_part(nodes):
    """An output socket: 1 in the part of its cell that an instance shows, else 0."""
    place = nodes.add("ShaderNodeTexCoord").outputs["Object"]
    middle, half = (nodes.add("ShaderNodeAttribute", attribute_type="INSTANCER",
                              attribute_name=name).outputs["Vector"]
                    for name in ("part_middles", "part_halves"))

    def vector(operation, *operands):
        node = nodes.add("ShaderNodeVectorMath", operation=operation)
        for operand, socket in zip(operands, node.inputs):
            nodes.link(operand, socket)
        return node.outputs["Vector"]

    from_middle = vector("ABSOLUTE", vector("SUBTRACT", place, middle))
    beyond = nodes.add("ShaderNodeSeparateXYZ")
    farthest = nodes.add("ShaderNodeMath", operation="MAXIMUM")
    nodes.link(vector("SUBTRACT", from_middle, half), beyond.inputs["Vector"])
    nodes.link(beyond.outputs["X"], farthest.inputs[0])
    nodes.link(beyond.outputs["Y"], farthest.inputs[1])
    return compared(nodes, farthest.outputs["Value"], "LESS_THAN", 0.0)


def grid_of(quarter):
    """The grid whose active voxels are in a quarter of the volume."""
    return f"quarter {quarter}"


def asking_for(nodes, grid, density, shader):
    """The same shader, but Cycles counts `grid` among those it needs and makes it part of the hull
    it builds. It is never looked up: all densities are below 1."""
    attribute = nodes.add("ShaderNodeAttribute", attribute_name=grid)
    emission = nodes.add("ShaderNodeEmission")
    nodes.link(attribute.outputs["Color"], emission.inputs["Color"])
    return mixed(nodes, compared(nodes, density, "GREATER_THAN", 1.0), shader,
                 emission.outputs["Emission"])


def grass_material(frame, step_voxels, quarter):
    """For volumes or, if `quarter` is not None, that quarter of them."""
    material, nodes = new_material(f"grass, step {step_voxels:.2f}, quarter {quarter}")
    material.cycles.volume_step_rate = step_voxels
    density = nodes.add("ShaderNodeAttribute", attribute_name="density").outputs["Fac"]
    shader = grass_medium(nodes, frame, density)
    if quarter is not None:
        shader = asking_for(nodes, grid_of(quarter), density, shader)
    # Where there is no grass, which is most of the air, neither light nor colour is looked up.
    shader = mixed(nodes, compared(nodes, density, "GREATER_THAN", 0.0), None, shader)
    if quarter is not None:  # the hull alone would not do: Cycles passes over a face now and then
        shader = mixed(nodes, inside_part(nodes), None, shader)
    nodes.link(shader, nodes.add("ShaderNodeOutputMaterial").inputs["Volume"])
    return material


def blades_material(frame):
    """Vertices carry their radiance in `radiance`, the map `light` tints."""
    material, nodes = new_material("blades")
    radiance = nodes.add("ShaderNodeAttribute", attribute_name="radiance")
    lit = nodes.add("ShaderNodeVectorMath", operation="MULTIPLY")
    nodes.link(radiance.outputs["Vector"], lit.inputs[0])
    nodes.link(map_outputs(nodes, frame, frame["light"])["Color"], lit.inputs[1])
    glow(nodes, lit.outputs["Vector"])
    return material


# The terrain, the sky, the camera -----------------------------------------------------------


def add_object(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def point_mesh(name, coordinates):
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(coordinates) // 3)
    mesh.vertices.foreach_set("co", coordinates)
    return mesh


def terrain_points(heights, samples, step_m):
    points = array.array("f")
    for j in range(samples):
        for i in range(samples):
            points.extend((i * step_m, j * step_m, heights[j * samples + i]))
    return points


def quad_corners(samples):
    corners = array.array("i")
    for j in range(samples - 1):
        for first in range(j * samples, (j + 1) * samples - 1):
            corners.extend((first, first + 1, first + samples + 1, first + samples))
    return corners


def quad_mesh(name, coordinates, corners):
    """`corners` are the vertices of each face, four by four."""
    mesh = point_mesh(name, coordinates)
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(corners) // 4)
    mesh.polygons.foreach_set("loop_start", array.array("i", range(0, len(corners), 4)))
    mesh.polygons.foreach_set("loop_total", array.array("i", [4]) * (len(corners) // 4))
    mesh.update(calc_edges=True)
    return mesh


def add_terrain(frame):
    terrain = frame["terrain"]
    samples = terrain["samples"]
    heights = frame.numbers(terrain["heights"], "f", samples * samples)
    points = terrain_points(heights, samples, terrain["size_m"] / (samples - 1))
    mesh = quad_mesh("terrain", points, quad_corners(samples))
    mesh.materials.append(ground_material(frame))
    add_object("terrain", mesh)


def add_fog(nodes, output, fog):
    """The world's volume: the same everywhere, without an end."""
    extinction = nodes.add("ShaderNodeValue").outputs["Value"]
    extinction.default_value = fog["extinction_per_m"]
    gained = [fog["extinction_per_m"] * channel for channel in fog["radiance"]]  # per metre
    nodes.link(medium(nodes, extinction, constant(nodes, gained)), output.inputs["Volume"])


def set_sky(frame):
    """The sky's first column looks north and azimuth runs clockwise; Blender's panorama begins in
    the west, hence the quarter-turn."""
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    world.cycles.sampling_method = "NONE"
    nodes = Nodes(world.node_tree)
    direction = nodes.add("ShaderNodeTexCoord").outputs["Generated"]
    turn = nodes.add("ShaderNodeMapping", vector_type="POINT")
    turn.inputs["Rotation"].default_value = (0, 0, math.pi / 2)
    panorama = nodes.add("ShaderNodeTexEnvironment", image=frame.image(frame["sky"]))
    background = nodes.add("ShaderNodeBackground")
    output = nodes.add("ShaderNodeOutputWorld")
    nodes.link(direction, turn.inputs["Vector"])
    nodes.link(turn.outputs["Vector"], panorama.inputs["Vector"])
    nodes.link(panorama.outputs["Color"], background.inputs["Color"])
    nodes.link(background.outputs["Background"], output.inputs["Surface"])
    if frame["fog"]:
        world.cycles.homogeneous_volume = True  # worked out at once, not step by step
        add_fog(nodes, output, frame["fog"])


def backdrop_material(frame, picture):
    material, nodes = new_material("backdrop")
    image = nodes.add("ShaderNodeTexImage", image=frame.image(picture), extension="EXTEND")
    nodes.link(nodes.add("ShaderNodeTexCoord").outputs["UV"], image.inputs["Vector"])
    glow(nodes, image.outputs["Color"])
    return material


def add_backdrop(frame):
    """What the camera sees of a sky with clouds: a picture on a rectangle far behind everything."""
    backdrop = frame["backdrop"]
    if backdrop is None:
        return
    corner, right, up = (Vector(backdrop[key]) for key in ("corner_m", "right_m", "up_m"))
    corners = (corner, corner + right, corner + right + up, corner + up)
    points = array.array("f", [number for point in corners for number in point])
    mesh = quad_mesh("backdrop", points, array.array("i", range(4)))
    mesh.uv_layers.new().data.foreach_set("uv", (0, 0, 1, 0, 1, 1, 0, 1))
    mesh.materials.append(backdrop_material(frame, backdrop["file"]))
    add_object("backdrop", mesh)


def set_camera(frame):
    view = frame["camera"]
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "HORIZONTAL"
    lens.angle = math.radians(view["field_of_view_deg"])
    lens.clip_start = 0.01
    lens.clip_end = 1000000.0
    eye = Vector(view["eye_m"])
    camera = add_object("camera", lens)
    camera.location = eye
    camera.rotation_euler = (Vector(view["target_m"]) - eye).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.camera = camera


# The grass ----------------------------------------------------------------------------------


def load_volume(frame, entry, name):
    """Blender shows a missing volume as nothing and ends abruptly on a damaged one: both are
    looked for here."""
    path = frame.path(entry["file"])
    check_size(path, entry["bytes"])
    volume = bpy.data.volumes.new(name)
    volume.filepath = path
    volume.render.space = "WORLD"  # extinction is per metre of the world, whatever the shear
    if not volume.grids.load():
        raise DataError(f"{path} is damaged: {volume.grids.error_message}")
    needed = {"density", "emission"}
    if entry.get("quarter") is not None:
        needed.add(grid_of(entry["quarter"]))
    missing = needed - {grid.name for grid in volume.grids}
    if missing:
        raise DataError(f"{path} has no grid {' and '.join(sorted(missing))}")
    volume.grids.unload()  # the renderer reads it anew
    return volume


def share_of_name(name):
    """A number in [0, 1], Jenkins' hash (the final mix of lookup3): Cycles moves a volume's hull by
    a tenth of a metre times this, over how many active voxels it has along a side."""
    bits = 0xffffffff

    def turned(word, by):
        return (word << by | word >> (32 - by)) & bits

    word = 0
    for letter in name.encode():
        word = (37 * word + letter) & bits
    words = [(0xdeadbf00 + word) & bits, 0xdeadbf00, 0xdeadbf00]
    into = 2
    for by in (14, 11, 25, 16, 4, 14, 24):
        source = words[(into + 2) % 3]
        words[into] = ((words[into] ^ source) - turned(source, by)) & bits
        into = (into + 1) % 3
    return words[2] / bits


def name_of_volume(number):
    """Names in the order of the numbers, for which Cycles moves no hull by more than a hundredth of
    what it may: quarters have to meet."""
    attempts = (f"{number:05d} {attempt}" for attempt in itertools.count())
    return next(name for name in attempts if share_of_name(name) < 0.01)


def load_volumes(frame):
    """The frame's volumes as a collection that is not itself in the scene. Blender orders its
    members by name: an instance's index counts on it."""
    collection = bpy.data.collections.new("volumes")
    materials = {}
    for number, entry in enumerate(frame["volumes"]):
        volume = load_volume(frame, entry, name_of_volume(number))
        kind = (round(entry["step_voxels"], 2), entry["quarter"])
        if kind not in materials:
            materials[kind] = grass_material(frame, *kind)
        if entry["quarter"] is not None:
            volume.render.clipping = 1.0  # more than all there is: the hull is the quarter's
        volume.materials.append(materials[kind])
        collection.objects.link(bpy.data.objects.new(volume.name, volume))
    return collection


def load_blades(frame):
    """The meshes of blades, likewise."""
    collection = bpy.data.collections.new("blades")
    material = blades_material(frame) if frame["blades"] else None
    for number, entry in enumerate(frame["blades"]):
        name = f"blades {number:05d}"
        file, count = entry["file"], entry["vertices"]
        mesh = quad_mesh(name, frame.numbers(file + ".vertices.f32", "f", 3 * count),
                         frame.numbers(file + ".quads.i32", "i", 4 * entry["quads"]))
        radiance = frame.numbers(file + ".radiance.f32", "f", 3 * count)
        mesh.attributes.new("radiance", "FLOAT_VECTOR", "POINT").data.foreach_set("vector", radiance)
        mesh.materials.append(material)
        collection.objects.link(bpy.data.objects.new(name, mesh))
    return collection


def cell_points(frame, cells):
    """One point per cell, or per part of one, with what the geometry nodes need to place it."""
    count = cells["count"]
    mesh = point_mesh("cells", frame.numbers(cells["positions"], "f", 3 * count))
    for name in ("first_turns", "scales", "second_turns", "part_middles", "part_halves"):
        if name in cells:  # blades have no parts
            values = frame.numbers(cells[name], "f", 3 * count)
            mesh.attributes.new(name, "FLOAT_VECTOR", "POINT").data.foreach_set("vector", values)
    picks = frame.numbers(cells["picks"], "i", count)
    mesh.attributes.new("picks", "INT", "POINT").data.foreach_set("value", picks)
    return mesh


def attribute(nodes, name, data_type):
    node = nodes.add("GeometryNodeInputNamedAttribute", data_type=data_type)
    node.inputs["Name"].default_value = name
    return next(output for output in node.outputs if output.enabled)


def placing_nodes(members):
    """Geometry nodes: on each point the member it picks, turned, scaled and turned again. Blender's
    instances cannot be sheared directly; two turns about a scale are any shear."""
    tree = bpy.data.node_groups.new("place", "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    nodes = Nodes(tree)
    source = nodes.add("GeometryNodeCollectionInfo")
    source.inputs["Collection"].default_value = members
    source.inputs["Separate Children"].default_value = True
    place = nodes.add("GeometryNodeInstanceOnPoints")
    place.inputs["Pick Instance"].default_value = True
    scale = nodes.add("GeometryNodeScaleInstances")
    scale.inputs["Local Space"].default_value = False
    turn = nodes.add("GeometryNodeRotateInstances")
    turn.inputs["Local Space"].default_value = False
    point = nodes.add("GeometryNodeInputPosition").outputs["Position"]
    nodes.link(nodes.add("NodeGroupInput").outputs[0], place.inputs["Points"])
    nodes.link(source.outputs[0], place.inputs["Instance"])
    nodes.link(attribute(nodes, "picks", "INT"), place.inputs["Instance Index"])
    nodes.link(attribute(nodes, "first_turns", "FLOAT_VECTOR"), place.inputs["Rotation"])
    nodes.link(place.outputs["Instances"], scale.inputs["Instances"])
    nodes.link(attribute(nodes, "scales", "FLOAT_VECTOR"), scale.inputs["Scale"])
    nodes.link(point, scale.inputs["Center"])
    nodes.link(scale.outputs["Instances"], turn.inputs["Instances"])
    nodes.link(attribute(nodes, "second_turns", "FLOAT_VECTOR"), turn.inputs["Rotation"])
    nodes.link(point, turn.inputs["Pivot Point"])
    nodes.link(turn.outputs["Instances"], nodes.add("NodeGroupOutput").inputs[0])
    return tree


def add_instances(frame, cells, members):
    if cells["count"] == 0:
        return
    points = add_object("cells", cell_points(frame, cells))
    modifier = points.modifiers.new("place", "NODES")
    modifier.node_group = placing_nodes(members)


def cover_material():
    material, nodes = new_material("cover")
    shader = medium(nodes, constant(nodes, (1, 1, 1)), constant(nodes, (0, 0, 0)))
    nodes.link(shader, nodes.add("ShaderNodeOutputMaterial").inputs["Volume"])
    return material


def add_cover(frame, cells):
    """Before the cells a volume that overlaps all of them and that no ray can meet: a mesh as large
    as they are together, whose only face is a point. Cycles holds each volume's bounds against
    those of the others, the first first, until it finds some that overlap: ten minutes for 300,000
    cells without this one."""
    if cells["count"] == 0:
        return
    places = frame.numbers(cells["positions"], "f", 3 * cells["count"])
    low, high = ([choose(places[axis::3]) for axis in range(3)] for choose in (min, max))
    mesh = quad_mesh("cover", array.array("f", 4 * low + high), array.array("i", range(4)))
    mesh.materials.append(cover_material())
    add_object("cover", mesh)


def add_grass(frame):
    add_cover(frame, frame["cells"])
    add_instances(frame, frame["cells"], load_volumes(frame))
    add_instances(frame, frame["blade_cells"], load_blades(frame))


# The clouds ---------------------------------------------------------------------------------


def cloud_material():
    """Like grass, without the maps of the ground."""
    material, nodes = new_material("cloud")
    material.cycles.volume_step_rate = 2.0  # voxels
    density = nodes.add("ShaderNodeAttribute", attribute_name="density")
    radiance = nodes.add("ShaderNodeAttribute", attribute_name="emission")
    shader = medium(nodes, density.outputs["Fac"], radiance.outputs["Vector"])
    nodes.link(shader, nodes.add("ShaderNodeOutputMaterial").inputs["Volume"])
    return material


def add_clouds(frame):
    """The clouds that are volumes; the others are in the backdrop."""
    for number, entry in enumerate(frame["clouds"]):
        volume = load_volume(frame, entry, f"cloud {number}")
        volume.materials.append(cloud_material())
        add_object(volume.name, volume).location = entry["corner_m"]


# The flakes ---------------------------------------------------------------------------------


def flake_material(frame, picture, radiance):
    """As much of `radiance` as the picture's and the flake's own opacity cover."""
    material, nodes = new_material("flake")
    image = nodes.add("ShaderNodeTexImage", image=frame.image(picture), extension="CLIP")
    own = nodes.add("ShaderNodeAttribute", attribute_name="opacity")
    covered = nodes.add("ShaderNodeMath", operation="MULTIPLY")
    emission = nodes.add("ShaderNodeEmission")
    flake = nodes.add("ShaderNodeMixShader")
    nodes.link(nodes.add("ShaderNodeTexCoord").outputs["UV"], image.inputs["Vector"])
    nodes.link(image.outputs["Color"], covered.inputs[0])
    nodes.link(own.outputs["Fac"], covered.inputs[1])
    nodes.link(constant(nodes, radiance), emission.inputs["Color"])
    nodes.link(covered.outputs["Value"], flake.inputs["Fac"])
    nodes.link(nodes.add("ShaderNodeBsdfTransparent").outputs["BSDF"], flake.inputs[1])
    nodes.link(emission.outputs["Emission"], flake.inputs[2])
    nodes.link(flake.outputs["Shader"], nodes.add("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def add_flakes(frame):
    """All flakes as one mesh that counts from the eye."""
    flakes = frame["flakes"]
    if flakes is None:
        return
    count = flakes["count"]
    mesh = quad_mesh("flakes", frame.numbers(flakes["corners"], "f", 12 * count),
                     array.array("i", range(4 * count)))
    places = array.array("f", (0, 0, 1, 0, 1, 1, 0, 1)) * count
    mesh.uv_layers.new().data.foreach_set("uv", places)
    opacities = frame.numbers(flakes["opacities"], "f", count)
    mesh.attributes.new("opacity", "FLOAT", "FACE").data.foreach_set("value", opacities)
    for picture in flakes["pictures"]:
        mesh.materials.append(flake_material(frame, picture, flakes["radiance"]))
    mesh.polygons.foreach_set("material_index", frame.numbers(flakes["picks"], "i", count))
    add_object("flakes", mesh).location = frame["camera"]["eye_m"]


# The picture --------------------------------------------------------------------------------


def set_light_transport(samples):
    """Straight rays: what is met emits, nothing scatters."""
    cycles = bpy.context.scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.seed = 0
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.max_bounces = 0
    cycles.transparent_max_bounces = 1024  # flakes in a row: beyond, a ray would end in black
    cycles.min_transparent_bounces = cycles.transparent_max_bounces  # no roulette: no specks
    cycles.volume_max_steps = 1024
    cycles.pixel_filter_type = "BLACKMAN_HARRIS"


def set_picture(frame, size_px):
    """sRGB of the radiance times the exposure gain, without a film look. No dates are written into
    the file; Cycles still adds its render time, so compare pixels, not bytes."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = size_px
    scene.render.resolution_percentage = 100
    scene.display_settings.display_device = "sRGB"
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.look = "None"
    scene.view_settings.exposure = math.log2(frame["exposure_gain"])
    scene.view_settings.gamma = 1.0
    scene.render.dither_intensity = 0.0
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "8"
    for name in dir(scene.render):
        if name.startswith("use_stamp_"):
            setattr(scene.render, name, False)


def build(frame, options):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.engine = "CYCLES"
    set_light_transport(options.samples or frame["samples"])
    set_picture(frame, options.size or frame["size_px"])
    if options.threads:
        bpy.context.scene.render.threads_mode = "FIXED"
        bpy.context.scene.render.threads = options.threads
    add_landscape(frame)
    set_camera(frame)


def add_landscape(frame):
    add_terrain(frame)
    add_grass(frame)
    set_sky(frame)
    add_clouds(frame)
    add_backdrop(frame)
    add_flakes(frame)


def pass_on(reading, stdout):
    """Copies Blender's output and adds a progress line to every count of samples in it."""
    with os.fdopen(reading, errors="replace") as lines:
        for line in lines:
            os.write(stdout, line.encode())
            sample = re.search(r"Sample (\d+)/(\d+)", line)
            if sample:
                fraction = int(sample.group(1)) / int(sample.group(2))
                os.write(stdout, f"wold: progress {fraction:.3f}\n".encode())


@contextlib.contextmanager
def progress_reported():
    """Blender 3.4 tells how many samples are done on its standard output only: its handlers for
    statistics are called without any."""
    stdout = os.dup(1)
    reading, writing = os.pipe()
    os.dup2(writing, 1)
    os.close(writing)
    reader = threading.Thread(target=pass_on, args=(reading, stdout))
    reader.start()
    try:
        yield
    finally:
        os.dup2(stdout, 1)  # closes the pipe, which ends the reader
        reader.join()
        os.close(stdout)


def render(path):
    """Writes the picture under a temporary name first, so that `path` is whole or not there."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with progress_reported():
        bpy.ops.render.render()
    folder, name = os.path.split(path)
    temporary = os.path.join(folder, f".{os.getpid()}.{name}")
    bpy.data.images["Render Result"].save_render(temporary)
    os.replace(temporary, path)
    print(f"wold: done {path}", flush=True)


def parse_size(text):
    width, height = (int(part) for part in text.lower().split("x"))
    return width, height


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="scene.py", description="Renders one frame.")
    parser.add_argument("frame", type=int, nargs="?", default=1)
    parser.add_argument("--out", help="PNG to write; default: frame_0001.png beside scene.py")
    parser.add_argument("--size", type=parse_size, metavar="WxH")
    parser.add_argument("--samples", type=int, help="per pixel")
    parser.add_argument("--threads", type=int, default=0, help="0: all")
    parser.add_argument("--look", action="store_true", help="build the scene, render nothing")
    return parser.parse_args(arguments)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    options = parse_options(arguments)
    try:
        build(Frame(options.frame), options)
    except DataError as error:
        print(f"wold: error {error}", file=sys.stderr, flush=True)
        sys.exit(1)
    if not options.look:
        out = options.out or os.path.join(HERE, f"frame_{options.frame:04d}.png")
        render(os.path.abspath(out))


if __name__ == "__main__":  # wold_addon.py uses the functions above
    main()
