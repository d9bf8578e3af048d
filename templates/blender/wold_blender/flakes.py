"""Falling snow: textured rectangles."""

from __future__ import annotations

import array
from collections.abc import Sequence
from typing import Any

from .frame_data import Frame
from .meshes import add_object, face_mesh, give_attribute
from .nodes import Nodes, attribute, constant, end_in, mixed, new_material
from .pictures import load_picture


def opacity(nodes: Nodes, frame: Frame, picture: str) -> Any:
    """An output socket: the picture's times the flake's own."""
    image = nodes.add(
        "ShaderNodeTexImage", image=load_picture(frame.path(picture)), extension="CLIP"
    )
    nodes.link(nodes.add("ShaderNodeTexCoord").outputs["UV"], image.inputs["Vector"])
    return nodes.math("MULTIPLY", image.outputs["Color"], attribute(nodes, "opacity", "Fac"))


def flake_material(frame: Frame, picture: str, radiance: Sequence[float]) -> Any:
    """As much of `radiance` as the opacity covers."""
    material, nodes = new_material("flake")
    emission = nodes.add("ShaderNodeEmission")
    nodes.link(constant(nodes, radiance), emission.inputs["Color"])
    behind = nodes.add("ShaderNodeBsdfTransparent").outputs["BSDF"]
    covered = opacity(nodes, frame, picture)
    end_in(nodes, "Surface", mixed(nodes, covered, behind, emission.outputs["Emission"]))
    return material


def add_flakes(home: Any, frame: Frame) -> None:
    """All flakes as one mesh that counts from the eye."""
    flakes = frame["flakes"]
    if flakes is None:
        return
    count = flakes["count"]
    corners_m = frame.numbers(flakes["corners"], "f", 12 * count)
    mesh = face_mesh("flakes", corners_m, array.array("i", range(4 * count)))
    places = array.array("f", (0, 0, 1, 0, 1, 1, 0, 1)) * count
    mesh.uv_layers.new().data.foreach_set("uv", places)
    give_attribute(mesh, "opacity", "FACE", frame.numbers(flakes["opacities"], "f", count))
    for picture in flakes["pictures"]:
        mesh.materials.append(flake_material(frame, picture, flakes["radiance"]))
    mesh.polygons.foreach_set("material_index", frame.numbers(flakes["picks"], "i", count))
    add_object(home, "flakes", mesh).location = frame["camera"]["eye_m"]
