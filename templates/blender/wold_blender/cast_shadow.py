"""Traces into a picture which fraction of the sun's disc things hide from the landscape."""

from __future__ import annotations

import array
from typing import Any, NamedTuple

import bpy
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from .shadow_map import NO_THING, Map, largest_blur_m, soft_shadow
from .things import Faces

PICTURE = "Wold shadow"
LONGER_SIDE = 256  # pixels of the picture
GROUND_SIDE = 33  # how many rays along a side find the ground


class Beam(NamedTuple):
    """What the sun sends past and onto things, with axes that are at right angles."""

    side: Vector
    above: Vector
    to_sun: Vector
    low: tuple[float, float, float]  # along the axes, metres
    high: tuple[float, float, float]

    def length_m(self) -> float:
        return self.high[2] - self.low[2]

    def places(self, columns: int, rows: int) -> list[list[Vector]]:
        """The middles of the pixels of its upper end, row by row, in metres of the world."""
        end = self.to_sun * self.high[2]
        along_rows = middles(self.low[0], self.high[0], columns)
        return [
            [end + self.side * x + self.above * y for x in along_rows]
            for y in middles(self.low[1], self.high[1], rows)
        ]


def middles(low: float, high: float, count: int) -> list[float]:
    """Of equal parts."""
    return [low + (i + 0.5) / count * (high - low) for i in range(count)]


def beam_past(faces: Faces, to_sun: Vector) -> Beam:
    """As narrow and as short as the things."""
    side = Vector((0, 0, 1)).cross(to_sun)
    side = side.normalized() if side.length > 1e-6 else Vector((1, 0, 0))
    axes = (side, to_sun.cross(side), to_sun)
    points = [Vector(point) for point in faces.points()]
    along = [[point.dot(axis) for point in points] for axis in axes]
    low = tuple(min(each) - 0.001 for each in along)
    high = tuple(max(each) + 0.001 for each in along)
    return Beam(*axes, low, high)


def with_penumbra(beam: Beam, ground: Any) -> Beam:
    """As wide as the shadow is where it meets the ground."""
    rim = largest_blur_m(1.5 * distance_m(ground, beam, beam.places(1, 1)[0][0]))
    rim += 2 * max(high - low for low, high in zip(beam.low[:2], beam.high[:2])) / LONGER_SIDE
    low, high = (
        (end[0] + way * rim, end[1] + way * rim, end[2])
        for end, way in ((beam.low, -1), (beam.high, 1))
    )
    return beam._replace(low=low, high=high)


def distance_m(ground: Any, beam: Beam, start: Vector) -> float:
    """From the beam's upper end to the ground; where there is none, to the lower end."""
    found, place, _, _ = ground.ray_cast(start, -beam.to_sun)
    return (place - start).length if found else beam.length_m()


def things_heights_m(faces: Faces, beam: Beam, columns: int, rows: int) -> Map:
    """How far toward the sun lies what sunlight meets first."""
    tree = BVHTree.FromPolygons(faces.points(), faces.triangles(), all_triangles=True)
    down = -beam.to_sun

    def height_m(start: Vector) -> float:
        distance = tree.ray_cast(start, down)[3]
        return NO_THING if distance is None else beam.high[2] - distance

    return [[height_m(start) for start in row] for row in beam.places(columns, rows)]


def ground_heights_m(ground: Any, beam: Beam, columns: int, rows: int) -> Map:
    """Of few rays, interpolated."""
    coarse = [
        [beam.high[2] - distance_m(ground, beam, start) for start in row]
        for row in beam.places(GROUND_SIDE, GROUND_SIDE)
    ]
    by_columns = [spread(row, columns) for row in coarse]
    return transposed([spread(column, rows) for column in transposed(by_columns)])


def spread(values: list[float], count: int) -> list[float]:
    """Values at the middles of equal parts, interpolated to those of more parts."""
    spread_values = []
    for at in middles(-0.5, len(values) - 0.5, count):
        low = min(max(int(at), 0), len(values) - 2)
        way = min(max(at - low, 0.0), 1.0)
        spread_values.append(values[low] + way * (values[low + 1] - values[low]))
    return spread_values


def transposed(values: Map) -> Map:
    return [list(column) for column in zip(*values)]


def write_shadow(picture: Any, hidden: Map, heights: Map, beam: Beam) -> None:
    pixels = array.array("f")
    for row in zip(hidden, heights):
        for fraction, height_m in zip(*row):
            pixels.extend((fraction, (height_m - beam.low[2]) / beam.length_m(), 0.0, 1.0))
    picture.pixels.foreach_set(pixels)
    picture.update()
    picture.pack()


def shadow_of(faces: Faces, to_sun: Vector, ground: Any) -> tuple[Beam, Any]:
    """The beam of a sun above the horizon, and a picture of what it loses: across the beam, red is
    which fraction of the disc is hidden, and green from where on, 0 to 1 along the beam."""
    beam = with_penumbra(beam_past(faces, to_sun), ground)
    wide, high = (beam.high[axis] - beam.low[axis] for axis in range(2))
    step_m = max(wide, high) / LONGER_SIDE
    columns, rows = (max(2, round(size / step_m)) for size in (wide, high))
    hidden, heights = soft_shadow(
        things_heights_m(faces, beam, columns, rows),
        ground_heights_m(ground, beam, columns, rows),
        step_m,
    )
    picture = bpy.data.images.new(PICTURE, columns, rows, float_buffer=True, is_data=True)
    write_shadow(picture, hidden, heights, beam)
    return beam, picture
