"""Meshes from raw arrays."""

from __future__ import annotations

import array
from typing import TYPE_CHECKING, Any

import bpy

from .differences import polygons_are_told_where_they_end

if TYPE_CHECKING:  # before Python 3.12 this cannot be evaluated
    Numbers = array.array[Any]


def add_object(home: Any, name: str, data: Any) -> Any:
    """An object in the collection `home`."""
    thing = bpy.data.objects.new(name, data)
    home.objects.link(thing)
    return thing


def point_mesh(name: str, coordinates: Numbers) -> Any:
    """A mesh of vertices alone; `coordinates` are x, y, z of each, in metres."""
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(coordinates) // 3)
    mesh.vertices.foreach_set("co", coordinates)
    return mesh


def face_mesh(name: str, coordinates: Numbers, corners: Numbers, sides: int = 4) -> Any:
    """`corners` are the vertices of each face, four by four, or as many as it has sides."""
    mesh = point_mesh(name, coordinates)
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(corners) // sides)
    mesh.polygons.foreach_set("loop_start", array.array("i", range(0, len(corners), sides)))
    if polygons_are_told_where_they_end():
        mesh.polygons.foreach_set("loop_total", array.array("i", [sides]) * (len(corners) // sides))
    mesh.update(calc_edges=True)
    return mesh


def rectangle(name: str, points: Numbers) -> Any:
    """A mesh of one quad that shows the whole of a picture: lower left, lower right, upper right,
    upper left."""
    mesh = face_mesh(name, points, array.array("i", range(4)))
    mesh.uv_layers.new().data.foreach_set("uv", (0, 0, 1, 0, 1, 1, 0, 1))
    return mesh


def give_attribute(mesh: Any, name: str, domain: str, values: Numbers) -> None:
    """One number or three for each point or face: "POINT" or "FACE"."""
    count = len(mesh.vertices if domain == "POINT" else mesh.polygons)
    if values.typecode == "i":
        kind, key = "INT", "value"
    elif len(values) == count:
        kind, key = "FLOAT", "value"
    else:
        kind, key = "FLOAT_VECTOR", "vector"
    mesh.attributes.new(name, kind, domain).data.foreach_set(key, values)


def grid_points(heights_m: Numbers, samples: int, step_m: float) -> Numbers:
    """x, y, z in metres of a square grid's points, row by row from the south."""
    eastings = array.array("f", (i * step_m for i in range(samples)))
    points = array.array("f", bytes(4 * 3 * len(heights_m)))
    points[0::3] = eastings * samples
    for j in range(samples):
        points[3 * j * samples + 1 : 3 * (j + 1) * samples : 3] = (
            array.array("f", [j * step_m]) * samples
        )
    points[2::3] = heights_m
    return points


def grid_quads(samples: int) -> Numbers:
    """The corners of each face of a square grid, counter-clockwise seen from above."""
    firsts = array.array("i")
    for j in range(samples - 1):
        firsts.extend(range(j * samples, (j + 1) * samples - 1))
    corners = array.array("i", bytes(4 * 4 * len(firsts)))
    for corner, offset in enumerate((0, 1, samples + 1, samples)):
        corners[corner::4] = array.array("i", (first + offset for first in firsts))
    return corners
