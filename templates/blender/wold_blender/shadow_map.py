"""The shadow of things before a sun that is a disc, as a map of a plane that faces it. No Blender.

Places of the plane are pixels. How far a place of the scene lies toward the sun is its height. Maps
are lists of rows of pixels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import accumulate

Map = list[list[float]]

SUN_RADIUS = 0.00465  # half the angle that the disc spans, radians
NO_THING = -math.inf  # height of a pixel in which sunlight meets none


def blur_pixels(gap_m: float, step_m: float) -> float:
    """Half the side of the square that stands for the sun's disc, of its area, where it shines
    through a small hole that is `gap_m` above the ground. Half a pixel blurs nothing."""
    return max(0.5, largest_blur_m(gap_m) * math.sqrt(math.pi) / 2 / step_m)


def largest_blur_m(gap_m: float) -> float:
    """How far a shadow on the ground reaches beyond what throws it, `gap_m` above."""
    return gap_m * math.tan(SUN_RADIUS)


class SummedAreas:
    """Means of a map over squares; beyond the map is 0."""

    def __init__(self, values: Map) -> None:
        self._rows, self._columns = len(values), len(values[0])
        sums = [[0.0] * (self._columns + 1)]
        for row in values:
            sums.append([a + b for a, b in zip(accumulate(row, initial=0.0), sums[-1])])
        self._sums = sums

    def _upto(self, row: float, column: float) -> float:
        """The sum of all rows and columns before a place, which may lie within a pixel."""
        row = min(max(row, 0.0), self._rows)
        column = min(max(column, 0.0), self._columns)
        j, i = min(int(row), self._rows - 1), min(int(column), self._columns - 1)
        up, right = row - j, column - i
        lower, upper = self._sums[j], self._sums[j + 1]
        return (1 - up) * (lower[i] + right * (lower[i + 1] - lower[i])) + up * (
            upper[i] + right * (upper[i + 1] - upper[i])
        )

    def mean(self, row: int, column: int, half: float) -> float:
        """Of a square about the middle of a pixel, with half a side in pixels."""
        south, north = row + 0.5 - half, row + 0.5 + half
        west, east = column + 0.5 - half, column + 0.5 + half
        total = self._upto(north, east) - self._upto(north, west)
        total -= self._upto(south, east) - self._upto(south, west)
        return max(0.0, total) / (2 * half) ** 2


def of_pairs(function: Callable[[float, float], float], first: Map, second: Map) -> Map:
    return [[function(a, b) for a, b in zip(*rows)] for rows in zip(first, second)]


def of_each(function: Callable[[float], float], values: Map) -> Map:
    return [[function(value) for value in row] for row in values]


def largest(rows: Iterable[Iterable[float]]) -> float:
    return max(max(row) for row in rows)


def soft_shadow(things_m: Map, ground_m: Map, step_m: float) -> tuple[Map, Map]:
    """Which fraction of the sun's disc is hidden from the ground, and how high the things stand
    that hide it.

    `things_m` is the height of the first thing that sunlight meets, or NO_THING, and `ground_m`
    that of the ground. Pixels are `step_m` wide.

    Fernando, Percentage-Closer Soft Shadows (SIGGRAPH 2005 sketches), with the means of summed
    areas instead of samples.
    """
    gaps_m = of_pairs(lambda thing, ground: max(0.0, thing - ground), things_m, ground_m)
    hits = SummedAreas(of_each(lambda thing: float(thing > NO_THING), things_m))
    gap_sums = SummedAreas(gaps_m)
    height_sums = SummedAreas(of_each(lambda thing: thing if thing > NO_THING else 0.0, things_m))
    nearby = blur_pixels(largest(gaps_m), step_m) + 1
    hidden = of_each(lambda _: 0.0, things_m)
    heights_m = of_each(lambda _: 0.0, things_m)
    for row, things in enumerate(things_m):
        for column, thing_m in enumerate(things):
            weight = hits.mean(row, column, nearby)
            if weight < 1e-9:
                continue
            gap_m = gap_sums.mean(row, column, nearby) / weight
            half = blur_pixels(gap_m, step_m)
            hidden[row][column] = min(1.0, hits.mean(row, column, half))
            height_m = height_sums.mean(row, column, nearby) / weight
            heights_m[row][column] = thing_m if thing_m > NO_THING else height_m
    return hidden, heights_m
