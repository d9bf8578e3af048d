"""Renders a frame of a landscape with Blender, or with a Python that has the package bpy.

    blender -b --python-exit-code 1 -P wold_render.py -- FOLDER 1
    blender -b --python-exit-code 1 -P wold_render.py -- FOLDER 3 --size 1920x1080 --out third.png
    blender -P wold_render.py -- FOLDER 1 --look     opens the scene in the window instead
    python3 wold_render.py -- FOLDER 1
    ... wold_render.py -- --probe                    says what this Blender can show

FOLDER is the folder "blender" that `wold generate` has written. It holds data, and
nothing in it is run. The package wold_blender has to be beside this file, as a folder or as
wold_blender-VERSION.zip.
"""

import glob
import os
import re
import sys


def version_of(archive: str) -> list[int]:
    """The numbers in an archive's name: [0, 10, 2] comes after [0, 9, 0]."""
    return [int(number) for number in re.findall(r"\d+", os.path.basename(archive))]


def package_place() -> str:
    """Where Python finds wold_blender."""
    here = os.path.dirname(os.path.abspath(__file__))
    if os.path.isdir(os.path.join(here, "wold_blender")):
        return here
    archives = glob.glob(os.path.join(glob.escape(here), "wold_blender-*.zip"))
    if not archives:
        sys.exit(f"wold: error {here} has neither wold_blender nor wold_blender-VERSION.zip")
    return max(archives, key=version_of)


def main() -> None:
    sys.dont_write_bytecode = True
    sys.path.insert(0, package_place())
    from wold_blender import headless

    headless.main(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:])


if __name__ == "__main__":
    main()
