"""Blender's lines are passed on, and counts of samples become progress."""

import os
import unittest

import stand_in  # noqa: F401
from wold_blender.progress import pass_on


def passed_on(written):
    """What pass_on() makes of these bytes."""
    reading, writing = os.pipe()
    result, stdout = os.pipe()
    os.write(writing, written)
    os.close(writing)
    pass_on(reading, stdout)
    os.close(stdout)
    with os.fdopen(result, "rb") as file:
        return file.read()


class PassOn(unittest.TestCase):
    def test_lines_stay_and_samples_add_a_line_each(self):
        written = (
            b"Blender 3.4.1\n"
            b"Fra:1 Mem:9M | Sample 0/16\n"
            b"Fra:1 Mem:9M | Sample 4/16\n"
            b"Fra:1 Mem:9M | Sample 16/16\n"
            b"Finished\n"
        )
        expected = (
            b"Blender 3.4.1\n"
            b"Fra:1 Mem:9M | Sample 0/16\nwold: progress 0.000\n"
            b"Fra:1 Mem:9M | Sample 4/16\nwold: progress 0.250\n"
            b"Fra:1 Mem:9M | Sample 16/16\nwold: progress 1.000\n"
            b"Finished\n"
        )
        self.assertEqual(passed_on(written), expected)

    def test_bytes_that_are_no_text_end_nothing(self):
        self.assertTrue(passed_on(b"\xff\xfe\nSample 1/2\n").endswith(b"wold: progress 0.500\n"))

    def test_nothing_stays_nothing(self):
        self.assertEqual(passed_on(b""), b"")
