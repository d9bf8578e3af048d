"""What differs between the versions of Blender that this package runs in, one function for each.

A function that returns a bool is a fact. It asks what the running Blender has. Some facts cannot be
asked for, since they are Cycles' inner workings: a property that came in the same version tells
them. The other functions do what a fact asks for. `DIFFERENCES` says in which versions each fact
holds. tests/blender checks that in the Blender that it runs. tests/python fails when the oldest
supported version no longer needs a fact.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import bpy

Version = tuple[int, int]
OLDEST: Version = (3, 4)  # that is supported


def _has(thing: Any, name: str) -> bool:
    """Whether a thing or a type of Blender has a property."""
    return name in thing.bl_rna.properties


def _cycles_has(kind: Any, name: str) -> bool:
    """Whether Cycles' settings of a type of Blender have a property."""
    return name in kind.bl_rna.properties["cycles"].fixed_type.properties


# Materials and nodes ------------------------------------------------------------------------


def sockets_belong_to_an_interface() -> bool:
    """Since 4.0 node groups list their sockets in `interface`, before in `inputs`, `outputs`."""
    return _has(bpy.types.NodeTree, "interface")


def add_group_socket(tree: Any, name: str, in_out: str, kind: str) -> None:
    """Before 4.0 in another way. `in_out` is "INPUT" or "OUTPUT"."""
    if sockets_belong_to_an_interface():
        tree.interface.new_socket(name, in_out=in_out, socket_type=kind)
    else:
        (tree.inputs if in_out == "INPUT" else tree.outputs).new(kind, name)


def emission_sampling_has_methods() -> bool:
    """Since 3.5 a material is sampled as a light by a method, before or not."""
    return _cycles_has(bpy.types.Material, "emission_sampling")


def leave_out_of_lights(material: Any) -> None:
    """Before 3.5 by another property. Nothing here is lit by anything else."""
    if emission_sampling_has_methods():
        material.cycles.emission_sampling = "NONE"
    else:
        material.cycles.sample_as_light = False


def things_have_nodes_from_the_start() -> bool:
    """Since 5.0 every material and world has nodes; to ask for them is deprecated."""
    return _has(bpy.types.Scene, "compositing_node_group")


def give_nodes(thing: Any) -> Any:
    """The node tree of a material or a world, which before 5.0 has none until it is asked for."""
    if not things_have_nodes_from_the_start():
        thing.use_nodes = True
    return thing.node_tree


# Meshes -------------------------------------------------------------------------------------


def polygons_are_told_where_they_end() -> bool:
    """Before 3.6 a polygon has a start and a length, since then a start alone."""
    return not bpy.types.MeshPolygon.bl_rna.properties["loop_total"].is_readonly


# Volumes ------------------------------------------------------------------------------------


def volumes_are_read_by_nanovdb() -> bool:
    """Since 5.0 Cycles' volumes are NanoVDB's, and it has a second integrator for them."""
    return _cycles_has(bpy.types.Scene, "volume_biased")


def voxel_value_is_at_its_lower_corner() -> bool:
    """Since 5.0 the value of voxel i is at i, before in the middle of the box from i to i + 1."""
    return volumes_are_read_by_nanovdb()


def volume_shift_voxels() -> float:
    """How far volumes are moved along each axis; 0 before 5.0. Exported volumes have their values
    in the middle of the box, and this move brings them there."""
    return 0.5 if voxel_value_is_at_its_lower_corner() else 0.0


def march_rays_through_volumes(scene: Any) -> None:
    """Since 5.0 ray marching is an option. The other integrator is noisy, and builds an octree for
    every instance of a shader that looks at its place."""
    if volumes_are_read_by_nanovdb():
        scene.cycles.volume_biased = True


def attributes_are_looked_up_at_random() -> bool:
    """Since 5.0 one of the eight voxels around a place is taken at random where an attribute goes
    to the emission by linear nodes alone."""
    return volumes_are_read_by_nanovdb()


def homogeneous_volumes_are_declared() -> bool:
    """Before 5.0 Cycles is told that a volume is the same everywhere. It then works the volume out
    at once. Later versions find out by themselves."""
    return _cycles_has(bpy.types.World, "homogeneous_volume")


def declare_homogeneous(thing: Any) -> None:
    """Only before 5.0. `thing` is a world or a material."""
    if homogeneous_volumes_are_declared():
        thing.cycles.homogeneous_volume = True


# Pictures -----------------------------------------------------------------------------------


def pictures_are_cached_beside_themselves() -> bool:
    """Since 5.2 Cycles may write a folder of tiles beside each picture that it reads."""
    return _has(bpy.types.RenderSettings, "use_texture_cache")


def leave_no_cache_beside_pictures(scene: Any) -> None:
    """Only since 5.2. Exported folders stay as they are."""
    if pictures_are_cached_beside_themselves():
        scene.render.use_texture_cache = False
        scene.render.use_auto_generate_texture_cache = False


def lights_are_in_a_tree() -> bool:
    """Since 3.5 Cycles can sort lights into a tree. One sun needs none."""
    return _cycles_has(bpy.types.Scene, "use_light_tree")


def leave_out_light_tree(scene: Any) -> None:
    """Only since 3.5."""
    if lights_are_in_a_tree():
        scene.cycles.use_light_tree = False


# The list -----------------------------------------------------------------------------------


class Difference(NamedTuple):
    """`holds` is true from version `since` on, up to but without version `until`."""

    holds: Callable[[], bool]
    since: Version | None = None
    until: Version | None = None


DIFFERENCES = (
    Difference(sockets_belong_to_an_interface, since=(4, 0)),
    Difference(emission_sampling_has_methods, since=(3, 5)),
    Difference(things_have_nodes_from_the_start, since=(5, 0)),
    Difference(polygons_are_told_where_they_end, until=(3, 6)),
    Difference(volumes_are_read_by_nanovdb, since=(5, 0)),
    Difference(voxel_value_is_at_its_lower_corner, since=(5, 0)),
    Difference(attributes_are_looked_up_at_random, since=(5, 0)),
    Difference(homogeneous_volumes_are_declared, until=(5, 0)),
    Difference(pictures_are_cached_beside_themselves, since=(5, 2)),
    Difference(lights_are_in_a_tree, since=(3, 5)),
)
