"""Memory that is given back to the system."""

import unittest
from unittest import mock

import stand_in  # noqa: F401
from wold_blender import memory


class GiveBackFreedBlocks(unittest.TestCase):
    def test_asks_glibc(self):
        program = mock.Mock(spec=["mallopt"])
        with (
            mock.patch.object(memory.sys, "platform", "linux"),
            mock.patch.object(memory.ctypes, "CDLL", return_value=program),
        ):
            memory.give_back_freed_blocks()
        program.mallopt.assert_called_once_with(-3, 262144)

    def test_leaves_other_libraries_alone(self):
        with (
            mock.patch.object(memory.sys, "platform", "linux"),
            mock.patch.object(memory.ctypes, "CDLL", return_value=mock.Mock(spec=[])),
        ):
            memory.give_back_freed_blocks()

    def test_leaves_other_systems_alone(self):
        with (
            mock.patch.object(memory.sys, "platform", "win32"),
            mock.patch.object(memory.ctypes, "CDLL") as library,
        ):
            memory.give_back_freed_blocks()
        library.assert_not_called()


if __name__ == "__main__":
    unittest.main()
