"""Changes the landscape's light by the user's own things: a shadow before the sun, and lamps.

Grass and ground emit light that was computed without things. So that light is multiplied: where a
thing hides the sun, by what the sky alone would leave of it; and lamps add to it what they send to
a place, over what the landscape sends there. Lamps shine through things.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import bpy
from mathutils import Vector

from .cast_shadow import Beam, shadow_of
from .differences import add_group_socket
from .frame_data import Frame
from .nodes import GAIN, Nodes, constant, map_outputs
from .things import Lamp, Things

GROUP = "Wold things"  # name of the node group, and of the node that shows it
DARKEST = 0.02  # of the light on a place, over that on level and open ground


def along(nodes: Nodes, place: Any, axis: Vector, low: float, high: float) -> Any:
    """An output socket: 0 at the low end of a beam, 1 at its high one."""
    scaled = axis / (high - low)
    there = nodes.add("ShaderNodeVectorMath", operation="DOT_PRODUCT")
    nodes.link(place, there.inputs[0])
    there.inputs[1].default_value = scaled
    return nodes.math("ADD", there.outputs["Value"], -low / (high - low))


def hidden_fraction(nodes: Nodes, place: Any, beam: Beam, picture: Any) -> Any:
    """An output socket: how much of the sun's disc things hide from a place."""
    axes = (beam.side, beam.above, beam.to_sun)
    x, y, toward = (along(nodes, place, *each) for each in zip(axes, beam.low, beam.high))
    spot = nodes.add("ShaderNodeCombineXYZ")
    nodes.link(x, spot.inputs["X"])
    nodes.link(y, spot.inputs["Y"])
    texture = nodes.add("ShaderNodeTexImage", image=picture, extension="CLIP")
    nodes.link(spot.outputs["Vector"], texture.inputs["Vector"])
    parts = nodes.add("ShaderNodeSeparateXYZ")
    nodes.link(texture.outputs["Color"], parts.inputs["Vector"])
    is_behind = nodes.math("LESS_THAN", toward, parts.outputs["Y"])
    return nodes.math("MULTIPLY", parts.outputs["X"], is_behind)


def without_sun(nodes: Nodes, light: Any, frame: Frame) -> Any:
    """An output socket: what the sky leaves of a place's light, which is `light` times that on
    level and open ground. Where neither sun nor much sky reaches, nothing is taken away."""
    level = level_irradiance(frame)
    sky = [s / a for s, a in zip(frame["daylight"]["sky_irradiance"], level)]
    fraction = nodes.vector_math("DIVIDE", constant(nodes, sky), light)
    return nodes.vector_math("MINIMUM", fraction, (1, 1, 1))


def level_irradiance(frame: Frame) -> list[float]:
    """Of level and open ground in sun and sky."""
    daylight = frame["daylight"]
    sine = max(0.0, daylight["to_sun"][2])
    return [
        max(1e-9, sky + sun * sine)
        for sky, sun in zip(daylight["sky_irradiance"], daylight["sun_irradiance"])
    ]


def lamp_irradiance(nodes: Nodes, place: Any, lamp: Lamp) -> Any:
    """An output socket: of leaves that face all ways, a third of it for any direction and the rest
    by the cosine with the vertical."""
    towards = nodes.vector_math("SUBTRACT", constant(nodes, lamp.place), place)
    square = nodes.add("ShaderNodeVectorMath", operation="DOT_PRODUCT")
    nodes.link(towards, square.inputs[0])
    nodes.link(towards, square.inputs[1])
    square_m2 = nodes.math("MAXIMUM", square.outputs["Value"], max(lamp.radius, 0.01) ** 2)
    direction = nodes.vector_math("NORMALIZE", towards)
    parts = nodes.add("ShaderNodeSeparateXYZ")
    nodes.link(direction, parts.inputs["Vector"])
    cosine = nodes.math("MAXIMUM", parts.outputs["Z"], 0.0)
    facing = nodes.math("ADD", nodes.math("MULTIPLY", cosine, 2 / 3), 1 / 3)
    received = nodes.math("DIVIDE", facing, square_m2)
    if lamp.axis:
        received = nodes.math("MULTIPLY", received, in_cone(nodes, direction, lamp.axis, lamp.cone))
    scaled = nodes.add("ShaderNodeVectorMath", operation="SCALE")
    scaled.inputs[0].default_value = lamp.intensity
    nodes.link(received, scaled.inputs["Scale"])
    return scaled.outputs["Vector"]


def in_cone(nodes: Nodes, direction: Any, axis: Vector, cone: tuple[float, float]) -> Any:
    """An output socket: 1 within a spot's cone, 0 outside."""
    cosine = nodes.add("ShaderNodeVectorMath", operation="DOT_PRODUCT")
    nodes.link(direction, cosine.inputs[0])
    cosine.inputs[1].default_value = -axis
    edge = nodes.add("ShaderNodeMapRange", interpolation_type="SMOOTHSTEP")
    nodes.link(cosine.outputs["Value"], edge.inputs["Value"])
    edge.inputs["From Min"].default_value, edge.inputs["From Max"].default_value = cone
    return edge.outputs["Result"]


def of_things(nodes: Nodes, frame: Frame, lamps: list[Lamp], shadow: Any) -> Any:
    """An output socket: what multiplies the landscape's light at the shaded point. `shadow` is a
    beam and its picture, or None. The light is the coarsest map's: tussocks that only finer ones
    show keep their contrast in shadow."""
    place = nodes.add("ShaderNodeNewGeometry").outputs["Position"]
    ground = map_outputs(nodes, frame, frame["light"])["Color"]
    light = nodes.vector_math("MAXIMUM", ground, (DARKEST, DARKEST, DARKEST))
    factor = constant(nodes, (1, 1, 1))
    if shadow:
        lost = nodes.vector_math("SUBTRACT", without_sun(nodes, light, frame), (1, 1, 1))
        hidden = hidden_fraction(nodes, place, *shadow)
        factor = nodes.vector_math("MULTIPLY_ADD", lost, hidden, factor)
    own = nodes.vector_math("MULTIPLY", light, level_irradiance(frame))
    for lamp in lamps:
        share = nodes.vector_math("DIVIDE", lamp_irradiance(nodes, place, lamp), own)
        factor = nodes.vector_math("ADD", factor, share)
    return factor


def node_group(frame: Frame, lamps: list[Lamp], shadow: Any) -> Any:
    """Takes a colour and gives it as the things change it."""
    group = bpy.data.node_groups.new(GROUP, "ShaderNodeTree")
    add_group_socket(group, "Color", "INPUT", "NodeSocketColor")
    add_group_socket(group, "Color", "OUTPUT", "NodeSocketColor")
    nodes = Nodes(group)
    colour = nodes.add("NodeGroupInput").outputs[0]
    changed = nodes.vector_math("MULTIPLY", colour, of_things(nodes, frame, lamps, shadow))
    nodes.link(changed, nodes.add("NodeGroupOutput").inputs[0])
    return group


# In materials ---------------------------------------------------------------------------------


def take_out(material: Any) -> None:
    """Leaves the material as it was made."""
    tree = material.node_tree
    shown = tree.nodes.get(GROUP)
    if shown:
        source = shown.inputs[0].links[0].from_socket
        tree.links.new(source, tree.nodes[GAIN].inputs["Color"])
        tree.nodes.remove(shown)


def put_in(material: Any, group: Any) -> None:
    tree = material.node_tree
    emitted = tree.nodes[GAIN].inputs["Color"]
    shown = tree.nodes.new("ShaderNodeGroup")
    shown.name = GROUP
    shown.node_tree = group
    tree.links.new(emitted.links[0].from_socket, shown.inputs[0])
    tree.links.new(shown.outputs[0], emitted)


def has_sun(frame: Frame) -> bool:
    daylight = frame["daylight"]
    return bool(daylight["to_sun"][2] > 0 and max(daylight["sun_irradiance"]) > 0)


def things_group(things: Things, frame: Frame, ground: Any) -> Any:
    """The node group for things; None where none of them changes the light. `ground` is the terrain
    as it is evaluated."""
    shadow = None
    if len(things.faces.corners) and has_sun(frame):
        shadow = shadow_of(things.faces, Vector(frame["daylight"]["to_sun"]), ground)
    return node_group(frame, things.lamps, shadow) if shadow or things.lamps else None


def light_by_things(materials: Sequence[Any], group: Any) -> None:
    """Lets materials of grass and ground show a node group instead of what they showed of things;
    None: nothing."""
    for material in materials:
        take_out(material)
        if group:
            put_in(material, group)
