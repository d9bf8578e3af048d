"""Blender imports a stage as its window does, and renders what is there.

    blender_picture.py STAGE PICTURE

What a stage does not say is set here: surfaces that glow are no lamps, so that Cycles does not look
for light on millions of faces; samples, and colours as they are.
"""

from __future__ import annotations

import sys

import bpy

WIDTH_PX, HEIGHT_PX, SAMPLES = 240, 135, 64


def main() -> None:
    stage, picture = sys.argv[1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("world")  # into which the dome's picture goes
    bpy.ops.wm.usd_import(filepath=stage)
    scene.camera = next(thing for thing in bpy.data.objects if thing.type == "CAMERA")
    for material in bpy.data.materials:
        material.cycles.emission_sampling = "NONE"
    scene.render.engine = "CYCLES"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.view_settings.view_transform = "Standard"
    scene.render.dither_intensity = 0.0
    scene.render.resolution_x, scene.render.resolution_y = WIDTH_PX, HEIGHT_PX
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


main()
