"""One frame's landscape in the current scene.

All light is baked: grass, ground and sky emit what reaches the eye. So there are no lamps and no
bounces, and a few samples per pixel are enough. Lengths are metres; x points east, y north, z up.
"""

from __future__ import annotations

import math
from typing import Any

import bpy
from mathutils import Vector

from .cells import add_grass
from .clouds import add_clouds
from .flakes import add_flakes
from .frame_data import Frame
from .ground import add_terrain
from .meshes import add_object
from .sky import add_backdrop, set_sky


def add_landscape(scene: Any, frame: Frame) -> Any:
    """Everything but the camera, in a collection of its own, which is returned; and the scene's
    world. Throws DataError; what has been made by then stays."""
    home = bpy.data.collections.new("Wold landscape")
    scene.collection.children.link(home)
    add_terrain(home, frame)
    add_grass(home, frame)
    set_sky(scene, frame)
    add_clouds(home, frame)
    add_backdrop(home, frame)
    add_flakes(home, frame)
    return home


def add_camera(scene: Any, frame: Frame) -> Any:
    """The landscape's camera, which becomes the scene's."""
    view = frame["camera"]
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "HORIZONTAL"
    lens.clip_start = 0.01
    lens.clip_end = 1000000.0
    camera = add_object(scene.collection, "camera", lens)
    scene.camera = camera
    aim_camera(camera, view)
    return camera


def aim_camera(camera: Any, view: dict[str, Any]) -> None:
    camera.data.angle = math.radians(view["field_of_view_deg"])
    eye = Vector(view["eye_m"])
    camera.location = eye
    camera.rotation_euler = (Vector(view["target_m"]) - eye).to_track_quat("-Z", "Y").to_euler()
