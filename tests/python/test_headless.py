"""The command line of wold_render.py."""

import contextlib
import io
import tempfile
import unittest

import stand_in  # noqa: F401
from wold_blender import headless


def ending(call, *arguments):
    """The exit code and the words on standard error of a call that ends the program."""
    words = io.StringIO()
    try:
        with contextlib.redirect_stderr(words):
            call(*arguments)
    except SystemExit as end:
        return end.code, words.getvalue()
    raise AssertionError("the program went on")


class Options(unittest.TestCase):
    def test_defaults_render_the_first_frame_on_the_processor(self):
        options = headless.parse_options(["moor"])
        self.assertEqual((options.folder, options.frame, options.device), ("moor", 1, "cpu"))
        self.assertEqual((options.size, options.samples, options.out), (None, None, None))
        self.assertEqual((options.threads, options.look, options.probe), (0, False, False))

    def test_every_option_is_taken(self):
        words = "moor 3 --out a.png --size 64x36 --samples 5 --threads 2 --device gpu --look"
        options = headless.parse_options(words.split())
        self.assertEqual((options.frame, options.out, options.size), (3, "a.png", (64, 36)))
        self.assertEqual((options.samples, options.threads), (5, 2))
        self.assertEqual((options.device, options.look), ("gpu", True))

    def test_a_folder_is_needed_but_for_a_probe(self):
        self.assertTrue(headless.parse_options(["--probe"]).probe)
        code, words = ending(headless.parse_options, [])
        self.assertEqual(code, 2)
        self.assertIn("name the folder", words)

    def test_what_is_no_number_or_no_choice_is_refused_by_its_name(self):
        for wrong in ("--samples few", "--threads 1.5", "--device abacus"):
            code, words = ending(headless.parse_options, ["moor", *wrong.split()])
            self.assertEqual(code, 2)
            self.assertIn(f"argument {wrong.split()[0]}", words)
            self.assertIn(wrong.split()[1], words)
        self.assertEqual(ending(headless.parse_options, ["moor", "first"])[0], 2)


class Size(unittest.TestCase):
    def test_width_comes_before_height(self):
        self.assertEqual(headless.parse_size("1920x1080"), (1920, 1080))
        self.assertEqual(headless.parse_size("64X36"), (64, 36))

    def test_other_words_are_refused(self):
        for wrong in ("64", "64x", "x36", "64x36x2", "64*36", "wide x high", ""):
            code, words = ending(headless.parse_options, ["moor", "--size", wrong])
            self.assertEqual(code, 2)
            self.assertIn(f"'{wrong}'", words)
            self.assertIn("--size", words)


class Main(unittest.TestCase):
    def test_a_missing_frame_ends_with_1_and_a_sentence(self):
        with tempfile.TemporaryDirectory() as folder:
            code, words = ending(headless.main, [folder, "4"])
        self.assertEqual(code, 1)
        self.assertRegex(words, r"^wold: error cannot read .*frame_0004/frame.json")
        self.assertEqual(words.count("\n"), 1)
