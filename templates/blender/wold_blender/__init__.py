"""Landscapes of Wold in Blender 3.4 and later.

Blender from 4.2 on takes this package as an extension, earlier ones as an add-on. wold_render.py
renders with it from the command line.
"""

bl_info = {  # for Blender before 4.2; later ones read blender_manifest.toml
    "name": "Wold landscape",
    "author": "Wold",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Wold landscape; 3D view > Sidebar > Wold",
    "description": "Imports a landscape that ages, and lets it follow the timeline",
    "category": "Import-Export",
}


def register() -> None:
    from . import interface

    interface.register()


def unregister() -> None:
    from . import interface

    interface.unregister()
