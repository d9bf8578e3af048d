"""Pictures of linear light that materials show."""

from __future__ import annotations

from typing import Any

import bpy

from .frame_data import DataError


def load_picture(path: str) -> Any:
    """A picture whose numbers are taken as they are, loaded once. Throws DataError."""
    try:
        picture = bpy.data.images.load(path, check_existing=True)
    except RuntimeError as error:
        raise DataError(f"cannot read {path}: {error}") from error
    picture.colorspace_settings.name = "Non-Color"
    picture.alpha_mode = "CHANNEL_PACKED"  # four numbers, not a colour and how opaque it is
    if min(picture.size) == 0:
        raise DataError(f"{path} is damaged")
    picture.buffers_free()  # which the size was asked of: the renderer reads the file by itself
    return picture
