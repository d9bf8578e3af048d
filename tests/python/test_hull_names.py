"""Names of volumes by which Cycles moves their hulls least."""

import unittest

import stand_in  # noqa: F401
from wold_blender.hull_names import hash_share, name_of_volume


class HullNames(unittest.TestCase):
    def test_the_hash_is_that_of_lookup3(self):
        """Computed with a C program of lookup3's macro final(a, b, c): hashword() of one word with
        the initial value 13. The word is the name's letters, as digits to the base 37."""
        known = {
            "": 0x9519DC65,
            "a": 0x7DA482F4,
            "00000 0": 0x47B058D8,
            "cloud 7": 0x35886F56,
            "Grüße": 0xC581E600,
        }
        for name, value in known.items():
            self.assertEqual(hash_share(name), value / 0xFFFFFFFF, name)

    def test_the_first_name_below_a_hundredth_is_taken(self):
        """Found by that C program."""
        known = {0: "00000 281", 1: "00001 119", 2: "00002 228", 12345: "12345 37"}
        for number, name in known.items():
            self.assertEqual(name_of_volume(number), name)

    def test_names_are_in_the_order_of_the_numbers(self):
        numbers = [*range(30), 99, 100, 999, 1000, 9999, 10000, 99999]
        names = [name_of_volume(number) for number in numbers]
        self.assertEqual(names, sorted(names))
        self.assertEqual(len(set(names)), len(names))
