"""The user's own things that change the landscape's light: faces that hide the sun, and lamps."""

from __future__ import annotations

import array
import math
import zlib
from typing import TYPE_CHECKING, Any, NamedTuple

from mathutils import Vector

if TYPE_CHECKING:  # before Python 3.12 this cannot be evaluated
    Numbers = array.array[Any]

FORMS = ("MESH", "CURVE", "SURFACE", "META", "FONT")  # that have faces


class Faces(NamedTuple):
    """Triangles: x, y, z of each point in metres of the world, and three points of each."""

    coordinates: Numbers
    corners: Numbers

    def points(self) -> list[tuple[float, float, float]]:
        return by_threes(self.coordinates)

    def triangles(self) -> list[tuple[int, int, int]]:
        return by_threes(self.corners)


def by_threes(numbers: Numbers) -> list[Any]:
    return list(zip(numbers[0::3], numbers[1::3], numbers[2::3]))


class Lamp(NamedTuple):
    place: Vector
    intensity: Vector  # in red, green and blue, per steradian
    radius: float
    axis: Vector | None  # of a spot
    cone: tuple[float, float]  # cosines of the angles where a spot ends and where it begins to fade


class Things(NamedTuple):
    faces: Faces
    lamps: list[Lamp]

    def summary(self) -> str:
        """Tells things from others."""
        points, corners = (zlib.crc32(part.tobytes()) for part in self.faces)
        return f"{points} {corners} {self.lamps}"


def things_of(collection: Any, graph: Any) -> Things:
    """What a collection holds, as it is evaluated."""
    return Things(faces_of(collection, graph), lamps_of(collection, graph))


def instances_of(collection: Any, graph: Any) -> Any:
    """Objects and where each stands."""
    members = {thing.name for thing in collection.all_objects}
    for each in graph.object_instances:
        owner = each.parent if each.is_instance else each.object
        if owner.original.name in members and not each.object.hide_render:
            yield each.object, each.matrix_world.copy()


def faces_of_one(thing: Any, matrix: Any) -> Faces:
    mesh = thing.to_mesh()
    mesh.transform(matrix)
    mesh.calc_loop_triangles()
    coordinates = array.array("f", bytes(4 * 3 * len(mesh.vertices)))
    corners = array.array("i", bytes(4 * 3 * len(mesh.loop_triangles)))
    mesh.vertices.foreach_get("co", coordinates)
    mesh.loop_triangles.foreach_get("vertices", corners)
    thing.to_mesh_clear()
    return Faces(coordinates, corners)


def faces_of(collection: Any, graph: Any) -> Faces:
    """All that can hide the sun."""
    every = Faces(array.array("f"), array.array("i"))
    for thing, matrix in instances_of(collection, graph):
        if thing.type in FORMS:
            faces = faces_of_one(thing, matrix)
            before = len(every.coordinates) // 3
            every.coordinates.extend(faces.coordinates)
            every.corners.extend(array.array("i", (before + point for point in faces.corners)))
    return every


def watts_of(light: Any) -> Vector:
    """Of a lamp in red, green and blue; Blender 4.5 and newer have exposure and temperature."""
    watts = Vector(light.color) * (light.energy * 2 ** getattr(light, "exposure", 0))
    if getattr(light, "use_temperature", False):
        watts *= Vector(light.temperature_color)
    return watts


def lamps_of(collection: Any, graph: Any) -> list[Lamp]:
    """Points and spots. A lamp of P watts sends P / (4 pi) into each steradian."""
    lamps = []
    for thing, matrix in instances_of(collection, graph):
        light = thing.data
        if thing.type != "LIGHT" or light.type not in ("POINT", "SPOT"):
            continue
        axis, cone = None, (0.0, 0.0)
        if light.type == "SPOT":
            end = math.cos(light.spot_size / 2)
            axis = -matrix.col[2].xyz.normalized()
            cone = (end, end + max(1e-4, (1 - end) * light.spot_blend))
        intensity = watts_of(light) / (4 * math.pi)
        lamps.append(Lamp(matrix.translation, intensity, light.shadow_soft_size, axis, cone))
    return lamps
