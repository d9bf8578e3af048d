"""The material of grass volumes.

A volume's file holds `density` and `emission`, its luminance, for the whole patch, and a grid of
hull voxels for each of its quarters. A picture beside it has the colours of the emission. Cycles
builds a hull round the active voxels of the grids that a material asks for, and shares grids
between volumes of one file. So a quarter has a hull of its own, while all quarters share the patch
in memory.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import bpy

from .differences import volume_shift_voxels
from .frame_data import Frame, check_size, light_map_of
from .nodes import (
    GAIN,
    LIT,
    Nodes,
    end_in,
    grid_number,
    map_outputs,
    medium,
    mixed,
    new_material,
)
from .pictures import load_picture

QUARTERS = range(4)
EMISSION = "emission"  # grid of a volume

# Names of the nodes in which kinds differ.
LOWER, UPPER = "lower slice", "upper slice"  # pictures
STANDING = "standing light"  # a picture, too
PLACE, SLICES, NEXT_SLICE = "place in picture", "slices before", "next slice"


def hull_grid(quarter: int) -> str:
    return f"quarter {quarter}"


class Colours(NamedTuple):
    """The picture of a volume's colours, which gen/blender/colour_picture.h describes: a column of
    slices of the patch, each with a border of one pixel, the lowest uppermost."""

    file: str
    bytes: int
    side: int  # of a slice, without its border
    slices: int
    scale: float  # times a pixel: a colour of luminance 1


class Kind(NamedTuple):
    """What materials of grass differ in."""

    step_voxels: float
    quarter: int | None  # that is shown; None: the whole patch
    voxel_m: float
    colours: Colours
    light_map: int  # number of the map of the light on it

    @classmethod
    def of(cls, entry: dict[str, Any]) -> Kind:
        return cls(
            round(entry["step_voxels"], 2),
            entry["quarter"],
            entry["voxel_m"],
            Colours(**entry["colours"]),
            light_map_of(entry),
        )

    def hull_grids(self) -> list[str]:
        quarters = QUARTERS if self.quarter is None else (self.quarter,)
        return [hull_grid(quarter) for quarter in quarters]


class PlaceInPicture(NamedTuple):
    """Where in the picture of colours a place of the patch lies: `scale` times the place in metres
    plus `offset`, along the picture's x and y (both from its lower left to 1) and in slices."""

    scale: tuple[float, float, float]
    offset: tuple[float, float, float]
    next_slice: float  # from a slice to the next along y

    @classmethod
    def of(cls, kind: Kind, shift_voxels: float) -> PlaceInPicture:
        """A voxel of colours is two voxels wide. `shift_voxels` is volume_shift_voxels()."""
        tile = kind.colours.side + 2
        height = tile * kind.colours.slices
        per_m = 0.5 / kind.voxel_m
        shift = 0.5 * shift_voxels
        return cls(
            (per_m / tile, -per_m / height, per_m),
            ((shift + 1) / tile, 1 - (shift + 1) / height, shift + 0.5),
            -1 / kind.colours.slices,
        )


def colour_in_picture(nodes: Nodes) -> Any:
    """An output socket: the colour of what is emitted, over Colours.scale, interpolated. The nodes
    that have names get their numbers and their picture from show_colours()."""
    place = nodes.add("ShaderNodeVectorMath", operation="MULTIPLY_ADD", name=PLACE)
    nodes.link(nodes.add("ShaderNodeTexCoord").outputs["Object"], place.inputs[0])
    along = nodes.add("ShaderNodeSeparateXYZ")
    nodes.link(place.outputs["Vector"], along.inputs["Vector"])
    below = nodes.math("FLOOR", along.outputs["Z"], 0.0)
    first_row = nodes.add("ShaderNodeVectorMath", operation="MULTIPLY", name=SLICES)
    nodes.link(below, first_row.inputs[0])
    in_lower = nodes.vector_math("ADD", place.outputs["Vector"], first_row.outputs["Vector"])
    in_upper = nodes.add("ShaderNodeVectorMath", operation="ADD", name=NEXT_SLICE)
    nodes.link(in_lower, in_upper.inputs[0])
    lower = slice_colour(nodes, LOWER, in_lower)
    upper = slice_colour(nodes, UPPER, in_upper.outputs["Vector"])
    above = nodes.math("SUBTRACT", along.outputs["Z"], below)
    return nodes.vector_math(
        "MULTIPLY_ADD", nodes.vector_math("SUBTRACT", upper, lower), above, lower
    )


def slice_colour(nodes: Nodes, name: str, place: Any) -> Any:
    texture = nodes.add("ShaderNodeTexImage", extension="EXTEND", name=name)
    nodes.link(place, texture.inputs["Vector"])
    return texture.outputs["Color"]


def show_colours(nodes: Any, frame: Frame, kind: Kind) -> None:
    """Gives the nodes of colour_in_picture() what they have of a kind."""
    path = frame.path(kind.colours.file)
    check_size(path, kind.colours.bytes)
    nodes[LOWER].image = nodes[UPPER].image = load_picture(path)
    to_picture = PlaceInPicture.of(kind, volume_shift_voxels())
    nodes[PLACE].inputs[1].default_value = to_picture.scale
    nodes[PLACE].inputs[2].default_value = to_picture.offset
    for name in (SLICES, NEXT_SLICE):
        nodes[name].inputs[1].default_value = (0, to_picture.next_slice, 0)


def grass_medium(nodes: Nodes, frame: Frame, density: Any, light_map: int) -> Any:
    """Grid `density` absorbs, grid `emission` adds in the colours of its picture, both in
    `density_unit_per_m`; the map `standing_light` of that number multiplies them, its alpha the
    first and its colour the second."""
    ground = map_outputs(nodes, frame, frame.light_map("standing_light", light_map))
    ground["Color"].node.name = STANDING
    extinction = nodes.math("MULTIPLY", density, frame["density_unit_per_m"])
    standing = nodes.math("MULTIPLY", extinction, ground["Alpha"])
    colour = nodes.vector_math("MULTIPLY", colour_in_picture(nodes), ground["Color"])
    lit = nodes.vector_math("MULTIPLY", colour, grid_number(nodes, EMISSION))
    return medium(nodes, standing, lit)


def inside_part(nodes: Nodes) -> Any:
    """An output socket: 1 in the part of its cell that an instance shows, else 0."""
    place = nodes.add("ShaderNodeTexCoord").outputs["Object"]
    middle, half = (
        nodes.add("ShaderNodeAttribute", attribute_type="INSTANCER", attribute_name=name).outputs[
            "Vector"
        ]
        for name in ("part_middles", "part_halves")
    )
    from_middle = nodes.vector_math("ABSOLUTE", nodes.vector_math("SUBTRACT", place, middle))
    beyond = nodes.add("ShaderNodeSeparateXYZ")
    nodes.link(nodes.vector_math("SUBTRACT", from_middle, half), beyond.inputs["Vector"])
    farthest = nodes.math("MAXIMUM", beyond.outputs["X"], beyond.outputs["Y"])
    return nodes.math("LESS_THAN", farthest, 0.0)


def asking_for(nodes: Nodes, number: int, density: Any, shader: Any) -> Any:
    """The same shader, but Cycles counts the hull grid of that number in Kind.hull_grids() among
    those it needs and makes it part of the hull it builds. It is never looked up: all densities are
    below 1."""
    grid = nodes.add("ShaderNodeAttribute", name=hull_node(number))
    emission = nodes.add("ShaderNodeEmission")
    nodes.link(grid.outputs["Color"], emission.inputs["Color"])
    never = nodes.math("GREATER_THAN", density, 1.0)
    return mixed(nodes, never, shader, emission.outputs["Emission"])


def hull_node(number: int) -> str:
    return f"hull {number}"


def material_form(frame: Frame, is_whole: bool, light_map: int) -> Any:
    """The nodes of all materials that show the whole patch, or a quarter of it, in the light of a
    map, without pictures: Blender counts a picture's users too high when a material that shows it
    is copied."""
    material, nodes = new_material("grass")
    density = grid_number(nodes, "density")
    shader = grass_medium(nodes, frame, density, light_map)
    for number in QUARTERS if is_whole else range(1):
        shader = asking_for(nodes, number, density, shader)
    # Where there is no grass, which is most of the air, neither light nor colour is looked up.
    shader = mixed(nodes, nodes.math("GREATER_THAN", density, 0.0), None, shader)
    if not is_whole:  # the hull alone would not do: Cycles passes over a face at times
        shader = mixed(nodes, inside_part(nodes), None, shader)
    end_in(nodes, "Volume", shader)
    material.node_tree.nodes[STANDING].image = None
    material[LIT] = True
    return material


def show_kind(material: Any, frame: Frame, kind: Kind) -> None:
    """Makes a material of its form's nodes one of a kind."""
    material.name = f"grass, step {kind.step_voxels}, quarter {kind.quarter}"
    material.cycles.volume_step_rate = kind.step_voxels
    nodes = material.node_tree.nodes
    show_colours(nodes, frame, kind)
    light = frame.light_map("standing_light", kind.light_map)
    nodes[STANDING].image = load_picture(frame.path(light["file"]))
    nodes[GAIN].inputs["Strength"].default_value = frame["density_unit_per_m"] * kind.colours.scale
    for number, grid in enumerate(kind.hull_grids()):
        nodes[hull_node(number)].attribute_name = grid


class GrassMaterials:
    """A frame's materials of grass, each made once, as copies of one of their form: Blender takes
    some 50 ms to build such nodes, and 2 ms to copy them."""

    def __init__(self, frame: Frame) -> None:
        self._frame = frame
        self._forms: dict[tuple[bool, int], Any] = {}
        self._materials: dict[Kind, Any] = {}

    def of(self, kind: Kind) -> Any:
        if kind not in self._materials:
            self._materials[kind] = self._new(kind.quarter is None, kind.light_map)
            show_kind(self._materials[kind], self._frame, kind)
        return self._materials[kind]

    def remove_forms(self) -> None:
        """When all materials are made."""
        for form in self._forms.values():
            bpy.data.materials.remove(form)
        self._forms.clear()

    def _new(self, is_whole: bool, light_map: int) -> Any:
        form = (is_whole, light_map)
        if form not in self._forms:
            self._forms[form] = material_form(self._frame, is_whole, light_map)
        return self._forms[form].copy()
