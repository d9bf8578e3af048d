"""Node trees that are built from nothing, and the few patterns of nodes that materials share.

An "output socket" is a node's output that a function returns, so that others link to it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import bpy

from .differences import attributes_are_looked_up_at_random, give_nodes, leave_out_of_lights
from .frame_data import Frame
from .pictures import load_picture

GAIN = "gain"  # name of the node that adds radiance in medium() and glow()
LIT = "wold_lit"  # marks materials whose light the user's things change


class Nodes:
    """A node tree that is being filled."""

    def __init__(self, tree: Any) -> None:
        tree.nodes.clear()
        self.tree = tree

    def add(self, kind: str, **settings: Any) -> Any:
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        return node

    def link(self, source: Any, target: Any) -> None:
        self.tree.links.new(source, target)

    def math(self, operation: str, first: Any, second: Any) -> Any:
        """An output socket: `first` is another, `second` another or a number."""
        node = self.add("ShaderNodeMath", operation=operation)
        self.link(first, node.inputs[0])
        self._give(second, node.inputs[1])
        return node.outputs["Value"]

    def vector_math(self, operation: str, *operands: Any) -> Any:
        """An output socket; the operands are others or three numbers each."""
        node = self.add("ShaderNodeVectorMath", operation=operation)
        for operand, socket in zip(operands, node.inputs):
            self._give(operand, socket)
        return node.outputs["Vector"]

    def _give(self, value: Any, socket: Any) -> None:
        if isinstance(value, bpy.types.NodeSocket):
            self.link(value, socket)
        else:
            socket.default_value = value


def new_material(name: str) -> tuple[Any, Nodes]:
    material = bpy.data.materials.new(name)
    nodes = Nodes(give_nodes(material))
    leave_out_of_lights(material)
    return material, nodes


def constant(nodes: Nodes, colour: Sequence[float]) -> Any:
    """An output socket: the same three numbers everywhere."""
    output = nodes.add("ShaderNodeRGB").outputs["Color"]
    output.default_value = (*colour, 1.0)
    return output


def attribute(nodes: Nodes, name: str, output: str) -> Any:
    """An output socket of a grid or of a mesh's attribute: "Fac", "Color" or "Vector"."""
    return nodes.add("ShaderNodeAttribute", attribute_name=name).outputs[output]


def grid_number(nodes: Nodes, name: str) -> Any:
    """An output socket: a grid's number, interpolated at the shaded point. None is below zero, so
    that the maximum changes nothing but makes the look-up one of all eight voxels."""
    number = attribute(nodes, name, "Fac")
    if attributes_are_looked_up_at_random():
        return nodes.math("MAXIMUM", number, 0.0)
    return number


EMISSION = ("emission red", "emission green", "emission blue")  # grids of a volume


def grid_emission(nodes: Nodes) -> Any:
    """An output socket: what a volume emits, as three numbers; see grid_number()."""
    colour = nodes.add("ShaderNodeCombineXYZ")
    for grid, socket in zip(EMISSION, colour.inputs):
        nodes.link(grid_number(nodes, grid), socket)
    return colour.outputs["Vector"]


def map_outputs(
    nodes: Nodes, frame: Frame, ground_map: dict[str, Any], extension: str = "EXTEND"
) -> Any:
    """Colour and Alpha of a map of the ground at the shaded point, as output sockets.

    The map's values lie on the corners of its grid, the first and last on its border, which is the
    terrain's unless it has a corner of its own; a picture's lie in the middle of its pixels."""
    corner_m = ground_map.get("corner_m", (0, 0))
    samples, size_m = ground_map["samples"], ground_map["size_m"]
    scale = (samples - 1) / (samples * size_m)
    offset = [0.5 / samples - scale * edge for edge in corner_m]
    # Not a Mapping node: it works out its rotation anew at every step of every ray.
    position = nodes.add("ShaderNodeNewGeometry").outputs["Position"]
    place = nodes.vector_math("MULTIPLY_ADD", position, (scale, scale, 0), (*offset, 0))
    picture = load_picture(frame.path(ground_map["file"]))
    texture = nodes.add("ShaderNodeTexImage", image=picture, extension=extension)
    nodes.link(place, texture.inputs["Vector"])
    return texture.outputs


def glow(nodes: Nodes, colour: Any) -> None:
    """The surface's radiance is `colour`, an output socket."""
    emission = nodes.add("ShaderNodeEmission", name=GAIN)
    nodes.link(colour, emission.inputs["Color"])
    end_in(nodes, "Surface", emission.outputs["Emission"])


def end_in(nodes: Nodes, kind: str, shader: Any) -> None:
    """`shader` is what the material shows; `kind` is "Surface" or "Volume"."""
    nodes.link(shader, nodes.add("ShaderNodeOutputMaterial").inputs[kind])


def medium(nodes: Nodes, extinction: Any, radiance: Any, strength: float = 1.0) -> Any:
    """A volume shader that absorbs by `extinction` (1/m) and adds `radiance` times `strength` (per
    m); the first two are output sockets."""
    absorption = nodes.add("ShaderNodeVolumeAbsorption")
    absorption.inputs["Color"].default_value = (0, 0, 0, 1)
    emission = nodes.add("ShaderNodeEmission", name=GAIN)
    emission.inputs["Strength"].default_value = strength
    both = nodes.add("ShaderNodeAddShader")
    nodes.link(extinction, absorption.inputs["Density"])
    nodes.link(radiance, emission.inputs["Color"])
    nodes.link(absorption.outputs["Volume"], both.inputs[0])
    nodes.link(emission.outputs["Emission"], both.inputs[1])
    return both.outputs["Shader"]


def mixed(nodes: Nodes, fraction: Any, first: Any, second: Any) -> Any:
    """A shader: `fraction`, an output socket, of the second one and the rest of the first. Cycles
    passes over the side of a mix that is not used with all that leads to it. Nothing is where a
    shader is None."""
    both = nodes.add("ShaderNodeMixShader")
    nodes.link(fraction, both.inputs["Fac"])
    for shader, socket in ((first, both.inputs[1]), (second, both.inputs[2])):
        if shader:
            nodes.link(shader, socket)
    return both.outputs["Shader"]
