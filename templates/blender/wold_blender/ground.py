"""The terrain and its boulders as meshes that show the ground's radiance."""

from __future__ import annotations

from typing import Any

from .frame_data import DataError, Frame
from .meshes import add_object, face_mesh, grid_points, grid_quads
from .nodes import LIT, glow, map_outputs, new_material


def ground_material(frame: Frame) -> Any:
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
    material[LIT] = True
    return material


def add_terrain(home: Any, frame: Frame) -> None:
    terrain = frame["terrain"]
    samples = terrain["samples"]
    heights_m = frame.numbers(terrain["heights"], "f", samples * samples)
    points = grid_points(heights_m, samples, terrain["size_m"] / (samples - 1))
    mesh = face_mesh("terrain", points, grid_quads(samples))
    material = ground_material(frame)
    mesh.materials.append(material)
    add_object(home, "terrain", mesh)
    if "boulders" in frame.data:
        add_boulders(home, frame, material)


def add_boulders(home: Any, frame: Frame, material: Any) -> None:
    """What stands out of the terrain, with its material."""
    boulders = frame["boulders"]
    points = frame.numbers(boulders["points"], "f", 3 * boulders["point_count"])
    corners = frame.numbers(boulders["triangles"], "i", 3 * boulders["triangle_count"])
    if max(corners) >= boulders["point_count"] or min(corners) < 0:
        raise DataError(f"{frame.json_path} has boulders with corners that are not there")
    mesh = face_mesh("boulders", points, corners, sides=3)
    mesh.materials.append(material)
    add_object(home, "boulders", mesh).location = boulders["origin_m"]
