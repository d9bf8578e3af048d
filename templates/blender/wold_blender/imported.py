"""The landscape that stands in a user's scene: put there, replaced by another frame, taken away.

What this package has made carries a mark. Nothing else in the scene is touched.
"""

from __future__ import annotations

import math
from typing import Any

import bpy
from mathutils import Vector

from .frame_data import DataError, Frame
from .landscape import add_camera, add_landscape, aim_camera
from .meshes import add_object
from .nodes import LIT
from .render_settings import set_light_transport, set_picture
from .things import things_of
from .things_light import light_by_things, things_group

MARK = "wold_landscape"
OF_THINGS = "wold_things"  # marks what has been made of the user's things, and says of which
SUN = "Wold sun"
KINDS = (
    "objects",
    "collections",
    "meshes",
    "volumes",
    "materials",
    "images",
    "node_groups",
    "worlds",
    "cameras",
    "lights",
)


def everything() -> set[Any]:
    return {thing for kind in KINDS for thing in getattr(bpy.data, kind)}


def marked(kind: str) -> list[Any]:
    return [thing for thing in getattr(bpy.data, kind) if thing.get(MARK)]


def all_marked() -> set[Any]:
    return {thing for kind in KINDS for thing in marked(kind)}


def add_sun(home: Any, frame: Frame) -> None:
    """The landscape's sun: a lamp's strength is the irradiance of what faces it."""
    daylight = frame["daylight"]
    lamp = bpy.data.lights.new(SUN, "SUN")
    lamp.angle = 0.00925  # radians
    sun = add_object(home, SUN, lamp)
    sun.rotation_euler = Vector(daylight["to_sun"]).to_track_quat("Z", "Y").to_euler()
    brightest = max(*daylight["sun_irradiance"], 1e-9)
    lamp.color = [channel / brightest for channel in daylight["sun_irradiance"]]
    lamp["irradiance"] = brightest


def set_renderer(scene: Any, frame: Frame) -> None:
    """As the landscape is rendered alone. Light has bounces here, for things of the user's own."""
    set_light_transport(scene, frame["samples"])
    scene.cycles.max_bounces = 4
    set_picture(scene, frame, frame["size_px"])


def remove(things: set[Any]) -> None:
    """Removes marked things; of pictures those that nothing shows any more."""
    bpy.data.batch_remove([thing for thing in things if not isinstance(thing, bpy.types.Image)])
    bpy.data.batch_remove([picture for picture in marked("images") if picture.users == 0])


def put_in_place(scene: Any, frame: Frame) -> None:
    """The frame's landscape instead of the one that is there. On failure that one stays."""
    before = everything()
    replaced = all_marked()
    world = scene.world
    try:
        home = add_landscape(scene, frame)
        add_sun(home, frame)
    except Exception:
        scene.world = world
        bpy.data.batch_remove(list(everything() - before))
        raise
    scene.world.cycles.sampling_method = "AUTOMATIC"  # the sky lights things
    for thing in everything() - before:
        thing[MARK] = True
    remove(replaced)


def ground_of(graph: Any) -> Any:
    """The terrain as it is evaluated."""
    for thing in marked("objects"):
        if thing.name.startswith("terrain"):
            return thing.evaluated_get(graph)
    raise DataError("the landscape's terrain is missing: import the landscape anew")


def made_of_things() -> list[Any]:
    return [
        thing for kind in ("node_groups", "images") for thing in marked(kind) if OF_THINGS in thing
    ]


def is_read(thing: Any) -> bool:
    """Whether it is a picture of a file of the landscape's: other materials may show it, too."""
    is_picture = isinstance(thing, bpy.types.Image)
    return is_picture and thing.source == "FILE" and not thing.packed_file


def show_things(collection: Any, frame: Frame, graph: Any) -> None:
    """Lets the things of a collection shade grass and ground, and its lamps light them; None: no
    longer. Nothing is traced anew without need."""
    things = things_of(collection, graph) if collection else None
    summary = f"{frame.folder} {things.summary()}" if things else ""
    made = made_of_things()
    if summary == (made[0][OF_THINGS] if made else ""):
        return
    before = everything()
    try:
        group = things_group(things, frame, ground_of(graph)) if things else None
    except Exception:
        bpy.data.batch_remove(list(everything() - before))
        raise
    light_by_things([each for each in marked("materials") if each.get(LIT)], group)
    bpy.data.batch_remove(made)
    for thing in everything() - before:
        thing[MARK] = True
        if not is_read(thing):
            thing[OF_THINGS] = summary


def set_up_view(scene: Any, frame: Frame) -> None:
    """The landscape's camera and picture. Both are the user's from then on."""
    add_camera(scene, frame)
    set_renderer(scene, frame)


def follow_view(scene: Any, before: Frame, now: Frame) -> None:
    """Moves camera and exposure from one frame's to another's. What the user has set otherwise
    stays."""
    if before["camera"] != now["camera"] and is_where(scene.camera, before["camera"]):
        aim_camera(scene.camera, now["camera"])
    if math.isclose(scene.view_settings.exposure, exposure(before), abs_tol=1e-4):
        scene.view_settings.exposure = exposure(now)


def exposure(frame: Frame) -> float:
    return math.log2(frame["exposure_gain"])


def is_where(camera: Any, view: dict[str, Any]) -> bool:
    return camera is not None and (camera.location - Vector(view["eye_m"])).length < 1e-3


def set_sun(factor: float) -> None:
    """The sun lamp's strength; 1 is the landscape's."""
    for lamp in marked("lights"):
        lamp.energy = factor * lamp["irradiance"]


def set_detail(detail: float) -> None:
    """Steps along a ray; at detail 1 as long as the landscape is rendered alone."""
    for material in marked("materials"):
        usual = material.get("wold_step") or material.cycles.volume_step_rate
        material["wold_step"] = usual
        material.cycles.volume_step_rate = usual / detail


def show_grass_in_viewport(shown: bool) -> None:
    for thing in marked("objects"):
        for modifier in thing.modifiers:
            modifier.show_viewport = shown
