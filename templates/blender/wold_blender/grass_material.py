"""The material of grass volumes.

A volume's file holds `density` and its emission, a grid for each colour, for the whole patch, and a
grid of hull voxels for each of its quarters. Cycles builds a hull round the active voxels of the
grids that a material asks for, and shares grids between volumes of one file. So a quarter has a
hull of its own, while all quarters share the patch in memory.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from .frame_data import Frame
from .nodes import (
    Nodes,
    attribute,
    end_in,
    grid_emission,
    grid_number,
    map_outputs,
    medium,
    mixed,
    new_material,
)

QUARTERS = range(4)


def hull_grid(quarter: int) -> str:
    return f"quarter {quarter}"


class Kind(NamedTuple):
    """What materials of grass differ in."""

    step_voxels: float
    quarter: int | None  # that is shown; None: the whole patch

    @classmethod
    def of(cls, entry: dict[str, Any]) -> Kind:
        return cls(round(entry["step_voxels"], 2), entry["quarter"])

    def hull_grids(self) -> set[str]:
        quarters = QUARTERS if self.quarter is None else (self.quarter,)
        return {hull_grid(quarter) for quarter in quarters}


def grass_medium(nodes: Nodes, frame: Frame, density: Any) -> Any:
    """Grid `density` absorbs, the grids of its emission add, all in `density_unit_per_m`; the map
    `standing_light` multiplies them, its alpha the first and its colour the second."""
    unit_per_m = frame["density_unit_per_m"]
    ground = map_outputs(nodes, frame, frame["standing_light"])
    extinction = nodes.math("MULTIPLY", density, unit_per_m)
    standing = nodes.math("MULTIPLY", extinction, ground["Alpha"])
    lit = nodes.vector_math("MULTIPLY", grid_emission(nodes), ground["Color"])
    return medium(nodes, standing, lit, unit_per_m)


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


def asking_for(nodes: Nodes, grid: str, density: Any, shader: Any) -> Any:
    """The same shader, but Cycles counts `grid` among those it needs and makes it part of the hull
    it builds. It is never looked up: all densities are below 1."""
    emission = nodes.add("ShaderNodeEmission")
    nodes.link(attribute(nodes, grid, "Color"), emission.inputs["Color"])
    never = nodes.math("GREATER_THAN", density, 1.0)
    return mixed(nodes, never, shader, emission.outputs["Emission"])


def grass_material(frame: Frame, kind: Kind) -> Any:
    material, nodes = new_material(f"grass, step {kind.step_voxels}, quarter {kind.quarter}")
    material.cycles.volume_step_rate = kind.step_voxels
    density = grid_number(nodes, "density")
    shader = grass_medium(nodes, frame, density)
    for grid in sorted(kind.hull_grids()):
        shader = asking_for(nodes, grid, density, shader)
    # Where there is no grass, which is most of the air, neither light nor colour is looked up.
    shader = mixed(nodes, nodes.math("GREATER_THAN", density, 0.0), None, shader)
    if kind.quarter is not None:  # the hull alone would not do: Cycles passes over a face at times
        shader = mixed(nodes, inside_part(nodes), None, shader)
    end_in(nodes, "Volume", shader)
    return material
