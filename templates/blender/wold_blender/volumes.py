"""OpenVDB files as Blender's volumes."""

from __future__ import annotations

from typing import Any

import bpy

from .frame_data import DataError, Frame, check_size


def load_volume(frame: Frame, entry: dict[str, Any], name: str, grids: set[str]) -> Any:
    """A volume that has at least the named grids. Blender shows a missing file as nothing and ends
    abruptly on a damaged one, so both are looked for here. Throws DataError."""
    path = frame.path(entry["file"])
    check_size(path, entry["bytes"])
    volume = bpy.data.volumes.new(name)
    volume.filepath = path
    volume.render.space = "WORLD"  # extinction is per metre of the world, whatever the shear
    if not volume.grids.load():
        raise DataError(f"{path} is damaged: {volume.grids.error_message}")
    missing = grids - {grid.name for grid in volume.grids}
    if missing:
        raise DataError(f"{path} has no grid {' and '.join(sorted(missing))}")
    volume.grids.unload()  # the renderer reads it anew
    return volume
