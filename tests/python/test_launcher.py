"""wold_render.py finds the package beside itself."""

import os
import pathlib
import tempfile
import unittest
import unittest.mock

import stand_in  # noqa: F401
import wold_render


class PackagePlace(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="with [brackets] ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        script = str(self.folder / "wold_render.py")
        patch = unittest.mock.patch.object(wold_render, "__file__", script)
        patch.start()
        self.addCleanup(patch.stop)

    def test_the_folder_is_taken_before_an_archive(self):
        (self.folder / "wold_blender").mkdir()
        (self.folder / "wold_blender-0.1.0.zip").touch()
        self.assertEqual(wold_render.package_place(), str(self.folder))

    def test_an_archive_is_taken_without_the_folder(self):
        (self.folder / "another-9.0.0.zip").touch()
        (self.folder / "wold_blender-0.1.0.zip").touch()
        self.assertEqual(wold_render.package_place(), str(self.folder / "wold_blender-0.1.0.zip"))

    def test_of_several_archives_the_newest_version_is_taken(self):
        for version in ("0.9.0", "0.10.0", "0.2.0"):
            (self.folder / f"wold_blender-{version}.zip").touch()
        self.assertEqual(os.path.basename(wold_render.package_place()), "wold_blender-0.10.0.zip")

    def test_without_either_it_says_what_is_missing(self):
        with self.assertRaises(SystemExit) as caught:
            wold_render.package_place()
        self.assertIn(f"{self.folder} has neither wold_blender nor", str(caught.exception.code))
