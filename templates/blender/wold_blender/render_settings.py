"""How the scene is rendered: straight rays, and sRGB without a film look."""

from __future__ import annotations

import math
from typing import Any

from .differences import (
    leave_no_cache_beside_pictures,
    leave_out_light_tree,
    march_rays_through_volumes,
)
from .frame_data import Frame


def set_light_transport(scene: Any, samples: int) -> None:
    """What is met emits, nothing scatters."""
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples = samples
    cycles.seed = 0
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.max_bounces = 0
    cycles.transparent_max_bounces = 1024  # flakes in a row: beyond, a ray would end in black
    cycles.min_transparent_bounces = cycles.transparent_max_bounces  # no roulette: no specks
    cycles.volume_max_steps = 1024
    cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    march_rays_through_volumes(scene)
    leave_out_light_tree(scene)
    leave_no_cache_beside_pictures(scene)


def set_picture(scene: Any, frame: Frame, size_px: tuple[int, int]) -> None:
    """sRGB of the radiance times the exposure gain. No dates are written into the file. Cycles adds
    its render time all the same: compare pixels, not bytes."""
    scene.render.resolution_x, scene.render.resolution_y = size_px
    scene.render.resolution_percentage = 100
    scene.display_settings.display_device = "sRGB"
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.look = "None"
    scene.view_settings.exposure = math.log2(frame["exposure_gain"])
    scene.view_settings.gamma = 1.0
    scene.render.dither_intensity = 0.0  # it would brighten all by half a step of 8 bits
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "8"
    for name in dir(scene.render):
        if name.startswith("use_stamp_"):
            setattr(scene.render, name, False)


def set_threads(scene: Any, threads: int) -> None:
    """0: all processors."""
    if threads:
        scene.render.threads_mode = "FIXED"
        scene.render.threads = threads
