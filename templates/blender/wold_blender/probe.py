"""Finds out what this Blender can show, by rendering it.

A build without NanoVDB shows no volumes from 5.0 on, and nothing but a picture tells.
"""

from __future__ import annotations

import os
import platform
import tempfile
from typing import Any

import bpy

from .devices import all_devices
from .differences import volumes_are_read_by_nanovdb
from .landscape import aim_camera
from .meshes import add_object
from .nodes import attribute, constant, end_in, medium, new_material
from .render_settings import set_light_transport

VOXEL_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "probe.vdb")
SIDE_PX = 8
SEEN = 0.25  # of 1, encoded: what is shown is white, what is not is black


def add_voxel(x_m: float) -> None:
    """A cube of one metre that is a grid of constant density."""
    material, nodes = new_material("voxel")
    density = attribute(nodes, "density", "Fac")
    end_in(nodes, "Volume", medium(nodes, density, constant(nodes, (10, 10, 10))))
    volume = bpy.data.volumes.new("voxel")
    volume.filepath = VOXEL_FILE
    volume.materials.append(material)
    add_object(bpy.context.scene.collection, "voxel", volume).location = (x_m - 0.5, -0.5, -0.5)


def add_fog_cube(x_m: float) -> None:
    """A cube of one metre that is filled with a homogeneous medium."""
    material, nodes = new_material("fog")
    one = nodes.add("ShaderNodeValue").outputs["Value"]
    one.default_value = 1.0
    end_in(nodes, "Volume", medium(nodes, one, constant(nodes, (10, 10, 10))))
    bpy.ops.mesh.primitive_cube_add(size=1, location=(x_m, 0, 0))
    bpy.context.object.data.materials.append(material)


def add_camera() -> None:
    """Two metres to the left and two to the right of the middle fill the picture's width."""
    lens = bpy.data.cameras.new("camera")
    camera = add_object(bpy.context.scene.collection, "camera", lens)
    aim_camera(camera, {"eye_m": (0, -4, 0), "target_m": (0, 0, 0), "field_of_view_deg": 53.13})
    bpy.context.scene.camera = camera


def render_pixels() -> list[float]:
    """The picture's four channels, from the lower left."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 2 * SIDE_PX, SIDE_PX
    scene.render.film_transparent = False
    with tempfile.TemporaryDirectory(prefix="wold_probe_") as folder:
        path = os.path.join(folder, "probe.png")
        bpy.ops.render.render()
        bpy.data.images["Render Result"].save_render(path)
        return list(bpy.data.images.load(path).pixels)


def brightness(pixels: list[float], column: int) -> float:
    """Of the pixel in the middle of the rows."""
    return pixels[4 * (SIDE_PX // 2 * 2 * SIDE_PX + column)]


def rendered() -> tuple[bool, bool]:
    """Whether a grid was seen, and whether a homogeneous medium was."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    set_light_transport(bpy.context.scene, samples=1)
    add_voxel(-1.0)
    add_fog_cube(1.0)
    add_camera()
    pixels = render_pixels()
    return brightness(pixels, SIDE_PX // 2) > SEEN, brightness(pixels, SIDE_PX * 3 // 2) > SEEN




def probe() -> dict[str, Any]:
    """What `wold doctor` says of this Blender."""
    volumes, fog = rendered()
    return {
        "version": ".".join(str(part) for part in bpy.app.version),
        "module": bool(getattr(bpy.app, "module", False)),
        "volumes": volumes,
        "fog": fog,
        "nanovdb": volumes if volumes_are_read_by_nanovdb() else None,
        "devices": [device._asdict() for device in all_devices()],
        "threads": os.cpu_count() or 1,
        "python": platform.python_version(),
    }
