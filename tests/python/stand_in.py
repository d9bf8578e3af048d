"""Lets the package wold_blender be imported without Blender.

Import this module before the package. In the place of Blender's own modules stand mocks, which
take every call. Tests that need more of Blender are in tests/blender.
"""

import pathlib
import sys
import unittest.mock

TEMPLATES = pathlib.Path(__file__).resolve().parents[2] / "templates"

for name in ("bpy", "mathutils"):
    sys.modules[name] = unittest.mock.MagicMock(name=name)
sys.path[:0] = [str(TEMPLATES / "blender"), str(TEMPLATES / "slurm")]
