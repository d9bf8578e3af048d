"""Run by differences_test.cpp in Blender. Each fact has to hold in the versions
that the list names, and in no other."""

import pathlib
import sys

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "templates" / "blender"))
from wold_blender.differences import DIFFERENCES  # noqa: E402


def expected(difference, version):
    begun = difference.since is None or version >= difference.since
    return begun and (difference.until is None or version < difference.until)


version = tuple(bpy.app.version[:2])
wrong = [
    f"{each.holds.__name__}() is {each.holds()} in {bpy.app.version_string},"
    f" the list says since {each.since}, until {each.until}"
    for each in DIFFERENCES
    if each.holds() != expected(each, version)
]
if wrong:
    sys.exit("\n".join(wrong))
print(f"wold: {len(DIFFERENCES)} differences are right for {bpy.app.version_string}", flush=True)
