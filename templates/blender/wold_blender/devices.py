"""The processor or a graphics card."""

from __future__ import annotations

from typing import Any, NamedTuple

import bpy


class DeviceError(Exception):
    """There is no graphics card that this Blender can use."""


class Device(NamedTuple):
    """A graphics card by one of the ways that Cycles has to it: "OPTIX", "CUDA", "HIP", ..."""

    type: str
    name: str


def preferences() -> Any:
    return bpy.context.preferences.addons["cycles"].preferences


def device_types() -> list[str]:
    """What this build of Cycles could use, the fastest first: OptiX is CUDA with ray tracing."""
    types = [entry[0] for entry in preferences().get_device_types(bpy.context)]
    return sorted((t for t in types if t not in ("NONE", "CPU")), key=lambda t: t != "OPTIX")


def found(device_type: str) -> list[Any]:
    """The graphics cards of a type, as entries of Cycles' preferences."""
    chosen = preferences()
    chosen.compute_device_type = device_type
    if hasattr(chosen, "refresh_devices"):
        chosen.refresh_devices()
    else:
        chosen.get_devices()
    return [device for device in chosen.devices if device.type == device_type]


def all_devices() -> list[Device]:
    """Every graphics card, once for each type by which it can be used."""
    listed = [Device(kind, device.name) for kind in device_types() for device in found(kind)]
    preferences().compute_device_type = "NONE"
    return listed


def use_first_card() -> str | None:
    """Switches on every card of the first type that has one. Returns their names, None without."""
    for kind in device_types():
        cards = found(kind)
        if cards:
            for device in preferences().devices:
                device.use = device.type == kind
            return f"{kind}: {', '.join(card.name for card in cards)}"
    preferences().compute_device_type = "NONE"
    return None


def choose_device(scene: Any, device: str) -> str:
    """`device` is "cpu", "gpu" or "auto". Returns what was taken. Throws DeviceError when "gpu" is
    asked for and there is none."""
    cards = None if device == "cpu" else use_first_card()
    if device == "gpu" and cards is None:
        types = ", ".join(device_types()) or "none"
        raise DeviceError(
            "no graphics card was found that this Blender can use (it was built for: "
            f'{types}); install the card\'s driver, or use render.device = "cpu"'
        )
    scene.cycles.device = "GPU" if cards else "CPU"
    return cards or "the processor"
