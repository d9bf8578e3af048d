"""Penumbras of a sun that is a disc, by geometry."""

import math
import unittest

import stand_in  # noqa: F401
from wold_blender.shadow_map import NO_THING, largest_blur_m, soft_shadow

SUN_RADIUS = math.radians(0.5331 / 2)  # its mean diameter, as seen
STEP_M = 0.01
ROWS, COLUMNS = 60, 200


def strip(first, last):
    """Whether a pixel is covered: all rows, some columns."""
    return [[first <= column < last for column in range(COLUMNS)] for _ in range(ROWS)]


def shadow(covered, height_m, ground_m=lambda row: 0.0):
    """Of things at one height, before a sun overhead; the ground's height depends on the row."""
    things_m = [[height_m if each else NO_THING for each in row] for row in covered]
    return soft_shadow(things_m, [[ground_m(row)] * COLUMNS for row in range(ROWS)], STEP_M)


class SoftShadowTest(unittest.TestCase):
    def test_on_the_ground_is_sharp(self):
        covered = strip(50, 120)
        hidden, heights_m = shadow(covered, 0.0)
        for row, wanted in zip(hidden, covered):
            for fraction, is_covered in zip(row, wanted):
                self.assertAlmostEqual(fraction, float(is_covered))
        self.assertEqual(heights_m[30][60], 0.0)

    def test_is_half_below_an_edge_and_as_wide_as_the_disc(self):
        """Over the middle row, far from the ends of the map."""
        height_m = 20.0
        hidden = shadow(strip(0, 100), height_m)[0][30]
        self.assertAlmostEqual((hidden[99] + hidden[100]) / 2, 0.5, places=3)
        half_pixels = height_m * math.tan(SUN_RADIUS) * math.sqrt(math.pi) / 2 / STEP_M
        slope = (hidden[97] - hidden[102]) / 5
        self.assertAlmostEqual(slope * 2 * half_pixels, 1.0, delta=0.02)
        beyond = 100 + math.ceil(largest_blur_m(height_m) / STEP_M)
        self.assertAlmostEqual(max(hidden[beyond:]), 0.0)

    def test_of_what_is_smaller_than_the_sun_is_never_whole(self):
        """A square of 4 cm, 20 m up, covers that part of a disc of 18.6 cm."""
        covered = [
            [28 <= row < 32 and 98 <= column < 102 for column in range(COLUMNS)]
            for row in range(ROWS)
        ]
        hidden, _ = shadow(covered, 20.0)
        disc_m2 = math.pi * (20.0 * math.tan(SUN_RADIUS)) ** 2
        self.assertAlmostEqual(hidden[30][100] / (0.04**2 / disc_m2), 1.0, delta=0.01)
        self.assertAlmostEqual(sum(map(sum, hidden)) * STEP_M**2 / 0.04**2, 1.0, delta=0.02)

    def test_knows_how_high_things_are_beside_them_too(self):
        for row in zip(*shadow(strip(80, 120), 5.0)):
            for fraction, height_m in zip(*row):
                if fraction > 0:
                    self.assertAlmostEqual(height_m, 5.0)

    def test_is_sharper_where_the_ground_is_nearer(self):
        hidden, _ = shadow(strip(0, 100), 20.0, lambda row: 0.0 if row < 30 else 18.0)
        low, high = (hidden[row][97] - hidden[row][102] for row in (2, 57))
        self.assertGreater(high, 3 * low)


if __name__ == "__main__":
    unittest.main()
