"""The terrain's grid against plain loops over its points and faces."""

import array
import unittest

import stand_in  # noqa: F401
from wold_blender.meshes import grid_points, grid_quads


class Grid(unittest.TestCase):
    def test_points_are_the_loops(self):
        heights_m = array.array("f", [0.0, 1.0, 2.0, 10.0, 11.0, 12.0, -20.0, 21.0, 22.5])
        expected = []
        for j in range(3):
            for i in range(3):
                expected += [i * 0.25, j * 0.25, heights_m[3 * j + i]]
        self.assertSequenceEqual(grid_points(heights_m, 3, 0.25), expected)

    def test_quads_are_the_loops(self):
        for samples in (2, 3, 5):
            expected = []
            for j in range(samples - 1):
                for i in range(samples - 1):
                    south, north = j * samples + i, (j + 1) * samples + i
                    expected += [south, south + 1, north + 1, north]
            self.assertSequenceEqual(grid_quads(samples), expected)

    def test_every_face_is_counter_clockwise_from_above_and_one_cell_large(self):
        points = grid_points(array.array("f", [0.0] * 16), 4, 2.0)
        quads = grid_quads(4)
        self.assertEqual(len(quads), 4 * 9)
        for first in range(0, len(quads), 4):
            corners = [points[3 * corner : 3 * corner + 2] for corner in quads[first : first + 4]]
            area_m2 = sum(
                (a[0] * b[1] - b[0] * a[1]) / 2 for a, b in zip(corners, corners[1:] + corners[:1])
            )
            self.assertEqual(area_m2, 4.0)
