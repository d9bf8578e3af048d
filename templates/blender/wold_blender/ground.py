"""The terrain as a mesh that shows the ground's radiance."""

from __future__ import annotations

from typing import Any

from .frame_data import Frame
from .meshes import add_object, grid_points, grid_quads, quad_mesh
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
    mesh = quad_mesh("terrain", points, grid_quads(samples))
    mesh.materials.append(ground_material(frame))
    add_object(home, "terrain", mesh)
