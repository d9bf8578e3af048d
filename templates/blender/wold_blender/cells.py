"""Grass: a volume, or part of one, or a mesh of blades on every cell of the ground.

Cells are points of a mesh. Geometry nodes lay an instance on each.
"""

from __future__ import annotations

import array
from typing import Any

import bpy

from .blades import load_blades
from .differences import add_group_socket, volume_shift_voxels
from .frame_data import DataError, Frame
from .grass_material import EMISSION, GrassMaterials, Kind
from .hull_names import name_of_volume
from .meshes import add_object, face_mesh, give_attribute, point_mesh
from .nodes import Nodes, constant, end_in, medium, new_material
from .volumes import load_volume

SHIFT = "shift_m"  # name of the attribute by which volumes are moved along each of their axes

# Cycles leaves voxels below this out of a volume's hull, but not out of the volume. All densities
# are below it; voxels of hull grids have 1.
CLIPPING = 0.9995


def load_volumes(frame: Frame) -> Any:
    """The frame's volumes as a collection that is not itself in the scene. Blender orders its
    members by name: an instance's index counts on it."""
    collection = bpy.data.collections.new("volumes")
    materials = GrassMaterials(frame)
    for number, entry in enumerate(frame["volumes"]):
        kind = Kind.of(entry)
        grids = {"density", EMISSION, *kind.hull_grids()}
        volume = load_volume(frame, entry, name_of_volume(number), grids)
        volume.render.clipping = CLIPPING
        volume.materials.append(materials.of(kind))
        collection.objects.link(bpy.data.objects.new(volume.name, volume))
    materials.remove_forms()
    return collection


def picks_of(frame: Frame, cells: dict[str, Any], members: int) -> array.array[Any]:
    """Which member of its collection each cell shows."""
    picks = frame.numbers(cells["picks"], "i", cells["count"])
    if min(picks) < 0 or max(picks) >= members:
        raise DataError(f"{frame.path(cells['picks'])} is damaged: it picks what is not there")
    return picks


def cell_points(frame: Frame, cells: dict[str, Any], members: int) -> Any:
    """One point per cell, or per part of one, with what the geometry nodes need to place it."""
    count = cells["count"]
    mesh = point_mesh("cells", frame.numbers(cells["positions"], "f", 3 * count))
    for name in ("first_turns", "scales", "second_turns", "part_middles", "part_halves"):
        if name in cells:  # blades have no parts
            give_attribute(mesh, name, "POINT", frame.numbers(cells[name], "f", 3 * count))
    give_attribute(mesh, "picks", "POINT", picks_of(frame, cells, members))
    return mesh


def shift_volumes(frame: Frame, cells: dict[str, Any], mesh: Any) -> None:
    """Says of each cell by how much its volume is moved, where that is to be done. The bounds of a
    part are in the volume's own space. They are measured from where the volume was before."""
    shift_voxels = volume_shift_voxels()
    if shift_voxels == 0.0:
        return
    voxels_m = [entry["voxel_m"] for entry in frame["volumes"]]
    picks = picks_of(frame, cells, len(voxels_m))
    shifts_m = array.array("f", (shift_voxels * voxels_m[pick] for pick in picks))
    give_attribute(mesh, SHIFT, "POINT", shifts_m)
    middles_m = frame.numbers(cells["part_middles"], "f", 3 * cells["count"])
    for axis in range(3):
        moved = (m - s for m, s in zip(middles_m[axis::3], shifts_m))
        middles_m[axis::3] = array.array("f", moved)
    mesh.attributes["part_middles"].data.foreach_set("vector", middles_m)


def named_attribute(nodes: Nodes, name: str, data_type: str) -> Any:
    node = nodes.add("GeometryNodeInputNamedAttribute", data_type=data_type)
    node.inputs["Name"].default_value = name
    return next(output for output in node.outputs if output.enabled)


def shifted(nodes: Nodes, instances: Any) -> Any:
    """Instances, an output socket, moved along their own axes."""
    move = nodes.add("GeometryNodeTranslateInstances")
    move.inputs["Local Space"].default_value = True
    nodes.link(instances, move.inputs["Instances"])
    nodes.link(named_attribute(nodes, SHIFT, "FLOAT"), move.inputs["Translation"])
    return move.outputs["Instances"]


def placing_nodes(members: Any, shift: bool) -> Any:
    """Geometry nodes: on each point the member it picks, turned, scaled and turned again. Blender's
    instances cannot be sheared directly; two turns about a scale are any shear."""
    tree = bpy.data.node_groups.new("place", "GeometryNodeTree")
    add_group_socket(tree, "Geometry", "INPUT", "NodeSocketGeometry")
    add_group_socket(tree, "Geometry", "OUTPUT", "NodeSocketGeometry")
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
    nodes.link(named_attribute(nodes, "picks", "INT"), place.inputs["Instance Index"])
    nodes.link(named_attribute(nodes, "first_turns", "FLOAT_VECTOR"), place.inputs["Rotation"])
    nodes.link(place.outputs["Instances"], scale.inputs["Instances"])
    nodes.link(named_attribute(nodes, "scales", "FLOAT_VECTOR"), scale.inputs["Scale"])
    nodes.link(point, scale.inputs["Center"])
    nodes.link(scale.outputs["Instances"], turn.inputs["Instances"])
    nodes.link(named_attribute(nodes, "second_turns", "FLOAT_VECTOR"), turn.inputs["Rotation"])
    nodes.link(point, turn.inputs["Pivot Point"])
    turned = turn.outputs["Instances"]
    placed = shifted(nodes, turned) if shift else turned
    nodes.link(placed, nodes.add("NodeGroupOutput").inputs[0])
    return tree


def add_instances(home: Any, points: Any, members: Any) -> None:
    """Lays members of a collection, which is not in the scene, on the points of a mesh."""
    modifier = add_object(home, "cells", points).modifiers.new("place", "NODES")
    modifier.node_group = placing_nodes(members, SHIFT in points.attributes)


def cover_material() -> Any:
    material, nodes = new_material("cover")
    end_in(nodes, "Volume", medium(nodes, constant(nodes, (1, 1, 1)), constant(nodes, (0, 0, 0))))
    return material


def add_cover(home: Any, frame: Frame, cells: dict[str, Any]) -> None:
    """Before the cells a volume that overlaps all of them and that no ray can meet: a mesh as large
    as they are together, whose only face is a point. Cycles holds each volume's bounds against
    those of the others, the first first, until it finds some that overlap: ten minutes for 300,000
    cells without this one."""
    places = frame.numbers(cells["positions"], "f", 3 * cells["count"])
    low, high = ([choose(places[axis::3]) for axis in range(3)] for choose in (min, max))
    mesh = face_mesh("cover", array.array("f", 4 * low + high), array.array("i", range(4)))
    mesh.materials.append(cover_material())
    add_object(home, "cover", mesh)


def add_volume_cells(home: Any, frame: Frame) -> None:
    cells = frame["cells"]
    if cells["count"] == 0:
        return
    add_cover(home, frame, cells)
    mesh = cell_points(frame, cells, len(frame["volumes"]))
    shift_volumes(frame, cells, mesh)
    add_instances(home, mesh, load_volumes(frame))


def add_blade_cells(home: Any, frame: Frame) -> None:
    cells = frame["blade_cells"]
    if cells["count"] > 0:
        points = cell_points(frame, cells, len(frame["blades"]))
        add_instances(home, points, load_blades(frame))


def add_grass(home: Any, frame: Frame) -> None:
    add_volume_cells(home, frame)
    add_blade_cells(home, frame)
