"""Clouds that are volumes; the others are in the backdrop."""

from __future__ import annotations

from typing import Any

from mathutils import Vector

from .differences import volume_shift_voxels
from .frame_data import Frame
from .meshes import add_object
from .nodes import EMISSION, end_in, grid_emission, grid_number, medium, new_material
from .volumes import load_volume

STEP_VOXELS = 2.0


def cloud_material() -> Any:
    material, nodes = new_material("cloud")
    material.cycles.volume_step_rate = STEP_VOXELS
    density = grid_number(nodes, "density")
    end_in(nodes, "Volume", medium(nodes, density, grid_emission(nodes)))
    return material


def add_clouds(home: Any, frame: Frame) -> None:
    for number, entry in enumerate(frame["clouds"]):
        volume = load_volume(frame, entry, f"cloud {number}", {"density", *EMISSION})
        if entry.get("is_haze", False):
            volume.render.clipping = 0.0  # what is thinner is left out, and haze is thin
        volume.materials.append(cloud_material())
        shift_m = volume_shift_voxels() * entry["voxel_m"]
        place = Vector(entry["corner_m"]) + Vector((shift_m, shift_m, shift_m))
        add_object(home, volume.name, volume).location = place
