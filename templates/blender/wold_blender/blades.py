"""Grass as meshes of blades."""

from __future__ import annotations

from typing import Any

import bpy

from .frame_data import Frame, light_map_of
from .meshes import face_mesh, give_attribute
from .nodes import LIT, attribute, glow, map_outputs, new_material


def blades_material(frame: Frame, light_map: int) -> Any:
    """Vertices carry their radiance in `radiance`, the map `light` of that number tints."""
    material, nodes = new_material("blades")
    light = map_outputs(nodes, frame, frame.light_map("light", light_map))["Color"]
    glow(nodes, nodes.vector_math("MULTIPLY", attribute(nodes, "radiance", "Vector"), light))
    material[LIT] = True
    return material


def blade_mesh(frame: Frame, entry: dict[str, Any], name: str) -> Any:
    file, count = entry["file"], entry["vertices"]
    vertices_m = frame.numbers(file + ".vertices.f32", "f", 3 * count)
    quads = frame.numbers(file + ".quads.i32", "i", 4 * entry["quads"])
    mesh = face_mesh(name, vertices_m, quads)
    give_attribute(mesh, "radiance", "POINT", frame.numbers(file + ".radiance.f32", "f", 3 * count))
    return mesh


def load_blades(frame: Frame) -> Any:
    """The frame's meshes of blades as a collection that is not itself in the scene. Blender orders
    its members by name: an instance's index counts on it."""
    collection = bpy.data.collections.new("blades")
    light_maps = {light_map_of(entry) for entry in frame["blades"]}
    materials = {light_map: blades_material(frame, light_map) for light_map in sorted(light_maps)}
    for number, entry in enumerate(frame["blades"]):
        name = f"blades {number:05d}"
        mesh = blade_mesh(frame, entry, name)
        mesh.materials.append(materials[light_map_of(entry)])
        collection.objects.link(bpy.data.objects.new(name, mesh))
    return collection
