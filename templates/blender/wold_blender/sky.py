"""The sky, what the camera sees of one with clouds, and fog."""

from __future__ import annotations

import array
import math
from typing import Any

import bpy
from mathutils import Vector

from .differences import declare_homogeneous, give_nodes
from .frame_data import Frame
from .meshes import add_object, rectangle
from .nodes import Nodes, constant, glow, medium, new_material
from .pictures import load_picture


def sky_radiance(nodes: Nodes, frame: Frame) -> Any:
    """An output socket. The picture's first column looks north and azimuth runs clockwise;
    Blender's panorama begins in the west, hence the quarter-turn."""
    turn = nodes.add("ShaderNodeMapping", vector_type="POINT")
    turn.inputs["Rotation"].default_value = (0, 0, math.pi / 2)
    panorama = nodes.add("ShaderNodeTexEnvironment", image=load_picture(frame.path(frame["sky"])))
    nodes.link(nodes.add("ShaderNodeTexCoord").outputs["Generated"], turn.inputs["Vector"])
    nodes.link(turn.outputs["Vector"], panorama.inputs["Vector"])
    return panorama.outputs["Color"]


def fog_medium(nodes: Nodes, fog: dict[str, Any]) -> Any:
    """A volume shader: the same everywhere, without an end."""
    extinction = nodes.add("ShaderNodeValue").outputs["Value"]
    extinction.default_value = fog["extinction_per_m"]
    gained = [fog["extinction_per_m"] * channel for channel in fog["radiance"]]  # per metre
    return medium(nodes, extinction, constant(nodes, gained))


def set_sky(scene: Any, frame: Frame) -> None:
    world = bpy.data.worlds.new("sky")
    scene.world = world
    nodes = Nodes(give_nodes(world))
    world.cycles.sampling_method = "NONE"
    background = nodes.add("ShaderNodeBackground")
    output = nodes.add("ShaderNodeOutputWorld")
    nodes.link(sky_radiance(nodes, frame), background.inputs["Color"])
    nodes.link(background.outputs["Background"], output.inputs["Surface"])
    if frame["fog"]:
        declare_homogeneous(world)
        nodes.link(fog_medium(nodes, frame["fog"]), output.inputs["Volume"])


def backdrop_material(frame: Frame, picture: str) -> Any:
    material, nodes = new_material("backdrop")
    image = nodes.add(
        "ShaderNodeTexImage", image=load_picture(frame.path(picture)), extension="EXTEND"
    )
    nodes.link(nodes.add("ShaderNodeTexCoord").outputs["UV"], image.inputs["Vector"])
    glow(nodes, image.outputs["Color"])
    return material


def add_backdrop(home: Any, frame: Frame) -> None:
    """What the camera sees of a sky with clouds: a picture on a rectangle far behind everything."""
    backdrop = frame["backdrop"]
    if backdrop is None:
        return
    corner, right, up = (Vector(backdrop[key]) for key in ("corner_m", "right_m", "up_m"))
    corners = (corner, corner + right, corner + right + up, corner + up)
    points = array.array("f", [number for point in corners for number in point])
    mesh = rectangle("backdrop", points)
    mesh.materials.append(backdrop_material(frame, backdrop["file"]))
    add_object(home, "backdrop", mesh)
