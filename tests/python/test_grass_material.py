"""Where places of a patch lie in the picture of its colours; gen/blender/colour_picture.h."""

import unittest

import stand_in  # noqa: F401
from wold_blender.grass_material import Colours, Kind, PlaceInPicture

SIDE, SLICES, VOXEL_M = 5, 4, 0.01


def place_in_picture(place_m, shift_voxels=0.0):
    """Column and row of pixels from the upper left, and slice."""
    kind = Kind(2.0, None, VOXEL_M, Colours("c.png", 1, SIDE, SLICES, 1.5), 0)
    to_picture = PlaceInPicture.of(kind, shift_voxels)
    x, y, z = (m * s + o for m, s, o in zip(place_m, to_picture.scale, to_picture.offset))
    tile = SIDE + 2
    y += int(z) * to_picture.next_slice
    return x * tile, (1 - y) * tile * SLICES, z


class PlaceInPictureTest(unittest.TestCase):
    def test_the_middle_of_a_voxel_is_that_of_a_pixel(self):
        for column, row, layer in ((0, 0, 0), (4, 2, 1), (1, 4, 0)):
            middle_m = [2 * VOXEL_M * (at + 0.5) for at in (column, row, layer)]
            x, y, z = place_in_picture(middle_m)
            self.assertAlmostEqual(x, 1 + column + 0.5)
            self.assertAlmostEqual(y, (1 + layer) * (SIDE + 2) + 1 + row + 0.5)
            self.assertAlmostEqual(z, 1 + layer)

    def test_the_ground_lies_between_the_first_two_slices(self):
        self.assertAlmostEqual(place_in_picture((0, 0, 0))[2], 0.5)

    def test_volumes_that_are_moved_are_looked_up_where_they_were(self):
        place_m = (0.031, 0.042, 0.025)
        moved_m = [m - 0.5 * VOXEL_M for m in place_m]
        for before, after in zip(place_in_picture(place_m), place_in_picture(moved_m, 0.5)):
            self.assertAlmostEqual(before, after)


if __name__ == "__main__":
    unittest.main()
