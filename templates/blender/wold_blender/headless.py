"""Renders one frame from the command line; see wold_render.py."""

from __future__ import annotations

import argparse
import json
import os
import sys

import bpy

from .devices import DeviceError, choose_device
from .frame_data import DataError, Frame
from .landscape import add_camera, add_landscape
from .memory import give_back_freed_blocks
from .probe import probe
from .progress import progress_reported
from .render_settings import set_light_transport, set_picture, set_threads


def parse_size(text: str) -> tuple[int, int]:
    width, height = (int(part) for part in text.lower().split("x"))
    return width, height


def parse_options(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="wold_render.py", description="Renders one frame that `wold generate` has written."
    )
    parser.add_argument("folder", nargs="?", help='the folder "blender" of a landscape')
    parser.add_argument("frame", type=int, nargs="?", default=1)
    parser.add_argument("--out", help="PNG to write; default: frame_0001.png in the current folder")
    parser.add_argument("--size", type=parse_size, metavar="WxH")
    parser.add_argument("--samples", type=int, help="per pixel")
    parser.add_argument("--threads", type=int, default=0, help="0: all")
    parser.add_argument("--device", choices=("cpu", "gpu", "auto"), default="cpu")
    parser.add_argument("--look", action="store_true", help="build the scene, render nothing")
    parser.add_argument("--probe", action="store_true", help="say what this Blender can show")
    options = parser.parse_args(arguments)
    if options.folder is None and not options.probe:
        parser.error("name the folder")
    return options


def build(options: argparse.Namespace) -> None:
    """The frame in an empty scene, ready to be rendered."""
    give_back_freed_blocks()
    frame = Frame(options.frame, options.folder)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    set_light_transport(scene, options.samples or frame["samples"])
    set_picture(scene, frame, options.size or frame["size_px"])
    set_threads(scene, options.threads)
    print(f"wold: renders on {choose_device(scene, options.device)}", flush=True)
    add_landscape(scene, frame)
    add_camera(scene, frame)


def render(path: str) -> None:
    """Writes the picture under a temporary name first, so that `path` is whole or not there."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with progress_reported():
        bpy.ops.render.render()
    folder, name = os.path.split(path)
    temporary = os.path.join(folder, f".{os.getpid()}.{name}")
    bpy.data.images["Render Result"].save_render(temporary)
    os.replace(temporary, path)
    print(f"wold: done {path}", flush=True)


def main(arguments: list[str]) -> None:
    """`arguments` are those of this program, without its name. Ends the process with 1 and a
    sentence on standard error when the frame cannot be rendered."""
    options = parse_options(arguments)
    if options.probe:
        print(f"wold: probe {json.dumps(probe())}", flush=True)
        return
    try:
        build(options)
    except (DataError, DeviceError) as error:
        print(f"wold: error {error}", file=sys.stderr, flush=True)
        sys.exit(1)
    if not options.look:
        render(os.path.abspath(options.out or f"frame_{options.frame:04d}.png"))
