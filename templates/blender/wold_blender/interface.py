"""What the user sees: an import, a tab "Wold" in the sidebar, and a landscape that follows the
timeline.

Grass, ground and sky emit what was computed for the landscape's sun. They hide things and are
hidden by them. Grass takes sunlight from things. Things of one collection, which the user picks,
shade grass and ground, and lamps in it light them. The sun lamp is for things of the user's own. It
does not reach them in fog. Cells of grass that the landscape's own camera does not see have not
been written: look from near it.
"""

# No `from __future__ import annotations` here: annotations would be texts then, and Blender 3.4
# evaluates those of properties in another place, where it does not find their names.

import functools
import os
from typing import Any

import bpy
from bpy.app.handlers import persistent
from bpy_extras.io_utils import ImportHelper

from . import imported
from .frame_data import DataError, Frame, Moment, moments, nearest_in_degree, nearest_in_number


@functools.lru_cache(maxsize=4)
def moments_since(folder: str, _changed_ns: int) -> list[Moment]:
    """A folder's frames, read once for each time that frames have been added or removed."""
    return moments(folder)


def frames_of(folder: str) -> list[Moment]:
    data = os.path.join(folder, "data")
    return moments_since(folder, os.stat(data).st_mtime_ns if os.path.isdir(data) else 0)


def wanted_frame(scene: Any) -> int:
    """The number of the frame that the timeline, or degree and time, pick."""
    settings = scene.wold
    frames = frames_of(settings.folder)
    if settings.picked_by == "TIMELINE":
        first = frames[0].number
        return nearest_in_number(frames, scene.frame_current - settings.start + first)
    return nearest_in_degree(frames, settings.degree, settings.time_s)


def show(scene: Any) -> None:
    """Shows the wanted frame. Does nothing when it is there. Throws DataError."""
    settings = scene.wold
    number = wanted_frame(scene)
    if number == settings.frame:
        return
    frame = Frame(number, settings.folder)
    shown = Frame(settings.frame, settings.folder) if settings.frame else None
    imported.put_in_place(scene, frame)
    if shown:
        imported.follow_view(scene, shown, frame)
    else:
        imported.set_up_view(scene, frame)
    settings.frame = number
    imported.set_sun(settings.sun)
    imported.set_detail(settings.detail)
    imported.show_grass_in_viewport(settings.grass_in_viewport)


def try_to_show(scene: Any) -> None:
    """For Blender's own calls, which nobody catches errors of: the panel says what is wrong."""
    if not scene.wold.folder:
        return
    try:
        show(scene)
    except Exception as error:
        scene.wold.problem = str(error)
    else:
        scene.wold.problem = ""


@persistent  # type: ignore[untyped-decorator]
def follow_timeline(scene: Any, *_graph: Any) -> None:
    if scene.wold.picked_by == "TIMELINE":
        try_to_show(scene)


def show_things(scene: Any, graph: Any) -> None:
    """Brings the shadow and the light of the user's things up to date, if a landscape is shown."""
    settings = scene.wold
    if settings.frame:
        imported.show_things(settings.things, Frame(settings.frame, settings.folder), graph)


@persistent  # type: ignore[untyped-decorator]
def follow_things(scene: Any, graph: Any) -> None:
    """When all of a frame is where it is."""
    try:
        show_things(scene, graph)
    except Exception as error:
        if scene.wold.problem != str(error):  # what is set is an edit, and asks for another try
            scene.wold.problem = str(error)


def light_anew() -> None:
    """What edits wait for."""
    follow_things(bpy.context.scene, bpy.context.evaluated_depsgraph_get())


def may_change_things(update: Any) -> bool:
    """Whether an edit may move, add, take away or hide a thing, or change a lamp."""
    if isinstance(update.id, (bpy.types.Collection, bpy.types.Scene, bpy.types.Light)):
        return True
    return bool(update.is_updated_transform or update.is_updated_geometry)


def forget_edits() -> None:
    if bpy.app.timers.is_registered(light_anew):
        bpy.app.timers.unregister(light_anew)


@persistent  # type: ignore[untyped-decorator]
def on_edit(scene: Any, graph: Any) -> None:
    """Waits until things have stopped moving for a moment: tracing takes half a second."""
    if scene.wold.things and any(map(may_change_things, graph.updates)):
        forget_edits()
        bpy.app.timers.register(light_anew, first_interval=0.3)


def on_pick(settings: Any, _context: Any) -> None:
    try_to_show(settings.id_data)
    light_anew()


def on_degree(settings: Any, context: Any) -> None:
    if settings.picked_by == "DEGREE":
        on_pick(settings, context)
    else:
        settings.picked_by = "DEGREE"  # which shows it


def on_detail(settings: Any, _context: Any) -> None:
    imported.set_detail(settings.detail)


def on_things(_settings: Any, _context: Any) -> None:
    light_anew()


class WoldSettings(bpy.types.PropertyGroup):  # type: ignore[misc]
    folder: bpy.props.StringProperty(name="Folder", subtype="DIR_PATH")
    frame: bpy.props.IntProperty(name="Frame", description="Number of the frame shown; 0: none")
    problem: bpy.props.StringProperty()
    picked_by: bpy.props.EnumProperty(
        name="Frame by",
        items=(
            ("TIMELINE", "Timeline", "Blender's current frame picks the landscape's"),
            ("DEGREE", "Degree", "Weathering degree and time pick the nearest frame"),
        ),
        update=on_pick,
    )
    start: bpy.props.IntProperty(
        name="Start",
        default=1,
        update=on_pick,
        description="Blender's frame at which the landscape's first is shown",
    )
    degree: bpy.props.FloatProperty(
        name="Weathering degree",
        min=0,
        max=1,
        update=on_degree,
        description="0 is fresh, 1 withered: the nearest frame of the landscape is shown",
    )
    time_s: bpy.props.FloatProperty(
        name="Time",
        min=0,
        update=on_degree,
        description="Seconds since the first frame: picks one of frames of the same degree",
    )
    detail: bpy.props.FloatProperty(
        name="Level of detail",
        min=0.1,
        max=4,
        default=1,
        update=on_detail,
        description="Steps along a ray through the grass; less is faster and coarser",
    )
    grass_in_viewport: bpy.props.BoolProperty(
        name="Grass in the viewport",
        default=True,
        update=lambda settings, _: imported.show_grass_in_viewport(settings.grass_in_viewport),
    )
    sun: bpy.props.FloatProperty(
        name="Sun",
        min=0,
        max=10,
        default=1,
        update=lambda settings, _: imported.set_sun(settings.sun),
        description="Strength of the sun on things of your own; 1 is the landscape's",
    )
    things: bpy.props.PointerProperty(
        name="Things",
        type=bpy.types.Collection,
        update=on_things,
        description="What shades grass and ground: all in this collection; its lamps light them",
    )


class ImportWold(bpy.types.Operator, ImportHelper):  # type: ignore[misc]
    """Imports a landscape: choose the folder "blender" that wold generate has written"""

    bl_idname = "import_scene.wold"
    bl_label = "Import Wold landscape"
    bl_options = {"REGISTER", "UNDO"}
    filename_ext = ""
    use_filter_folder = True
    directory: bpy.props.StringProperty(subtype="DIR_PATH")

    def execute(self, context: Any) -> set[str]:
        settings = context.scene.wold
        before = settings.folder, settings.frame
        settings.folder = os.path.abspath(self.directory or self.filepath)
        settings.frame = 0
        try:
            show(context.scene)
        except DataError as error:
            settings.folder, settings.frame = before
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        settings.problem = ""
        light_anew()
        return {"FINISHED"}


class RemoveWold(bpy.types.Operator):  # type: ignore[misc]
    """Takes the landscape out of the scene; the camera stays"""

    bl_idname = "scene.wold_remove"
    bl_label = "Remove landscape"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        imported.remove(imported.all_marked())
        context.scene.wold.folder = ""
        context.scene.wold.frame = 0
        return {"FINISHED"}


class WoldPanel(bpy.types.Panel):  # type: ignore[misc]
    bl_idname = "VIEW3D_PT_wold"
    bl_label = "Wold landscape"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Wold"

    def draw(self, context: Any) -> None:
        settings = context.scene.wold
        if not settings.folder:
            self.layout.operator(ImportWold.bl_idname)
            return
        self.layout.label(text=f"Frame {settings.frame}")
        self.layout.prop(settings, "picked_by", expand=True)
        by_timeline = settings.picked_by == "TIMELINE"
        picks = ("start",) if by_timeline else ("degree", "time_s")
        for name in (*picks, "detail", "grass_in_viewport", "sun", "things"):
            self.layout.prop(settings, name)
        if settings.problem:
            self.layout.label(text=settings.problem, icon="ERROR")
        self.layout.operator(RemoveWold.bl_idname)


def menu_entry(menu: Any, _context: Any) -> None:
    menu.layout.operator(ImportWold.bl_idname, text="Wold landscape (folder)")


HANDLERS = (
    (bpy.app.handlers.frame_change_pre, follow_timeline),
    (bpy.app.handlers.frame_change_post, follow_things),
    (bpy.app.handlers.depsgraph_update_post, on_edit),
)
CLASSES = (WoldSettings, ImportWold, RemoveWold, WoldPanel)


def register() -> None:
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.wold = bpy.props.PointerProperty(type=WoldSettings)
    bpy.types.TOPBAR_MT_file_import.append(menu_entry)
    for calls, call in HANDLERS:
        calls.append(call)


def unregister() -> None:
    forget_edits()
    for calls, call in HANDLERS:
        calls.remove(call)
    bpy.types.TOPBAR_MT_file_import.remove(menu_entry)
    del bpy.types.Scene.wold
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
