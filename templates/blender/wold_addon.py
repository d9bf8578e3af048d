"""A landscape of Wold in a scene of your own, for Blender 3.4.

Install this file (Edit > Preferences > Add-ons > Install...) and enable "Wold landscape". Then
File > Import > Wold landscape (folder) takes the folder "blender" that `wold generate` has written,
and the sidebar of the 3D view (N) has a tab "Wold".

The landscape is made by scene.py of that folder, which is run: import what you trust. Lengths are
metres; x points east, y north, z up. Grass, ground and sky emit what was computed for the
landscape's sun: they hide things and are hidden by them, and the grass takes sunlight from things,
but things cast no shadow on them. The sun lamp is the landscape's sun, for things of your own; it
does not reach them in fog. Cells of grass that the landscape's own camera does not see have not
been written: look from near it.
"""

import importlib.util
import json
import os
import re
import sys

import bpy
from bpy_extras.io_utils import ImportHelper
from mathutils import Vector

bl_info = {
    "name": "Wold landscape",
    "author": "Wold",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Wold landscape; 3D view > Sidebar > Wold",
    "description": "Imports a landscape that ages and picks its weathering degree",
    "category": "Import-Export",
}

MARK = "wold_landscape"  # what this add-on has made carries this property
SUN = "Wold sun"
KINDS = ("objects", "collections", "meshes", "volumes", "materials", "images", "node_groups",
         "worlds", "cameras", "lights")


# Frames -------------------------------------------------------------------------------------


def scene_functions(folder):
    """The module scene.py of an exported folder."""
    path = os.path.join(folder, "scene.py")
    if not os.path.isfile(path):
        raise ValueError(f"{folder} has no scene.py: choose the folder \"blender\" of a landscape")
    spec = importlib.util.spec_from_file_location("wold_scene", path)
    module = importlib.util.module_from_spec(spec)
    writes_bytecode, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    try:
        spec.loader.exec_module(module)  # leaves nothing in the landscape's folder
    finally:
        sys.dont_write_bytecode = writes_bytecode
    return module


def moment(path):
    """Weathering degree and time in seconds of a frame.json."""
    try:
        with open(path, encoding="utf-8") as file:
            frame = json.load(file)
        return frame["weathering"], frame["time_s"]
    except (OSError, ValueError, KeyError) as error:
        raise ValueError(f"cannot read {path}: {error}; run `wold generate` again") from error


def moments(folder):
    """(weathering degree, time in seconds, number) of each frame."""
    data = os.path.join(folder, "data")
    found = []
    for name in sorted(os.listdir(data)) if os.path.isdir(data) else ():
        number = re.fullmatch(r"frame_(\d+)", name)
        path = os.path.join(data, name, "frame.json")
        if number and os.path.isfile(path):
            found.append((*moment(path), int(number.group(1))))
    if not found:
        raise ValueError(f"{data} has no frames: run `wold generate` again")
    return found


def nearest_frame(folder, degree, time_s):
    """The number of the frame nearest in degree, of equally near ones that nearest in time."""
    return min(moments(folder),
               key=lambda moment: (abs(moment[0] - degree), abs(moment[1] - time_s)))[2]


# What is in the scene -----------------------------------------------------------------------


def everything():
    return {thing for kind in KINDS for thing in getattr(bpy.data, kind)}


def remove_landscape():
    bpy.data.batch_remove([thing for thing in everything() if thing.get(MARK)])


def gather(things):
    """Moves new objects from the scene's own collection into one of the landscape's, in their
    order."""
    scene = bpy.context.scene
    home = bpy.data.collections.new("Wold landscape")
    scene.collection.children.link(home)
    for thing in tuple(scene.collection.objects):
        if thing in things:
            scene.collection.objects.unlink(thing)
            home.objects.link(thing)


def add_sun(functions, frame):
    """The landscape's sun: a lamp's strength is the irradiance of what faces it."""
    daylight = frame["daylight"]
    lamp = bpy.data.lights.new(SUN, "SUN")
    lamp.angle = 0.00925  # radians
    sun = functions.add_object(SUN, lamp)
    sun.rotation_euler = Vector(daylight["to_sun"]).to_track_quat("Z", "Y").to_euler()
    brightest = max(*daylight["sun_irradiance"], 1e-9)
    lamp.color = [channel / brightest for channel in daylight["sun_irradiance"]]
    lamp["irradiance"] = brightest


def set_renderer(functions, frame):
    """As scene.py does, but with light that things of one's own take and pass on."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    functions.set_light_transport(frame["samples"])
    scene.cycles.max_bounces = 4
    functions.set_picture(frame, frame["size_px"])


def show(settings, first):
    """Puts the chosen frame in place of the one that is there; on failure that one stays."""
    functions = scene_functions(settings.folder)
    number = nearest_frame(settings.folder, settings.degree, settings.time_s)
    if not first and number == settings.frame:
        return
    frame = functions.Frame(number, settings.folder)
    before = everything()
    world = bpy.context.scene.world
    try:
        functions.add_landscape(frame)
        add_sun(functions, frame)
        if first:
            functions.set_camera(frame)
            set_renderer(functions, frame)
    except Exception:
        bpy.context.scene.world = world
        bpy.data.batch_remove(list(everything() - before))
        raise
    bpy.context.scene.world.cycles.sampling_method = "AUTOMATIC"  # the sky lights things
    new = everything() - before
    remove_landscape()
    gather(new)
    for thing in everything() - before:
        # The camera is the user's from now on.
        if not isinstance(getattr(thing, "data", thing), bpy.types.Camera):
            thing[MARK] = True
    settings.frame = number
    apply_sun(settings)
    apply_detail(settings)


def apply_sun(settings):
    for lamp in bpy.data.lights:
        if lamp.get(MARK):
            lamp.energy = settings.sun * lamp["irradiance"]


def apply_detail(settings):
    """Steps along a ray: at detail 1 as long as scene.py has them."""
    for material in bpy.data.materials:
        if material.get(MARK):
            usual = material.get("wold_step") or material.cycles.volume_step_rate
            material["wold_step"] = usual
            material.cycles.volume_step_rate = usual / settings.detail
    for thing in bpy.data.objects:
        if thing.get(MARK):
            for modifier in thing.modifiers:
                modifier.show_viewport = settings.grass_in_viewport


# What the user sees -------------------------------------------------------------------------


def on_frame(settings, _context):
    if settings.folder:
        try:
            show(settings, first=False)
        except Exception as error:  # of data or of files: there is nobody to catch it
            settings.problem = str(error)
        else:
            settings.problem = ""


class WoldSettings(bpy.types.PropertyGroup):
    folder: bpy.props.StringProperty(name="Folder", subtype="DIR_PATH")
    frame: bpy.props.IntProperty(name="Frame")
    problem: bpy.props.StringProperty()
    degree: bpy.props.FloatProperty(
        name="Weathering degree", min=0, max=1, update=on_frame,
        description="0 is fresh, 1 withered: the nearest frame of the landscape is shown")
    time_s: bpy.props.FloatProperty(
        name="Time", min=0, update=on_frame,
        description="Seconds since the first frame: picks one of frames of the same degree")
    detail: bpy.props.FloatProperty(
        name="Level of detail", min=0.1, max=4, default=1,
        update=lambda settings, _context: apply_detail(settings),
        description="Steps along a ray through the grass; less is faster and coarser")
    grass_in_viewport: bpy.props.BoolProperty(
        name="Grass in the viewport", default=True,
        update=lambda settings, _context: apply_detail(settings))
    sun: bpy.props.FloatProperty(
        name="Sun", min=0, max=10, default=1,
        update=lambda settings, _context: apply_sun(settings),
        description="Strength of the sun on things of your own; 1 is the landscape's")


class ImportWold(bpy.types.Operator, ImportHelper):
    """Imports a landscape: choose the folder "blender" that wold generate has written"""

    bl_idname = "import_scene.wold"
    bl_label = "Import Wold landscape"
    bl_options = {"REGISTER", "UNDO"}
    filename_ext = ""
    use_filter_folder = True
    directory: bpy.props.StringProperty(subtype="DIR_PATH")

    def execute(self, context):
        settings = context.scene.wold
        before = settings.folder
        settings["folder"] = os.path.abspath(self.directory or self.filepath)
        try:
            show(settings, first=True)
        except Exception as error:
            settings["folder"] = before
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        settings.problem = ""
        return {"FINISHED"}


class WoldPanel(bpy.types.Panel):
    bl_idname = "VIEW3D_PT_wold"
    bl_label = "Wold landscape"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Wold"

    def draw(self, context):
        settings = context.scene.wold
        if not settings.folder:
            self.layout.operator(ImportWold.bl_idname)
            return
        self.layout.label(text=f"Frame {settings.frame}")
        for name in ("degree", "time_s", "detail", "grass_in_viewport", "sun"):
            self.layout.prop(settings, name)
        if settings.problem:
            self.layout.label(text=settings.problem, icon="ERROR")


def menu_entry(menu, _context):
    menu.layout.operator(ImportWold.bl_idname, text="Wold landscape (folder)")


CLASSES = (WoldSettings, ImportWold, WoldPanel)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.wold = bpy.props.PointerProperty(type=WoldSettings)
    bpy.types.TOPBAR_MT_file_import.append(menu_entry)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(menu_entry)
    del bpy.types.Scene.wold
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)


if __name__ == "__main__":
    register()
